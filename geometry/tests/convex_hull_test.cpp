#include "coplanar_triangle.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/surface_measures.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using kernel::RandomStream;

std::vector<Point> on_sphere(std::vector<Point> points) {
    for (Point& point : points)
        point.normalize();
    return points;
}

std::vector<Point> grid_points(std::size_t count, std::uint32_t bound, std::uint64_t seed) {
    RandomStream random(seed);
    std::vector<Point> points;
    while (points.size() < count)
        points.push_back(random_grid_point(random, bound));
    return points;
}

/// All points of a full grid of k^3 cells.
std::vector<Point> full_grid(int k) {
    std::vector<Point> points;
    for (int x = 0; x <= k; ++x) {
        for (int y = 0; y <= k; ++y) {
            for (int z = 0; z <= k; ++z)
                points.emplace_back(x, y, z);
        }
    }
    return points;
}

const Point& at(Points points, Index i) {
    return points[static_cast<std::size_t>(i)];
}

/// Whether x lies in the triangle abc or the segment it collapses to.
bool simplex_contains(const Point& a, const Point& b, const Point& c, const Point& x) {
    if (!are_collinear(a, b, c)) {
        return orientation(a, b, c, x) == Sign::zero && triangle_contains(a, b, c, x);
    }
    const auto between = [&](const Point& p, const Point& q) {
        return are_collinear(p, q, x) &&
               ((p.cwiseMin(q).array() <= x.array()) && (x.array() <= p.cwiseMax(q).array())).all();
    };
    return between(a, b) || between(b, c) || between(a, c);
}

/// By the definitions: on the boundary where a plane through three points supports all and contains
/// the point, and extreme unless in a triangle of other points there.
struct ByDefinition {
    std::vector<HullPosition> positions;
    bool is_flat = true;  ///< no three points span a plane, or one plane holds all

    explicit ByDefinition(Points points) : positions(points.size(), HullPosition::inside) {
        const auto n = static_cast<Index>(points.size());
        for (Index a = 0; a < n; ++a) {
            for (Index b = a + 1; b < n; ++b) {
                for (Index c = b + 1; c < n; ++c)
                    try_plane(points, {a, b, c});
            }
        }
    }

private:
    void try_plane(Points points, const Face& plane) {
        const Point& a = at(points, plane[0]);
        const Point& b = at(points, plane[1]);
        const Point& c = at(points, plane[2]);
        if (are_collinear(a, b, c)) return;
        std::vector<Point> in_plane;
        bool above = false;
        bool below = false;
        for (const Point& x : points) {
            const Sign side = orientation(a, b, c, x);
            above = above || side == Sign::positive;
            below = below || side == Sign::negative;
            if (side == Sign::zero) in_plane.push_back(x);
        }
        is_flat = is_flat && !above && !below;
        if (above && below) return;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (orientation(a, b, c, points[i]) != Sign::zero) continue;
            positions[i] = is_in_triangle_of_others(in_plane, points[i]) ? HullPosition::boundary
                                                                         : HullPosition::extreme;
        }
    }

    static bool is_in_triangle_of_others(std::vector<Point> others, const Point& x) {
        std::erase(others, x);
        for (const Point& a : others) {
            for (const Point& b : others) {
                for (const Point& c : others) {
                    if (simplex_contains(a, b, c, x)) return true;
                }
            }
        }
        return false;
    }
};

/// The certificate: a closed sphere on exactly the extreme points, convex up to flat edges, with no
/// point above any face; and every boundary point on the face it is said to be on.
void expect_is_hull(Points points, const ConvexHull& hull) {
    std::vector<Index> number(points.size(), -1);
    std::vector<Point> corners;
    std::vector<Face> faces = hull.faces;
    ASSERT_TRUE(std::ranges::is_sorted(faces));
    for (Face& face : faces) {
        ASSERT_EQ(face.front(), std::min({face[0], face[1], face[2]}));
        for (Index& v : face) {
            Index& known = number[static_cast<std::size_t>(v)];
            if (known < 0) {
                known = static_cast<Index>(corners.size());
                corners.push_back(at(points, v));
            }
            v = known;
        }
    }
    const Surface surface = make_surface(faces, corners);
    EXPECT_EQ(surface.triangulation().genus(), 0);
    EXPECT_TRUE(is_convex_surface(surface.view(), FlatEdges::admitted));
    const auto extreme = std::ranges::count(hull.positions, HullPosition::extreme);
    const auto copies = std::ranges::count_if(hull.coincident, [&](const auto& pair) {
        return hull.positions[static_cast<std::size_t>(pair[0])] == HullPosition::extreme;
    });
    EXPECT_EQ(static_cast<std::ptrdiff_t>(corners.size()), extreme - copies);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Index f = hull.face_of[i];
        ASSERT_EQ(f >= 0, hull.positions[i] == HullPosition::boundary);
        if (f < 0) continue;
        const auto [a, b, c] = hull.faces[static_cast<std::size_t>(f)];
        EXPECT_TRUE(simplex_contains(at(points, a), at(points, b), at(points, c), points[i]));
    }
    for (const auto& [a, b, c] : hull.faces) {
        for (const Point& x : points) {
            ASSERT_NE(orientation(at(points, a), at(points, b), at(points, c), x), Sign::positive);
        }
    }
}

TEST(ConvexHull, IsAsDefinedOnSmallGrids) {
    int seen = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const auto count = 4 + static_cast<std::size_t>(seed % 11);
        const auto points = grid_points(count, 1 + seed % 2, seed);
        SCOPED_TRACE(seed);
        const ByDefinition expected(points);
        const auto hull = convex_hull(points);
        ASSERT_EQ(static_cast<bool>(hull), !expected.is_flat);
        if (!hull) continue;
        ++seen;
        EXPECT_EQ(hull.value().positions, expected.positions);
        expect_is_hull(points, hull.value());
    }
    EXPECT_GT(seen, 200);
}

TEST(ConvexHull, HasTheFacesWithAllPointsBelow) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto points = on_sphere(random_points(25, seed));
        std::set<Face> expected;
        for (Index a = 0; a < 25; ++a) {
            for (Index b = a + 1; b < 25; ++b) {
                for (Index c = a + 1; c < 25; ++c) {
                    if (c == b) continue;
                    const bool is_face = std::ranges::none_of(points, [&](const Point& x) {
                        return orientation(at(points, a), at(points, b), at(points, c), x) ==
                               Sign::positive;
                    });
                    if (is_face) expected.insert({a, b, c});
                }
            }
        }
        const auto found = convex_hull(points).value().faces;
        EXPECT_EQ(std::set<Face>(found.begin(), found.end()), expected);
    }
}

TEST(ConvexHull, HoldsItsCertificate) {
    for (const auto& points : {random_points(3000, 1), on_sphere(random_points(1500, 2)),
                               grid_points(3000, 5, 3), grid_points(2000, 30, 4), full_grid(8)}) {
        expect_is_hull(points, convex_hull(points).value());
    }
}

TEST(ConvexHull, OfALargeSetHasTheRightNumbers) {
    const auto hull = convex_hull(on_sphere(random_points(100000, 5)));
    EXPECT_EQ(hull.value().faces.size(), 199996U);
    std::vector<Point> rims = on_sphere(random_points(20000, 6));
    for (std::size_t i = 0; i < rims.size(); ++i) {
        rims[i].z() = 0;
        rims[i].normalize();
        rims[i].z() = i % 2 == 0 ? 0 : 1;
    }
    EXPECT_EQ(convex_hull(rims).value().faces.size(), 39996U);
    const auto cube = convex_hull(full_grid(30));
    EXPECT_EQ(cube.value().faces.size(), 12U);
    EXPECT_EQ(std::ranges::count(cube.value().positions, HullPosition::extreme), 8);
    EXPECT_EQ(std::ranges::count(cube.value().positions, HullPosition::inside), 29 * 29 * 29);
}

TEST(ConvexHull, DependsOnTheSetAloneNotOnItsOrder) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        const auto points = seed % 2 == 0 ? random_points(200, seed) : grid_points(60, 3, seed);
        std::vector<Index> order(points.size());
        std::iota(order.begin(), order.end(), Index{0});
        RandomStream(seed).shuffle(std::span(order));
        std::vector<Point> shuffled;
        for (const Index i : order)
            shuffled.push_back(at(points, i));
        const ConvexHull one = convex_hull(points).value();
        const ConvexHull other = convex_hull(shuffled).value();
        const auto volume = [](Points data, const ConvexHull& hull) {
            double sum = 0;
            for (const auto& [a, b, c] : hull.faces)
                sum += at(data, a).dot(at(data, b).cross(at(data, c))) / 6;
            return sum;
        };
        EXPECT_NEAR(volume(points, one), volume(shuffled, other), 1e-12 * volume(points, one));
        EXPECT_EQ(one.faces.size(), other.faces.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            EXPECT_EQ(other.positions[i], one.positions[static_cast<std::size_t>(order[i])]);
        }
    }
}

TEST(ConvexHull, AFacetIsAFanFromItsLowestLabel) {
    // A pyramid over an octagon, its apex last.
    std::vector<Point> points;
    for (const auto& [x, y] :
         {std::pair{2, 1}, {-1, 2}, {-2, -1}, {1, -2}, {1, 2}, {-2, 1}, {-1, -2}, {2, -1}}) {
        points.emplace_back(x, y, 0);
    }
    points.emplace_back(0, 0, 3);
    const auto faces = convex_hull(points).value().faces;
    EXPECT_EQ(std::ranges::count_if(faces, [](const Face& f) { return f[0] == 0 && f[2] != 8; }),
              7);
    EXPECT_EQ(std::ranges::count_if(
                  faces, [](const Face& f) { return f[1] != 8 && f[2] != 8 && f[0] != 0; }),
              0);
}

TEST(ConvexHull, IsTheSameAtAllScales) {
    const auto points = grid_points(80, 2, 9);
    const ConvexHull hull = convex_hull(points).value();
    for (const int exponent : {-1000, -600, 600, 1020}) {
        std::vector<Point> scaled;
        for (const Point& point : points) {
            scaled.emplace_back(std::ldexp(point.x(), exponent), std::ldexp(point.y(), exponent),
                                std::ldexp(point.z(), exponent));
        }
        const ConvexHull other = convex_hull(scaled).value();
        EXPECT_EQ(other.faces, hull.faces) << exponent;
        EXPECT_EQ(other.positions, hull.positions) << exponent;
    }
}

TEST(ConvexHull, RefusesWhatHasNone) {
    const auto fault = [](const std::vector<Point>& points) {
        return convex_hull(points).refusal();
    };
    EXPECT_EQ(fault({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).fault, DataFault::too_few_points);
    EXPECT_EQ(fault({5, Point(1, 2, 3)}).fault, DataFault::collinear_points);
    EXPECT_EQ(fault({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}).fault,
              DataFault::collinear_points);
    EXPECT_EQ(fault({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}, {0, 0, 0}}).fault,
              DataFault::coplanar_points);
    const auto refusal = fault({{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}, {0, 0, 1}});
    EXPECT_EQ(refusal, (DataRefusal{DataFault::not_finite, {2, -1}}));
    EXPECT_NE(message(refusal).find("point 2"), std::string::npos);
}

TEST(ConvexSurface, UsesAllPointsOfTheBoundary) {
    for (const int k : {1, 2, 5}) {
        std::vector<Point> points = full_grid(k);
        std::erase_if(points, [&](const Point& p) { return p.minCoeff() > 0 && p.maxCoeff() < k; });
        const Surface surface = convex_surface(points).value();
        EXPECT_EQ(surface.triangulation().genus(), 0);
        EXPECT_EQ(surface.triangulation().vertex_count(), 6 * k * k + 2);
        EXPECT_TRUE(is_convex_surface(surface.view(), FlatEdges::admitted));
        const SurfaceMeasures measures = measure(surface.view());
        EXPECT_NEAR(measures.volume, k * k * k, 1e-9);
        EXPECT_NEAR(measures.area, 6 * k * k, 1e-9);
        EXPECT_EQ(measures.count(VertexType::convex), 8);
    }
}

TEST(ConvexSurface, OfBoundaryPointsOfRandomHulls) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const auto points = grid_points(40, 2, seed);
        const ConvexHull hull = convex_hull(points).value();
        std::vector<Point> kept;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool is_copy = std::ranges::any_of(hull.coincident, [&](const auto& pair) {
                return pair[0] == static_cast<Index>(i);
            });
            if (!is_copy && hull.positions[i] != HullPosition::inside) kept.push_back(points[i]);
        }
        const Surface surface = convex_surface(kept).value();
        EXPECT_EQ(static_cast<std::size_t>(surface.triangulation().vertex_count()), kept.size());
        EXPECT_EQ(surface.triangulation().genus(), 0);
        EXPECT_TRUE(is_convex_surface(surface.view(), FlatEdges::admitted)) << seed;
    }
}

TEST(ConvexSurface, RefusesInteriorAndCoincidentPoints) {
    std::vector<Point> points = full_grid(2);
    EXPECT_EQ(convex_surface(points).refusal(), (DataRefusal{DataFault::interior_point, {13, -1}}));
    points.erase(points.begin() + 13);
    EXPECT_TRUE(convex_surface(points));
    points.push_back(points[4]);
    EXPECT_EQ(convex_surface(points).refusal(),
              (DataRefusal{DataFault::coincident_points, {4, 26}}));
    EXPECT_THROW((void)convex_surface(points).value(), std::invalid_argument);
}

}  // namespace
}  // namespace tightflip::geometry
