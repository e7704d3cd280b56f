#include "shapes.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/surface_measures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

Index count_edges(const Surface& surface, EdgeShape shape) {
    Index count = 0;
    for (Index e = 0; e < surface.triangulation().edge_count(); ++e)
        count += edge_shape(surface.view(), {e}) == shape ? 1 : 0;
    return count;
}

/// How often the surface winds about a point.
double winding_number(const Surface& surface, const Point& x) {
    double solid_angle = 0;
    const SurfaceView view = surface.view();
    for (const Halfedge h : surface.triangulation().faces()) {
        const Point a = (view.origin(h) - x).normalized();
        const Point b = (view.target(h) - x).normalized();
        const Point c = (view.opposite(h) - x).normalized();
        solid_angle += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    return solid_angle / (4 * std::numbers::pi);
}

bool is_in_general_position(Points points) {
    for (std::size_t a = 0; a < points.size(); ++a) {
        for (std::size_t b = a + 1; b < points.size(); ++b) {
            for (std::size_t c = b + 1; c < points.size(); ++c) {
                for (std::size_t d = c + 1; d < points.size(); ++d) {
                    if (orientation(points[a], points[b], points[c], points[d]) == Sign::zero) {
                        return false;
                    }
                }
            }
        }
    }
    return true;
}

TEST(DataSets, AllHoldGaussBonnet) {
    for (const DataSet& set : all_data_sets()) {
        SCOPED_TRACE(set.name);
        for (const std::uint64_t seed : {0U, 1U, 77U}) {
            const Surface surface = set.make({set.default_vertices, seed});
            EXPECT_EQ(surface.triangulation().vertex_count(), set.default_vertices);
            const SurfaceMeasures measures = measure(surface.view());
            const double expected = 2 * std::numbers::pi * measures.euler_characteristic;
            EXPECT_NEAR(measures.total_curvature, expected, 1e-9);
            EXPECT_GT(measures.volume, 0);
            EXPECT_EQ(measures.count(EdgeShape::folded), 0);
            EXPECT_EQ(measures.count(EdgeShape::degenerate), 0);
            EXPECT_GE(measures.total_absolute_curvature, 4 * std::numbers::pi * (1 - 1e-12));
        }
    }
}

TEST(DataSets, AreFoundByNameAndFollowTheirSeed) {
    std::set<std::string_view> names;
    for (const DataSet& set : all_data_sets()) {
        EXPECT_TRUE(names.insert(set.name).second);
        EXPECT_EQ(find_data_set(set.name), &set);
        EXPECT_FALSE(set.description.empty());
        const Surface one = set.make({set.default_vertices, 5});
        const Surface same = set.make({set.default_vertices, 5});
        EXPECT_EQ(one.triangulation(), same.triangulation());
        EXPECT_TRUE(std::ranges::equal(one.points(), same.points()));
    }
    EXPECT_EQ(find_data_set("dodecahedron"), nullptr);
    for (const std::string_view name : {"random-sphere", "random-ellipsoid", "bumpy-sphere",
                                        "bumpy-torus", "franke", "random-heights"}) {
        const DataSet& set = *find_data_set(name);
        EXPECT_FALSE(std::ranges::equal(set.make({set.default_vertices, 1}).points(),
                                        set.make({set.default_vertices, 2}).points()));
    }
}

TEST(DataSets, SizesOutsideTheRangeAreRefusedWithTheRange) {
    for (const DataSet& set : all_data_sets()) {
        for (const Index vertices : {-1, 0, 3}) {
            try {
                (void)set.make({vertices, 0});
                ADD_FAILURE() << set.name << vertices;
            } catch (const std::invalid_argument& error) {
                EXPECT_NE(std::string(error.what()).find(set.name), std::string::npos);
                EXPECT_NE(std::string(error.what()).find("vertices"), std::string::npos);
            }
        }
    }
    for (const auto& [name, vertices] : {std::pair{"twisted-prism", 10},
                                         {"skewed-cylinder", 7},
                                         {"bumpy-torus", 37},
                                         {"head-cap", 33},
                                         {"cube-grid", 27},
                                         {"schoenhardt-prism", 7}}) {
        EXPECT_THROW((void)find_data_set(name)->make({vertices, 0}), std::invalid_argument) << name;
    }
}

/// Any four of its six vertices hold both ends of one of the three pairs that are not joined, and
/// the segments between these lie outside.
TEST(DataSets, SchoenhardtsPrismHoldsNoTetrahedron) {
    const Surface prism = data_sets::schoenhardt_prism();
    EXPECT_EQ(count_edges(prism, EdgeShape::concave), 3);
    EXPECT_EQ(count_edges(prism, EdgeShape::convex), 9);
    EXPECT_NEAR(winding_number(prism, {0, 0, 0.5}), 1, 1e-9);
    int not_joined = 0;
    std::set<Index> ends;
    for (Index a = 0; a < 6; ++a) {
        for (Index b = a + 1; b < 6; ++b) {
            if (edge_between(prism, a, b).is_valid()) continue;
            ++not_joined;
            ends.insert({a, b});
            for (const double part : {0.01, 0.25, 0.5, 0.75, 0.99}) {
                const Point x = (1 - part) * prism.point({a}) + part * prism.point({b});
                EXPECT_NEAR(winding_number(prism, x), 0, 1e-9);
            }
        }
    }
    EXPECT_EQ(not_joined, 3);
    EXPECT_EQ(ends.size(), 6U);
}

TEST(DataSets, TheTwistedPrismIsNotConvexThoughItsDataAre) {
    for (const Index k : {3, 4, 5, 12}) {
        const Surface prism = data_sets::twisted_prism(k);
        EXPECT_TRUE(is_convex_data(prism.points()));
        EXPECT_FALSE(is_convex_surface(prism.view(), FlatEdges::admitted));
        EXPECT_EQ(count_edges(prism, EdgeShape::concave), 2 * k);
        EXPECT_EQ(count_edges(prism, EdgeShape::flat), 2 * (k - 3));
        EXPECT_EQ(convex_hull(prism.points()).value().faces.size(),
                  static_cast<std::size_t>(6 * k - 4));  // every point is extreme
    }
    const Surface triangular = data_sets::twisted_prism(3);
    EXPECT_TRUE(is_in_general_position(triangular.points()));
}

TEST(DataSets, ConcaveFlipsUntwistTheDoublePrism) {
    Surface prism = data_sets::twisted_prism(3);
    for (bool changed = true; changed;) {
        changed = false;
        for (Index e = 0; e < prism.triangulation().edge_count(); ++e) {
            if (edge_shape(prism.view(), {e}) != EdgeShape::concave) continue;
            changed = static_cast<bool>(prism.triangulation().flip({e})) || changed;
        }
    }
    EXPECT_TRUE(is_convex_surface(prism.view()));
}

/// Area descent by single flips leaves the skewed cylinder's hull.
TEST(DataSets, TheSkewedCylinderIsConvexAndNotOfLeastArea) {
    Surface cylinder = data_sets::skewed_cylinder(12);
    EXPECT_TRUE(is_convex_surface(cylinder.view(), FlatEdges::admitted));
    EXPECT_NEAR(measure(cylinder.view()).volume, 3, 1e-9);  // the area of the 12-gon, height 1
    double area = measure(cylinder.view()).area;
    const double hull_area = area;
    for (bool changed = true; changed;) {
        changed = false;
        for (Index e = 0; e < cylinder.triangulation().edge_count(); ++e) {
            if (!cylinder.triangulation().flip({e})) continue;
            const double after = measure(cylinder.view()).area;
            if (after < area - 1e-9) {
                area = after;
                changed = true;
            } else {
                cylinder.triangulation().unflip({e});
            }
        }
    }
    EXPECT_LT(area, 0.99 * hull_area);
    EXPECT_FALSE(is_convex_surface(cylinder.view(), FlatEdges::admitted));
}

TEST(DataSets, RandomConvexDataAreHullsInGeneralPosition) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        for (const Surface& surface :
             {data_sets::random_sphere(40, seed), data_sets::random_ellipsoid(40, seed)}) {
            EXPECT_TRUE(is_convex_surface(surface.view()));
            EXPECT_TRUE(is_in_general_position(surface.points()));
        }
    }
    const Surface sphere = data_sets::random_sphere(100, 4);
    for (const Point& point : sphere.points())
        EXPECT_NEAR(point.norm(), 1, 1e-15);
}

TEST(DataSets, EllipsoidsAreConvexAndNearlySmooth) {
    const Surface surface = data_sets::ellipsoid(2000);
    EXPECT_TRUE(is_convex_surface(surface.view()));
    EXPECT_NEAR(measure(surface.view()).volume, 4 * std::numbers::pi / 3 * 6, 0.1);
}

TEST(DataSets, BumpySurfacesAreNotConvex) {
    const Surface sphere = data_sets::bumpy_sphere(1000, 1);
    EXPECT_EQ(sphere.triangulation().genus(), 0);
    EXPECT_FALSE(is_convex_data(sphere.points()));
    EXPECT_GT(count_edges(sphere, EdgeShape::concave), 200);
    for (const Halfedge h : sphere.triangulation().faces()) {  // star-shaped
        const SurfaceView view = sphere.view();
        ASSERT_EQ(orientation(view.origin(h), view.target(h), view.opposite(h), Point::Zero()),
                  Sign::negative);
    }
    const Surface torus = data_sets::bumpy_torus(600, 1);
    EXPECT_EQ(torus.triangulation().genus(), 1);
    EXPECT_FALSE(is_convex_data(torus.points()));
    EXPECT_NEAR(winding_number(torus, {2, 0, 0}), 1, 1e-9);
    EXPECT_NEAR(winding_number(torus, {0, 0, 0}), 0, 1e-9);
}

TEST(DataSets, TheHeadCapIsClosedAboveAndBelow) {
    const Surface cap = data_sets::head_cap(320);
    EXPECT_EQ(cap.triangulation().genus(), 0);
    EXPECT_FALSE(is_convex_data(cap.points()));
    EXPECT_NEAR(winding_number(cap, {0, 0, 0.5}), 1, 1e-9);
    EXPECT_NEAR(winding_number(cap, {0, 0, -0.1}), 0, 1e-9);
    EXPECT_EQ(std::ranges::count(cap.points(), 0.0, [](const Point& p) { return p.z(); }), 16);
}

TEST(DataSets, TheCubeGridHasEightCorners) {
    const Surface grid = data_sets::cube_grid(152);
    EXPECT_TRUE(is_convex_data(grid.points()));
    EXPECT_TRUE(is_convex_surface(grid.view(), FlatEdges::admitted));
    EXPECT_EQ(measure(grid.view()).count(VertexType::convex), 8);
    EXPECT_EQ(measure(grid.view()).count(VertexType::flat), 144);
}

TEST(DataSets, FunctionalDataStandOverTheUnitSquare) {
    for (const FunctionalSurface& data :
         {data_sets::franke(300, 2), data_sets::random_heights(300, 2)}) {
        EXPECT_EQ(data.marked.id, 299);
        for (const Point& point : data.surface.points().first(299)) {
            EXPECT_GE(point.minCoeff(), 0);
            EXPECT_LT(point.maxCoeff(), 1.3);
            EXPECT_LT(data.surface.point(data.marked).z(), point.z());
        }
    }
    // Values of Franke's function at points where few of its four terms count.
    const auto value_near = [](double x, double y) {
        const FunctionalSurface data = data_sets::franke(20000, 1);
        const auto points = data.surface.points().first(19999);
        const auto nearest = std::ranges::min_element(
            points, {}, [&](const Point& p) { return std::hypot(p.x() - x, p.y() - y); });
        return nearest->z();
    };
    EXPECT_NEAR(value_near(2.0 / 9, 2.0 / 9), 1.22, 0.03);  // the high peak
    EXPECT_NEAR(value_near(4.0 / 9, 7.0 / 9), 0.05, 0.06);  // the dip
}

}  // namespace
}  // namespace tightflip::geometry
