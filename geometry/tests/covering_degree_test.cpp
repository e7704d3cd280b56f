/// \file
/// Covering degrees of known surfaces, and against solid angles, where rays meet many edges.
#include "common_points.hpp"
#include "self_intersecting_shapes.hpp"
#include <tightflip/geometry/covering_degree.hpp>
#include <tightflip/geometry/exact_predicates.hpp>

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

std::optional<Index> degree(const Surface& surface, const Point& x) {
    return covering_degree(surface.view(), x);
}

/// The same points seen in a mirror.
Surface inside_out(const Surface& surface) {
    return moved(surface, Eigen::Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0)));
}

TEST(CoveringDegree, OfKnownSurfaces) {
    const Point centre = Point::Zero();
    for (const Surface& surface : {regular_tetrahedron(), cube(), octahedron(), icosahedron()}) {
        EXPECT_EQ(degree(surface, centre), 1);
        EXPECT_EQ(degree(inside_out(surface), centre), -1);
        for (const Point& far : {Point(9, 0, 0), Point(-9, 0, 0), Point(0, 0, 9)}) {
            EXPECT_EQ(degree(surface, far), 0);
        }
        EXPECT_EQ(degree(surface, surface.points()[0]), std::nullopt);
    }
    EXPECT_EQ(degree(scaled(cube(), 1020), centre), 1);
    EXPECT_EQ(degree(scaled(cube(), -1070), centre), 1);
    EXPECT_EQ(degree(wound_bipyramid(7, 2), centre), 2);
    EXPECT_EQ(degree(wound_bipyramid(11, 3), centre), 3);
    EXPECT_EQ(degree(inside_out(wound_bipyramid(11, 3)), centre), -3);
    const Surface torus = round_torus(12, 12);
    EXPECT_EQ(degree(torus, centre), 0);
    EXPECT_EQ(std::abs(degree(torus, {3, 0, 0}).value_or(9)), 1);
    EXPECT_EQ(degree(torus, {-3, 0, 0}), degree(torus, {0, 3, 0}));
}

TEST(CoveringDegree, OnFacesAndBesideThem) {
    const Surface surface = cube();
    EXPECT_EQ(degree(surface, {1, 0, 0}), std::nullopt);
    EXPECT_EQ(degree(surface, {1, 0.5, 0.25}), std::nullopt);
    EXPECT_EQ(degree(surface, {1, 1, 0.25}), std::nullopt);
    EXPECT_EQ(degree(surface, {std::nextafter(1, 0), 0.5, 0.5}), 1);
    EXPECT_EQ(degree(surface, {std::nextafter(1, 2), 0.5, 0.5}), 0);
    EXPECT_EQ(degree(surface, {-3, 1, 1}), 0);  // rays along edges and through vertices
    EXPECT_EQ(degree(surface, {-3, 1, 0}), 0);
    EXPECT_EQ(degree(surface, {-3, -1, 1}), 0);
}

/// The area that a face covers on the sphere about x, counted positive seen from its inner side
/// (van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983)).
double solid_angle(const Point& a, const Point& b, const Point& c, const Point& x) {
    const Point u = a - x;
    const Point v = b - x;
    const Point w = c - x;
    return 2 * std::atan2(u.dot(v.cross(w)), u.norm() * v.norm() * w.norm() + u.dot(v) * w.norm() +
                                                 v.dot(w) * u.norm() + w.dot(u) * v.norm());
}

TEST(CoveringDegree, AgreesWithSolidAngles) {
    kernel::RandomStream random(61);
    std::map<Index, int> seen;
    int on_surface = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        for (const Triangulation& triangulation : all_families()) {
            const Surface surface =
                with_grid_points(triangulation, seed, static_cast<std::uint32_t>(2 + seed));
            for (int trial = 0; trial < 6; ++trial) {
                const Point x = random_grid_point(random, static_cast<std::uint32_t>(1 + seed));
                double sum = 0;
                bool is_on_surface = false;
                for (const Halfedge h : surface.triangulation().faces()) {
                    const SurfaceView view = surface.view();
                    const Triangle face{view.origin(h), view.target(h), view.opposite(h)};
                    is_on_surface = is_on_surface || !common_points(face, {x, x, x}).empty();
                    sum += solid_angle(face[0], face[1], face[2], x);
                }
                const auto found = degree(surface, x);
                ASSERT_EQ(!found, is_on_surface);
                on_surface += is_on_surface ? 1 : 0;
                if (!found) continue;
                ASSERT_NEAR(*found, sum / (4 * std::numbers::pi), 1e-6);
                ++seen[*found];
            }
        }
    }
    EXPECT_GT(on_surface, 30);
    EXPECT_GT(seen[0], 30);
    EXPECT_GT(seen[1], 10);
    EXPECT_GT(seen[-1], 10);
}

/// A flip changes the degree by one about the points inside its tetrahedron, and nowhere else.
TEST(CoveringDegree, ChangesInTheTetrahedronOfAFlip) {
    kernel::RandomStream random(5);
    Surface surface = with_random_points(kernel::families::random(12, 0, 7), 3);
    int inside_count = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Edge e{static_cast<Index>(
            random.below(static_cast<std::uint32_t>(surface.triangulation().edge_count())))};
        const SurfaceView view = surface.view();
        const Halfedge h = halfedge_of(e);
        const std::array<Point, 4> t{view.origin(h), view.target(h), view.opposite(h),
                                     view.opposite(twin(h))};
        const Point x = random_point(random) * 0.5;
        const Sign outside = orientation(t[0], t[1], t[2], t[3]);
        const bool is_inside = outside != Sign::zero &&
                               orientation(t[0], t[1], t[2], x) == outside &&
                               orientation(t[1], t[0], t[3], x) == outside &&
                               orientation(t[2], t[3], t[0], x) == outside &&
                               orientation(t[3], t[2], t[1], x) == outside;
        const auto before = degree(surface, x);
        if (!surface.triangulation().flip(e)) continue;
        const auto after = degree(surface, x);
        ASSERT_TRUE(before && after);
        // Where d lies above the face abc, the edge is concave and its flip fills the tetrahedron.
        ASSERT_EQ(*after - *before, is_inside ? static_cast<int>(outside) : 0) << trial;
        inside_count += is_inside ? 1 : 0;
    }
    EXPECT_GT(inside_count, 20);
}

}  // namespace
}  // namespace tightflip::geometry
