#include <tightflip/properties/surface_case.hpp>

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using testing::HasSubstr;

SurfaceCase sample(std::uint32_t grid) {
    return {.flips = {.kind = find_start_kind("random"),
                      .request = {.vertices = 30, .genus = 1, .seed = 4},
                      .picks = {7, 100000}},
            .grid = grid,
            .point_seed = 5};
}

TEST(SurfaceCase, IsTheSameEachTime) {
    const geometry::Surface surface = sample(0).start();
    EXPECT_EQ(surface.triangulation(), sample(0).flips.start());
    ASSERT_EQ(surface.points().size(), 30U);
    const geometry::Surface again = sample(0).start();
    for (Index v = 0; v < 30; ++v) {
        EXPECT_EQ(surface.point({v}), again.point({v}));
        EXPECT_LE(surface.point({v}).cwiseAbs().maxCoeff(), 1);
    }
    EXPECT_EQ(sample(0).script(), (FlipScript{Edge{7}, Edge{100000 % 90}}));
}

TEST(SurfaceCase, HasIntegersOfTheGivenSize) {
    const geometry::Surface surface = sample(2).start();
    std::set<double> seen;
    for (const geometry::Point& point : surface.points())
        seen.insert(point.begin(), point.end());
    EXPECT_EQ(seen, (std::set<double>{-2, -1, 0, 1, 2}));
}

TEST(SurfaceCase, SaysHowItIsMade) {
    EXPECT_THAT(describe(sample(0)), HasSubstr("; points in general position, seed 5"));
    EXPECT_THAT(describe(sample(3)), HasSubstr("; points of integers to 3, seed 5"));
}

}  // namespace
}  // namespace tightflip::properties
