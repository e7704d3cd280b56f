#include "shapes.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

std::vector<Point> points_of(const Surface& surface) {
    return {surface.points().begin(), surface.points().end()};
}

/// The same surface with its inside out.
Surface mirrored(const Surface& surface) {
    std::vector<Point> points = points_of(surface);
    for (Point& point : points)
        point.x() = -point.x();
    return {surface.triangulation(), std::move(points)};
}

Surface random_hull(Index vertices, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    std::vector<Point> points;
    for (Index i = 0; i < vertices; ++i)
        points.push_back(random_point(random).normalized());
    return convex_surface(points).value();
}

/// Two poles over a rim that winds `turns` times; every edge is convex.
Surface wound_bipyramid(int rim, int turns) {
    std::vector<Point> points{{0, 0, 1}, {0, 0, -1}};
    Faces faces;
    for (int i = 0; i < rim; ++i) {
        const double angle = 2 * std::numbers::pi * turns * i / rim;
        points.emplace_back(std::cos(angle), std::sin(angle), 0);
        const Index a = 2 + i;
        const Index b = 2 + (i + 1) % rim;
        faces.push_back({0, a, b});
        faces.push_back({1, b, a});
    }
    return make_surface(faces, std::move(points));
}

TEST(ConvexData, NamesAPointInside) {
    std::vector<Point> points = points_of(cube());
    EXPECT_TRUE(is_convex_data(points));
    points.emplace_back(1, 0, 0);     // in a facet
    points.emplace_back(1, 1, 0.5);   // in an edge
    points.emplace_back(-1, -1, -1);  // at a corner
    EXPECT_TRUE(is_convex_data(points));
    points.emplace_back(1 - 0x1p-52, 0, 0);
    const DataConvexity convexity = is_convex_data(points);
    EXPECT_FALSE(convexity);
    EXPECT_EQ(convexity.interior_point, 11);
}

TEST(ConvexData, FlatDataAreConvex) {
    EXPECT_TRUE(is_convex_data(std::vector<Point>{}));
    EXPECT_TRUE(is_convex_data(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
    EXPECT_TRUE(
        is_convex_data(std::vector<Point>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {4, 4, 0}}));
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW((void)is_convex_data(std::vector<Point>{{0, 0, infinity}}), std::invalid_argument);
}

TEST(ConvexSurfaceCertificate, AcceptsHulls) {
    EXPECT_TRUE(is_convex_surface(regular_tetrahedron().view()));
    EXPECT_TRUE(is_convex_surface(octahedron().view()));
    EXPECT_TRUE(is_convex_surface(icosahedron().view()));
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        EXPECT_TRUE(is_convex_surface(random_hull(100, seed).view()));
}

TEST(ConvexSurfaceCertificate, AdmitsFlatEdgesWhereAsked) {
    const Surface surface = cube();
    const SurfaceConvexity strict = is_convex_surface(surface.view());
    ASSERT_TRUE(strict.edge.is_valid());
    EXPECT_EQ(edge_shape(surface.view(), strict.edge), EdgeShape::flat);
    EXPECT_TRUE(is_convex_surface(surface.view(), FlatEdges::admitted));
}

TEST(ConvexSurfaceCertificate, RefusesEveryFlipAway) {
    const Surface hull = random_hull(40, 3);
    for (Index e = 0; e < hull.triangulation().edge_count(); ++e) {
        Surface flipped = hull;
        ASSERT_TRUE(flipped.triangulation().flip({e}));
        const SurfaceConvexity convexity = is_convex_surface(flipped.view(), FlatEdges::admitted);
        EXPECT_FALSE(convexity);
        EXPECT_TRUE(convexity.edge.is_valid());
    }
}

TEST(ConvexSurfaceCertificate, RefusesFoldsOnFacets) {
    // The fold of a cube's diagonal twice over: flat edges flipped across a side of the square.
    const Surface surface = cube();
    int accepted = 0;
    for (Index e = 0; e < surface.triangulation().edge_count(); ++e) {
        Surface flipped = surface;
        if (!flipped.triangulation().flip({e})) continue;
        accepted += is_convex_surface(flipped.view(), FlatEdges::admitted) ? 1 : 0;
    }
    EXPECT_EQ(accepted, 6);  // the other diagonal of each square, and nothing else
}

TEST(ConvexSurfaceCertificate, RefusesInsideOut) {
    for (const Surface& surface : {regular_tetrahedron(), octahedron(), cube(), random_hull(30, 4)})
        EXPECT_FALSE(is_convex_surface(mirrored(surface).view(), FlatEdges::admitted));
}

TEST(ConvexSurfaceCertificate, RefusesStarsThatWindTwice) {
    EXPECT_TRUE(is_convex_surface(wound_bipyramid(5, 1).view()));
    for (const int rim : {5, 7, 9}) {
        const Surface surface = wound_bipyramid(rim, 2);
        for (Index e = 0; e < surface.triangulation().edge_count(); ++e)
            ASSERT_EQ(edge_shape(surface.view(), {e}), EdgeShape::convex);
        const SurfaceConvexity convexity = is_convex_surface(surface.view());
        EXPECT_FALSE(convexity);
        EXPECT_LT(convexity.vertex.id, 2);
        EXPECT_FALSE(convexity.edge.is_valid());
    }
    // The rim goes round twice through the same places: a double cover of an octahedron.
    EXPECT_FALSE(is_convex_surface(wound_bipyramid(8, 2).view(), FlatEdges::admitted));
}

TEST(ConvexSurfaceCertificate, RefusesFacesWithoutArea) {
    std::vector<Point> points = points_of(octahedron());
    points[1] = points[3];
    const Surface surface(octahedron().triangulation(), std::move(points));
    EXPECT_FALSE(is_convex_surface(surface.view(), FlatEdges::admitted));
    EXPECT_FALSE(is_convex_surface(with_random_points(kernel::families::book(6), 1).view(),
                                   FlatEdges::admitted));
}

}  // namespace
}  // namespace tightflip::geometry
