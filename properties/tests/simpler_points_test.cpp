#include <tightflip/properties/point_kinds.hpp>
#include <tightflip/properties/simpler_points.hpp>

#include <algorithm>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::Point;
using Points = std::vector<Point>;

/// What a test framework does: the first simpler points that still fail, again and again.
Points shrunk(Points points, const std::function<bool(const Points&)>& fails) {
    for (int step = 0;; ++step) {
        EXPECT_LT(step, 100'000);
        const auto simpler = simpler_points(points);
        const auto next = std::ranges::find_if(simpler, fails);
        if (next == simpler.end()) return points;
        points = *next;
    }
}

TEST(SimplerPoints, AreAsManyAndNeverTheSame) {
    for (const PointKind& kind : point_kinds()) {
        const Points points = kind.make(6, 2);
        for (const Points& simpler : simpler_points(points)) {
            ASSERT_EQ(simpler.size(), 6U);
            EXPECT_NE(simpler, points);
            for (const Point& point : simpler)
                EXPECT_TRUE(point.allFinite());
        }
    }
}

TEST(SimplerPoints, BeginWithGreatStepsForAllThenForEach) {
    const Points points{{1, 0, 0}, {1, 2, 3}};
    const auto simpler = simpler_points(points);
    EXPECT_EQ(simpler.front(), Points(2, Point::Zero()));
    for (const Points& expected : {Points{{0, 0, 0}, {0, 1, 1}}, Points{{0, 0, 0}, {1, 2, 3}},
                                   Points{{1, 0, 0}, {0, 0, 0}}, Points{{1, 0, 0}, {1, 0, 0}},
                                   Points{{1, 0, 0}, {1, 2, 1}}, Points{{1, 0, 0}, {1, 2, 2}}}) {
        EXPECT_THAT(simpler, ::testing::Contains(expected));
    }
}

TEST(SimplerPoints, OfTheOriginAreNone) {
    EXPECT_TRUE(simpler_points(Points(5, Point::Zero())).empty());
    EXPECT_TRUE(simpler_points(Points{}).empty());
}

TEST(SimplerPoints, LeadToTheOriginWhereAnythingFails) {
    for (const PointKind& kind : point_kinds()) {
        EXPECT_EQ(shrunk(kind.make(9, 1), [](const Points&) { return true; }),
                  Points(9, Point::Zero()))
            << kind.name;
    }
}

TEST(SimplerPoints, LeadToFewSmallIntegersFromEveryKind) {
    // Fails where two points differ in a coordinate.
    const auto fails = [](const Points& points) { return points[2].x() != points[5].x(); };
    for (const PointKind& kind : point_kinds()) {
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            const Points points = kind.make(8, seed);
            if (!fails(points)) continue;
            Points least(8, Point::Zero());
            const Points found = shrunk(points, fails);
            least[found[2].x() != 0 ? 2 : 5].x() = 1;
            EXPECT_EQ(found, least) << kind.name << ", seed " << seed;
        }
    }
}

TEST(SimplerPoints, KeepWhatMatters) {
    // Fails on a tetrahedron of positive volume.
    const auto fails = [](const Points& points) {
        Eigen::Matrix3d sides;
        for (int i = 0; i < 3; ++i)
            sides.col(i) = points[static_cast<std::size_t>(i) + 1] - points[0];
        const double volume =
            sides(0, 0) * (sides(1, 1) * sides(2, 2) - sides(1, 2) * sides(2, 1)) -
            sides(0, 1) * (sides(1, 0) * sides(2, 2) - sides(1, 2) * sides(2, 0)) +
            sides(0, 2) * (sides(1, 0) * sides(2, 1) - sides(1, 1) * sides(2, 0));
        return volume > 0;
    };
    int tried = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Points points = find_point_kind("general")->make(4, seed);
        if (!fails(points)) continue;
        ++tried;
        double sum = 0;
        for (const Point& point : shrunk(points, fails)) {
            EXPECT_EQ(point, point.array().round().matrix());
            sum += point.cwiseAbs().sum();
        }
        EXPECT_LE(sum, 5);
    }
    EXPECT_GT(tried, 4);
}

}  // namespace
}  // namespace tightflip::properties
