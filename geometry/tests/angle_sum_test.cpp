#include "angle_sum.hpp"

#include "shapes.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

constexpr double pi = std::numbers::pi;

double sum_of(const std::vector<double>& angles, double scale = 1) {
    AngleSum sum;
    for (const double angle : angles)
        sum.add(scale * std::sin(angle), scale * std::cos(angle));
    EXPECT_TRUE(sum.is_reliable());
    return sum.total();
}

TEST(AngleSum, OfRandomAngles) {
    kernel::RandomStream random(1);
    for (int i = 0; i < 2000; ++i) {
        std::vector<double> angles(random.below(6));
        double expected = 0;
        for (double& angle : angles) {
            // Also angles close to nothing and to a half turn.
            const double x = (random_coordinate(random) + 1) / 2;
            angle = std::array{x * pi, x * 1e-15, pi - x * 1e-15}[random.below(3)];
            expected += angle;
        }
        EXPECT_NEAR(sum_of(angles, 1 + 100 * (random_coordinate(random) + 1)), expected, 1e-14);
    }
}

TEST(AngleSum, OfHalfTurns) {
    for (int n = 0; n <= 5; ++n) {
        AngleSum exact;
        AngleSum rounded;
        for (int i = 0; i < n; ++i) {
            exact.add(0, -1);
            rounded.add(1e-300, -1);
        }
        EXPECT_DOUBLE_EQ(exact.total(), n * pi);
        EXPECT_DOUBLE_EQ(rounded.total(), n * pi);
    }
}

TEST(AngleSum, KnowsWhenProductsLeaveTheRange) {
    AngleSum large;
    AngleSum small;
    for (int i = 0; i < 5; ++i) {
        large.add(1e80, 1e80);
        small.add(1e-80, -1e-80);
    }
    EXPECT_FALSE(large.is_reliable());
    EXPECT_FALSE(small.is_reliable());
}

}  // namespace
}  // namespace tightflip::geometry
