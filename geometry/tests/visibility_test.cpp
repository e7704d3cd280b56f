#include "shapes.hpp"
#include <tightflip/geometry/visibility.hpp>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

TEST(Visibility, OfTheFacesOfACubeFromPlacesAboutIt) {
    const Surface surface = cube();
    const auto count = [&](const Point& from, Sign side) {
        const auto faces = surface.triangulation().faces();
        return std::ranges::count_if(
            faces, [&](Halfedge h) { return visible_side(surface.view(), h, from) == side; });
    };
    EXPECT_EQ(count({0, 0, 0}, Sign::negative), 12);
    EXPECT_EQ(count({0, 0, 2}, Sign::positive), 2);
    EXPECT_EQ(count({2, 3, 4}, Sign::positive), 6);
    EXPECT_EQ(count({1, 1, 1}, Sign::zero), 6);
    EXPECT_EQ(count({1, 1, 1}, Sign::positive), 0);
    EXPECT_EQ(count({0, 5, 1}, Sign::zero), 2);
    EXPECT_EQ(count({0, 5, 1}, Sign::positive), 2);
}

TEST(Visibility, IsTheSameForEverySideOfAFace) {
    const Surface surface = with_random_points(kernel::families::stacked(20, 1), 2);
    kernel::RandomStream random(9);
    for (const Halfedge h : surface.triangulation().faces()) {
        const Point from = random_point(random);
        for (const Halfedge side : surface.triangulation().face_sides(h)) {
            EXPECT_EQ(visible_side(surface.view(), side, from),
                      visible_side(surface.view(), h, from));
        }
    }
}

}  // namespace
}  // namespace tightflip::geometry
