#include "cone_box.hpp"

#include "shapes.hpp"
#include <tightflip/geometry/triangle_intersection.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

Box box_of(const Triangle& triangle) {
    Box box(triangle[0]);
    box.extend(triangle[1]);
    return box.extend(triangle[2]);
}

ConeBox bound_of(const Triangle& triangle) {
    Box far(triangle[1]);
    far.extend(triangle[2]);
    return {triangle[0], far};
}

TEST(ConeBox, SaysApartOnlyWhatIsApart) {
    kernel::RandomStream random(1);
    int apart = 0;
    int seen_apart = 0;
    for (int i = 0; i < 20000; ++i) {
        // Needles and grids, at every scale, near and far from the origin.
        const double scale = std::ldexp(1.0, static_cast<int>(random.below(2001)) - 1000);
        std::array<Triangle, 2> triangles;
        for (Triangle& triangle : triangles) {
            const Point apex =
                i % 2 == 0 ? random_grid_point(random, 2) : Point(3 * random_point(random));
            const Point far =
                i % 2 == 0 ? random_grid_point(random, 2) : Point(3 * random_point(random));
            const double width = i % 4 < 2 ? 1 : 1e-3;
            triangle = {apex, far, far + width * random_grid_point(random, 1)};
            for (Point& corner : triangle)
                corner *= scale;
        }
        const bool is_apart = !triangles_meet(triangles[0], triangles[1]);
        const bool is_seen = are_separated(bound_of(triangles[0]), bound_of(triangles[1]));
        ASSERT_TRUE(is_apart || !is_seen) << scale;
        const bool is_seen_of_box =
            are_separated(bound_of(triangles[0]), ConeBox::of(box_of(triangles[1])));
        ASSERT_TRUE(is_apart || !is_seen_of_box) << scale;
        apart += is_apart ? 1 : 0;
        seen_apart += is_seen ? 1 : 0;
    }
    EXPECT_GT(apart, 10000);
    EXPECT_GT(seen_apart, 2000);  // the boxes are small beside the way between them, or not
}

TEST(ConeBox, KnowsBoxesAndTheirNeighboursAtOnePoint) {
    Box low(Point(0, 0, 0));
    low.extend(Point(1, 1, 1));
    Box high(Point(2, 2, 2));
    high.extend(Point(3, 3, 3));
    Box touching(Point(1, 1, 1));
    touching.extend(Point(3, 3, 3));
    EXPECT_TRUE(are_separated(ConeBox::of(low), ConeBox::of(high)));
    EXPECT_FALSE(are_separated(ConeBox::of(low), ConeBox::of(low)));
    EXPECT_FALSE(are_separated(ConeBox::of(low), ConeBox::of(touching)));
    // Two needles that cross in the middle, and beside each other.
    const ConeBox needle{{-1, 0, 0}, Box(Point(1, 0, 0))};
    const ConeBox across{{0, -1, 0}, Box(Point(0, 1, 0))};
    const ConeBox above{{0, -1, 1e-6}, Box(Point(0, 1, 1e-6))};
    EXPECT_FALSE(are_separated(needle, across));
    EXPECT_TRUE(are_separated(needle, above));
}

}  // namespace
}  // namespace tightflip::geometry
