#include "surface_face.hpp"

#include "shapes.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

TEST(SurfaceFace, HasTheCornersAndSidesOfTheTable) {
    const Surface surface = with_random_points(kernel::families::random(20, 1, 3), 4);
    const Triangulation& t = surface.triangulation();
    for (Index id = 0; id < t.halfedge_count(); ++id) {
        const Halfedge h{id};
        const SurfaceFace face = SurfaceFace::at(surface.view(), h);
        EXPECT_EQ(face.corners, (std::array{t.origin(h), t.target(h), t.opposite(h)}));
        EXPECT_EQ(face.sides, (std::array{edge_of(h), edge_of(t.next(h)), edge_of(t.previous(h))}));
        EXPECT_EQ(face.triangle[1], surface.point(t.target(h)));
        EXPECT_TRUE(face.has_side(edge_of(h)));
        const auto faces = t.faces();
        EXPECT_TRUE(std::ranges::binary_search(faces, name_of_face(t.table(), h)));
    }
}

/// A face over the edge ab, and another that has a and b as well.
TEST(SurfaceFace, AnEdgeInCommonIsNotTwoCornersInCommon) {
    const Point a(0, 0, 0);
    const Point b(1, 0, 0);
    const SurfaceFace f{
        {Vertex{0}, Vertex{1}, Vertex{2}}, {Edge{0}, Edge{1}, Edge{2}}, {a, b, Point(0, 1, 0)}};
    SurfaceFace g{
        {Vertex{1}, Vertex{0}, Vertex{3}}, {Edge{0}, Edge{3}, Edge{4}}, {b, a, Point(0, 0, 1)}};
    const auto meet = [&] { return meet_beyond_shared(f, g, common_corners(f, g)); };
    EXPECT_EQ(common_corners(f, g).count, 2U);
    EXPECT_EQ(common_corners(f, g).smallest(), Vertex{0});
    EXPECT_FALSE(meet());
    g.sides[0] = Edge{9};  // parallel to the edge of f
    EXPECT_TRUE(meet());
    g.sides[0] = Edge{0};
    g.triangle[2] = {0, -1, 0};  // side by side
    EXPECT_FALSE(meet());
    g.triangle[2] = {0.2, 5, 0};  // folded
    EXPECT_TRUE(meet());
    g.triangle[2] = {7, 0, 0};  // a segment, longer than the edge, but not in f
    EXPECT_FALSE(meet());
    g.sides[0] = Edge{9};
    g.corners[1] = Vertex{4};  // b alone in common, and yet the segment from there to a
    EXPECT_TRUE(meet());
    g.corners = {Vertex{5}, Vertex{6}, Vertex{7}};
    EXPECT_TRUE(meet());
    g.triangle = {Point(0, 0, 1), Point(1, 0, 1), Point(0, 1, 1)};
    EXPECT_FALSE(meet());
}

}  // namespace
}  // namespace tightflip::geometry
