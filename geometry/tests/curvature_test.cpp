#include "allocation_count.hpp"
#include "cone_by_triples.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/curvature.hpp>

#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

constexpr double pi = std::numbers::pi;

VertexCurvature at_vertex(const Surface& surface, Index v) {
    StarMeter meter;
    return meter.measure(surface.view(),
                         surface.triangulation().outgoing()[static_cast<std::size_t>(v)]);
}

std::vector<VertexCurvature> at_all_vertices(const Surface& surface) {
    std::vector<VertexCurvature> result;
    StarMeter meter;
    for (const Halfedge h : surface.triangulation().outgoing()) {
        result.push_back(meter.measure(surface.view(), h));
    }
    return result;
}

/// Two poles over a rim: vertex 0 at the origin has the rim for its link, in order.
Surface star_over(const std::vector<Point>& rim) {
    const auto d = static_cast<Index>(rim.size());
    std::vector<Point> points(rim.size() + 2, Point::Zero());
    std::ranges::copy(rim, points.begin() + 1);
    points.back() = {3, 5, -7};
    if (d == 2) return make_surface({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, points);
    Faces faces;
    for (Index i = 0; i < d; ++i) {
        const Index j = (i + 1) % d;
        faces.push_back({0, i + 1, j + 1});
        faces.push_back({d + 1, j + 1, i + 1});
    }
    return make_surface(faces, points);
}

struct StarCase {
    std::string name;
    std::vector<Point> rim;
    VertexType type;
    double total_angle;
    double positive;
};

void PrintTo(const StarCase& star, std::ostream* out) {
    *out << star.name;
}

class NamedStar : public testing::TestWithParam<StarCase> {};

TEST_P(NamedStar, HasItsTypeAndCurvatures) {
    const auto& [name, rim, type, total_angle, positive] = GetParam();
    for (const double factor : {1.0, 1e-300, 1e300, 1e-320}) {
        for (std::size_t turn = 0; turn < rim.size(); ++turn) {
            std::vector<Point> turned(rim);
            std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn),
                        turned.end());
            for (const bool is_reversed : {false, true}) {
                if (is_reversed) std::ranges::reverse(turned);
                std::vector<Point> points(turned);
                for (Point& point : points)
                    point *= factor;
                const VertexCurvature found = at_vertex(star_over(points), 0);
                if (factor < 1e-310) {  // too coarse a grid for the angles of some
                    EXPECT_FALSE(std::isnan(found.total_angle + found.positive + found.negative));
                    continue;
                }
                EXPECT_EQ(found.type, type) << factor << ' ' << turn;
                EXPECT_NEAR(found.total_angle, total_angle, 1e-13);
                EXPECT_NEAR(found.positive, positive, 1e-13);
                EXPECT_NEAR(found.negative, positive - (2 * pi - total_angle), 1e-13);
            }
        }
    }
}

const double third = std::acos(1.0 / 3);  // between space diagonals of a cube

INSTANTIATE_TEST_SUITE_P(
    Stars, NamedStar,
    testing::Values(
        StarCase{"CornerOfACube",
                 {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                 VertexType::convex,
                 1.5 * pi,
                 pi / 2},
        StarCase{"CornerWithFlatEdges",
                 {{1, 0, 0}, {2, 1, 0}, {1, 3, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {3, 0, 4}},
                 VertexType::convex,
                 1.5 * pi,
                 pi / 2},
        StarCase{"Apex",
                 {{1, 1, -1}, {-1, 1, -1}, {-1, -1, -1}, {1, -1, -1}},
                 VertexType::convex,
                 4 * third,
                 2 * pi - 4 * third},
        StarCase{"EqualDirections",
                 {{1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 4, 0}, {0, 0, 1}, {0, 0, 3}},
                 VertexType::convex,
                 1.5 * pi,
                 pi / 2},
        StarCase{"Plane",
                 {{2, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
                 VertexType::flat,
                 2 * pi,
                 0},
        StarCase{"PlaneByThree", {{2, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, VertexType::flat, 2 * pi, 0},
        StarCase{
            "Ridge", {{1, 0, 0}, {0, 1, -1}, {-1, 0, 0}, {0, -1, -1}}, VertexType::flat, 2 * pi, 0},
        StarCase{"RidgeWithFlatEdges",
                 {{1, 0, 0}, {1, 1, -1}, {-2, 1, -1}, {-1, 0, 0}, {-1, -1, -1}, {1, -2, -2}},
                 VertexType::flat,
                 2 * pi,
                 0},
        StarCase{"OnASideOfAFace", {{1, 0, 0}, {-1, 0, 0}, {0, 1, 1}}, VertexType::flat, 2 * pi, 0},
        StarCase{"PlaneTwice",
                 {{2, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {3, 0, 0}, {-2, 2, 0}, {-2, -2, 0}},
                 VertexType::saddle,
                 4 * pi,
                 0},
        StarCase{"Saddle",
                 {{1, 0, 1}, {0, 1, -1}, {-1, 0, 1}, {0, -1, -1}},
                 VertexType::saddle,
                 4 * (pi - std::acos(0.5)),
                 0},
        StarCase{"CornerTwice",
                 {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}},
                 VertexType::mixed,
                 3 * pi,
                 pi / 2},
        StarCase{"CornerWithADent",
                 {{1, 0, 0}, {0, 1, 0}, {1, 1, 1}, {0, 0, 1}},
                 VertexType::mixed,
                 pi + 2 * std::acos(1 / std::sqrt(3.0)),
                 pi / 2},
        StarCase{"CornerThereAndBack",
                 {{1, 0, 0}, {0, 1, 0}, {1, 2, 0}, {0, 0, 1}},
                 VertexType::mixed,
                 pi + 2 * std::atan(0.5) + std::atan(2.0) - std::atan(0.5) + pi / 2 -
                     std::atan(2.0) - std::atan(0.5) + 0 * pi + (pi / 2 - std::atan(0.5)) -
                     (pi / 2 - 2 * std::atan(0.5)),
                 pi / 2},
        StarCase{
            "FlatWedge", {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 2, 0}}, VertexType::convex, pi, pi},
        StarCase{"Needle", {{1, 1, 1}, {2, 2, 2}, {5, 5, 5}}, VertexType::convex, 0, 2 * pi},
        StarCase{"CoincidentNeighbour",
                 {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}},
                 VertexType::mixed,
                 2 * pi,
                 pi / 2}),
    [](const auto& test) { return test.param.name; });

TEST(Curvature, OfFoldedStars) {
    const Surface book(kernel::families::book(3), {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
    const std::array<double, 3> angles{pi / 2, std::atan2(4, 3), std::atan2(3, 4)};
    for (Index v = 0; v < 3; ++v) {
        const VertexCurvature found = at_vertex(book, v);
        EXPECT_EQ(found.type, VertexType::convex);
        EXPECT_NEAR(found.positive, 2 * pi - 2 * angles.at(static_cast<std::size_t>(v)), 1e-14);
        EXPECT_EQ(found.negative, 0);
    }
    for (Index e = 0; e < 3; ++e) {
        EXPECT_EQ(mean_curvature(book.view(), Edge{e}), pi / 2);
    }
}

/// The cones by all triples of rays; grids give every degenerate kind of star.
TEST(Curvature, AgreesWithConesByTriples) {
    std::array<int, 4> seen{};
    const auto check = [&](const Surface& surface) {
        const std::vector<Halfedge> outgoing = surface.triangulation().outgoing();
        StarMeter meter;
        for (const Halfedge h : outgoing) {
            std::vector<Point> rays;
            const Point apex = surface.view().origin(h);
            for (const Vertex v : surface.triangulation().neighbours(h)) {
                rays.push_back(surface.point(v) - apex);
            }
            const bool coincides =
                std::ranges::any_of(rays, [](const Point& ray) { return ray.isZero(0); });
            if (coincides || rays.size() > 14 || !span_space(rays)) continue;
            double total_angle = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Point u = rays[i].normalized();
                const Point v = rays[(i + 1) % rays.size()].normalized();
                total_angle += 2 * std::atan2((u - v).norm(), (u + v).norm());
            }
            const double circumference = circumference_by_triples(rays);
            const VertexCurvature found = meter.measure(surface.view(), h);
            ASSERT_NEAR(found.total_angle, total_angle, 1e-12);
            ASSERT_NEAR(found.positive, 2 * pi - circumference, 1e-12);
            ASSERT_NEAR(found.negative, total_angle - circumference, 1e-12);
            const bool has_positive = 2 * pi - circumference > 1e-9;
            const bool has_negative = total_angle - circumference > 1e-9;
            const VertexType type = has_positive
                                        ? (has_negative ? VertexType::mixed : VertexType::convex)
                                        : (has_negative ? VertexType::saddle : VertexType::flat);
            ASSERT_EQ(found.type, type);
            ++seen.at(static_cast<std::size_t>(type));
        }
    };
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const Triangulation triangulation = kernel::families::random(12, seed % 2, seed);
        check(with_grid_points(triangulation, seed, 1));
        check(with_grid_points(triangulation, seed, 2));
        check(with_random_points(triangulation, seed));
        check(with_grid_points(kernel::families::stacked(14, seed), seed, 1));
    }
    for (const VertexType type : {VertexType::convex, VertexType::saddle, VertexType::mixed}) {
        EXPECT_GT(seen.at(static_cast<std::size_t>(type)), 5);
    }
}

/// omega+ is the area of the directions in which the vertex is higher than its neighbours.
TEST(Curvature, PositivePartIsTheAreaOfTheDirectionsInWhichTheVertexIsHighest) {
    const Surface surface = with_random_points(kernel::families::stacked(12, 3), 3);
    constexpr int samples = 40000;
    kernel::RandomStream random(9);
    const std::vector<Halfedge> outgoing = surface.triangulation().outgoing();
    std::vector<int> hits(outgoing.size());
    for (int i = 0; i < samples;) {
        const Point up = random_point(random);
        if (up.squaredNorm() > 1) continue;
        ++i;
        for (std::size_t v = 0; v < outgoing.size(); ++v) {
            const auto neighbours = surface.triangulation().neighbours(outgoing[v]);
            hits[v] += std::all_of(neighbours.begin(), neighbours.end(), [&](Vertex w) {
                return up.dot(surface.point(w) - surface.points()[v]) < 0;
            });
        }
    }
    for (std::size_t v = 0; v < outgoing.size(); ++v) {
        const double area = 4 * pi * hits[v] / samples;
        EXPECT_NEAR(at_vertex(surface, static_cast<Index>(v)).positive, area,
                    5 * 4 * pi * 0.5 / std::sqrt(samples));
    }
}

TEST(Curvature, PartsAreNeverNegativeAndDifferByTheDeficit) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        for (const Triangulation& triangulation : all_families()) {
            for (const Surface& surface :
                 {with_random_points(triangulation, seed), with_grid_points(triangulation, seed, 1),
                  with_grid_points(triangulation, seed, 0)}) {
                for (const VertexCurvature& found : at_all_vertices(surface)) {
                    EXPECT_GE(found.positive, 0);
                    EXPECT_GE(found.negative, 0);
                    EXPECT_NEAR(found.positive - found.negative, found.deficit(), 1e-12);
                    EXPECT_GE(found.absolute(), std::abs(found.deficit()) - 1e-12);
                    EXPECT_EQ(found.negative == 0,
                              found.type == VertexType::convex || found.type == VertexType::flat);
                    EXPECT_EQ(found.positive == 0,
                              found.type == VertexType::saddle || found.type == VertexType::flat);
                }
            }
        }
    }
}

TEST(Curvature, AVertexWithANeighbourAtItsPointIsMixedOrSaddle) {
    const Point at_vertex_0(0, 0, 0);
    const auto type_with = [&](const Point& x, const Point& y) {
        const std::vector<Point> points{at_vertex_0, at_vertex_0, x, y};
        return at_vertex({kernel::families::tetrahedron(), points}, 0).type;
    };
    EXPECT_EQ(type_with({1, 0, 0}, {-1, 0, 0}), VertexType::saddle);
    EXPECT_EQ(type_with({1, 0, 0}, {0, 1, 0}), VertexType::mixed);
}

TEST(Curvature, AHubOfHighDegreeIsMeasuredInLittleTime) {
    constexpr Index rim = 100000;
    Triangulation wheel = kernel::families::double_wheel(rim + 2);
    std::vector<Index> place(static_cast<std::size_t>(rim) + 2, -1);
    const std::vector<Halfedge> outgoing = wheel.outgoing();
    const Index hub = wheel.degree(outgoing[0]) == rim ? 0 : wheel.origin(outgoing[0]).id;
    std::vector<Point> points(static_cast<std::size_t>(rim) + 2, Point(0, 0, -9));
    points[static_cast<std::size_t>(hub)] = {0, 0, 1};
    Index i = 0;
    for (const Vertex v : wheel.neighbours(outgoing[static_cast<std::size_t>(hub)])) {
        const double turn = 2 * pi * i++ / rim;
        points[static_cast<std::size_t>(v.id)] = {std::cos(turn), std::sin(turn), 0};
    }
    ASSERT_EQ(i, rim);
    const Surface surface(std::move(wheel), std::move(points));
    const VertexCurvature found = at_vertex(surface, hub);
    EXPECT_EQ(found.type, VertexType::convex);
    EXPECT_NEAR(found.positive, 2 * pi * (1 - std::sqrt(0.5)), 1e-8);
}

TEST(Curvature, MeasuringStarsAllocatesOnlyOnce) {
    const Surface surface = with_random_points(kernel::families::random(60, 0, 4), 4);
    StarMeter meter;
    const std::vector<Halfedge> outgoing = surface.triangulation().outgoing();
    const auto sweep = [&] {
        double sum = 0;
        for (const Halfedge h : outgoing)
            sum += meter.measure(surface.view(), h).absolute();
        return sum;
    };
    const double first = sweep();
    const std::size_t before = bytes_requested();
    const double second = sweep();
    EXPECT_EQ(bytes_requested(), before);
    EXPECT_EQ(first, second);
}

TEST(EdgeCurvature, OfRegularSolids) {
    struct Solid {
        Surface surface;
        double dihedral;
    };
    for (const auto& [surface, dihedral] : {Solid{regular_tetrahedron(), std::acos(1.0 / 3)},
                                            Solid{octahedron(), std::acos(-1.0 / 3)},
                                            Solid{icosahedron(), std::acos(-std::sqrt(5.0) / 3)}}) {
        const Surface inside_out = moved(surface, Eigen::Affine3d(Eigen::Scaling(-1.0)));
        for (const double factor : {1.0, 1e-300, 1e300}) {
            const Surface scaled = moved(surface, Eigen::Affine3d(Eigen::Scaling(factor)));
            for (Index e = 0; e < surface.triangulation().edge_count(); ++e) {
                EXPECT_NEAR(exterior_angle(scaled.view(), Edge{e}), pi - dihedral, 1e-14);
                EXPECT_NEAR(exterior_angle(inside_out.view(), Edge{e}), dihedral - pi, 1e-14);
                EXPECT_NEAR(mean_curvature(scaled.view(), Edge{e}), (pi - dihedral) / 2, 1e-14);
            }
        }
    }
}

TEST(EdgeCurvature, OfNeedles) {
    // Three orthogonal directions that are no axes: at right angles, whichever corner is far away.
    const std::array<Point, 3> axis{Point(1, 2, 2), Point(2, 1, -2), Point(2, -2, 1)};
    for (const double far : {1e4, 1e8, 1e12, 1e16, 1e40, 1e300}) {
        const Point o = Point::Zero();
        const std::array<Point, 3> near{axis};
        const std::array<Hinge, 6> hinges{{{axis[0] * far, o, near[1], near[2]},
                                           {o, axis[0] * far, near[1], near[2]},
                                           {near[0], o, axis[1] * far, near[2]},
                                           {o, near[0], near[1], axis[2] * far},
                                           {near[0], o, axis[1] * far, axis[2] * far},
                                           {axis[0] * far, o, axis[1] * far, near[2]}}};
        for (const Hinge& h : hinges)
            EXPECT_NEAR(std::abs(exterior_angle(h)), pi / 2, 1e-15) << far;
    }
    // One end far from one opposite corner, the other from the other.
    const Point a = axis[0] * 1e12;
    const Point by_a = a + axis[1];
    const Point o = Point::Zero();
    EXPECT_NEAR(std::abs(exterior_angle(Hinge{a, o, by_a, axis[2]})), pi / 2, 1e-15);
    EXPECT_NEAR(std::abs(exterior_angle(Hinge{o, a, by_a, axis[2]})), pi / 2, 1e-15);
}

TEST(EdgeCurvature, OfFlatFoldedAndDegenerateEdges) {
    const auto angle_with = [](const Point& right) {
        const Surface surface = make_surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                                             {{0, 0, 0}, {4, 0, 0}, {1, 2, 0}, right});
        return exterior_angle(surface.view(), edge_between(surface, 0, 1));
    };
    EXPECT_EQ(angle_with({3, -1, 0}), 0);
    EXPECT_EQ(angle_with({3, 1, 0}), pi);
    EXPECT_EQ(angle_with({3, 0, 0}), 0);
    EXPECT_NEAR(angle_with({3, 0, -1}), pi / 2, 1e-15);
    EXPECT_NEAR(angle_with({3, 0, 1}), -pi / 2, 1e-15);
    EXPECT_NEAR(angle_with({3, 1, -1}), 3 * pi / 4, 1e-15);
    EXPECT_NEAR(angle_with({3, 1, 1}), -3 * pi / 4, 1e-15);
}

TEST(EdgeCurvature, LengthsOfAnySize) {
    const Surface surface(kernel::families::book(3),
                          {{0, 0, 0}, {3e300, 4e300, 0}, {0, 0, 5e-320}});
    EXPECT_DOUBLE_EQ(length(surface.view(), edge_between(surface, 0, 1)), 5e300);
    EXPECT_DOUBLE_EQ(length(surface.view(), edge_between(surface, 0, 2)), 5e-320);
}

}  // namespace
}  // namespace tightflip::geometry
