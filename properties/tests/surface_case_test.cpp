#include <tightflip/properties/surface_case.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::Point;
using testing::EndsWith;

SurfaceCase sample(std::string_view kind) {
    return {.flips = {.kind = find_start_kind("random"),
                      .request = {.vertices = 30, .genus = 1, .seed = 4},
                      .picks = {7, 100000}},
            .point_kind = find_point_kind(kind),
            .point_seed = 5};
}

TEST(SurfaceCase, HasTheStartTheScriptAndTheKindsPoints) {
    for (const PointKind& kind : point_kinds()) {
        const geometry::Surface surface = sample(kind.name).start();
        EXPECT_EQ(surface.triangulation(), sample(kind.name).flips.start());
        const std::vector<Point> points(surface.points().begin(), surface.points().end());
        EXPECT_EQ(points, kind.make(30, 5)) << kind.name;
    }
    EXPECT_EQ(sample("grid").script(), (FlipScript{Edge{7}, Edge{100000 % 90}}));
}

TEST(SurfaceCase, TakesGivenPointsAndPutsMissingOnesAtTheOrigin) {
    SurfaceCase given = sample("grid");
    given.points.assign(28, Point(1, 2, 3));
    const geometry::Surface surface = given.start();
    EXPECT_EQ(surface.point({27}), Point(1, 2, 3));
    EXPECT_EQ(surface.point({28}), Point(0, 0, 0));
    EXPECT_EQ(surface.point({29}), Point(0, 0, 0));
    given.points.assign(40, Point(4, 5, 6));
    EXPECT_EQ(given.start().points().size(), 30U);
    EXPECT_EQ(given.start().point({29}), Point(4, 5, 6));
}

TEST(SurfaceCase, WithoutAnythingIsATetrahedronInGeneralPosition) {
    const SurfaceCase plain;
    EXPECT_EQ(plain.start().points().size(), 4U);
    EXPECT_EQ(plain.point_kind->name, "general");
    EXPECT_TRUE(plain.script().empty());
}

TEST(SurfaceCase, SaysHowItIsMade) {
    EXPECT_THAT(describe(sample("general")), EndsWith("; flips 7 10; points general, seed 5"));
    SurfaceCase given;
    given.points = {{0, 0, 0}, {1, 0.1, -2}, {1e-300, 0, 0}};
    EXPECT_THAT(describe(given), EndsWith("; flips none; points 0 0 0, 1 0.10000000000000001 -2, "
                                          "1e-300 0 0, 0 0 0"));
}

}  // namespace
}  // namespace tightflip::properties
