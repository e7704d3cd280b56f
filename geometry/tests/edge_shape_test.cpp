#include "shapes.hpp"
#include <tightflip/geometry/edge_shape.hpp>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

/// How many edges have each shape, in the order of the enumeration.
std::array<int, 5> census(const Surface& surface) {
    std::array<int, 5> counts{};
    for (Index e = 0; e < surface.triangulation().edge_count(); ++e) {
        ++counts.at(static_cast<std::size_t>(edge_shape(surface.view(), Edge{e})));
    }
    return counts;
}
using Census = std::array<int, 5>;  // convex, concave, flat, folded, degenerate

Surface mirrored(const Surface& surface) {
    return moved(surface, Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, -1.0)));
}

TEST(EdgeShape, ConvexOnATetrahedronAndConcaveOnItsMirrorImage) {
    EXPECT_EQ(census(regular_tetrahedron()), (Census{6, 0, 0, 0, 0}));
    EXPECT_EQ(census(mirrored(regular_tetrahedron())), (Census{0, 6, 0, 0, 0}));
}

TEST(EdgeShape, FlatOnTheDiagonalsOfACube) {
    const Surface surface = cube();
    EXPECT_EQ(census(surface), (Census{12, 0, 6, 0, 0}));
    EXPECT_EQ(edge_shape(surface.view(), edge_between(surface, 0, 3)), EdgeShape::flat);
    EXPECT_EQ(edge_shape(surface.view(), edge_between(surface, 0, 1)), EdgeShape::convex);
}

TEST(EdgeShape, FoldedAtVerticesOfDegreeTwo) {
    EXPECT_EQ(census(with_random_points(kernel::families::book(3), 8)), (Census{0, 0, 0, 3, 0}));
    const Surface surface = with_random_points(kernel::families::book(9), 9);
    const Triangulation& t = surface.triangulation();
    for (Index e = 0; e < t.edge_count(); ++e) {
        const Halfedge h = halfedge_of(Edge{e});
        const bool at_degree_two = t.degree(h) == 2 || t.degree(twin(h)) == 2;
        EXPECT_EQ(edge_shape(surface.view(), Edge{e}) == EdgeShape::folded, at_degree_two);
    }
}

/// A tetrahedron with three corners and the last point as given: its edge 01 has the faces 012 and
/// 031, so that the last point is the corner opposite.
EdgeShape shape_with(const Point& last) {
    const Surface surface = make_surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                                         {{0, 0, 0}, {4, 0, 0}, {1, 2, 0}, last});
    return edge_shape(surface.view(), edge_between(surface, 0, 1));
}

TEST(EdgeShape, DependsOnTheSideOfThePlaneAndOfTheLine) {
    EXPECT_EQ(shape_with({1, -1, -1e-300}), EdgeShape::convex);
    EXPECT_EQ(shape_with({1, -1, 1e-300}), EdgeShape::concave);
    EXPECT_EQ(shape_with({1, 1, -1}), EdgeShape::convex);
    EXPECT_EQ(shape_with({1, -1, 0}), EdgeShape::flat);
    EXPECT_EQ(shape_with({1, 1, 0}), EdgeShape::folded);
    EXPECT_EQ(shape_with({1, 2, 0}), EdgeShape::folded);
    EXPECT_EQ(shape_with({2, 0, 0}), EdgeShape::degenerate);
    EXPECT_EQ(shape_with({9, 0, 0}), EdgeShape::degenerate);
    EXPECT_EQ(shape_with({0, 0, 0}), EdgeShape::degenerate);
}

TEST(EdgeShape, DegenerateWhereBothFacesLieOnLinesOrPointsCoincide) {
    const std::vector<Point> on_a_line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}};
    EXPECT_EQ(census(Surface(kernel::families::tetrahedron(), on_a_line)), (Census{0, 0, 0, 0, 6}));
    EXPECT_EQ(census(Surface(kernel::families::tetrahedron(), std::vector<Point>(4, {1, 2, 3}))),
              (Census{0, 0, 0, 0, 6}));
}

TEST(EdgeShape, AFlipExchangesConvexAndConcaveInGeneralPosition) {
    int flips = 0;
    for (const Triangulation& triangulation : all_families()) {
        Surface surface = with_random_points(triangulation, 31);
        for (Index id = 0; id < triangulation.edge_count(); ++id) {
            const EdgeShape before = edge_shape(surface.view(), Edge{id});
            if (!surface.triangulation().flip(Edge{id})) {
                EXPECT_EQ(before,
                          EdgeShape::folded);  // the opposite corners are one vertex
                continue;
            }
            const EdgeShape after = edge_shape(surface.view(), Edge{id});
            EXPECT_EQ(after, before == EdgeShape::convex ? EdgeShape::concave : EdgeShape::convex);
            EXPECT_TRUE(before == EdgeShape::convex || before == EdgeShape::concave);
            ++flips;
        }
    }
    EXPECT_GT(flips, 500);
}

TEST(EdgeShape, IsTheSameFromBothSidesOfTheEdge) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Surface surface = with_grid_points(kernel::families::random(12, 0, seed), seed, 1);
        Triangulation& t = surface.triangulation();
        for (Index e = 0; e < t.edge_count(); ++e) {
            const EdgeShape before = edge_shape(surface.view(), Edge{e});
            if (!t.flip(Edge{e})) continue;
            ASSERT_TRUE(t.flip(Edge{e}));  // twice: the same surface, the halfedges exchanged
            EXPECT_EQ(edge_shape(surface.view(), Edge{e}), before);
        }
    }
}

}  // namespace
}  // namespace tightflip::geometry
