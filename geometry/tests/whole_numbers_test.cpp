#include "whole_numbers.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

TEST(WholeNumbers, AreTheValuesInTheirUnit) {
    const Point p(0.75, -6, 0);
    const Point q(1, 0, 0);
    const int unit = common_unit(std::array{&p, &q});
    EXPECT_EQ(in_units(0.75, unit) * 4, in_units(1, unit) * 3);
    EXPECT_EQ(in_units(-6, unit), in_units(1, unit) * -6);
    EXPECT_EQ(in_units(0, unit), 0);
    EXPECT_EQ(difference_in_units(p, q, unit)[1], in_units(6, unit));
}

TEST(WholeNumbers, HaveRoomForTheLeastBesideTheLargest) {
    const Point p(least, largest, 0);
    const int unit = common_unit(std::array{&p});
    EXPECT_GT(in_units(least, unit), 0);
    EXPECT_EQ(in_units(least, unit) << (1074 + 971), in_units(largest, unit) / 0x1fffffffffffff);
}

TEST(WholeNumbers, TellOrientationsThatNoDoubleCan) {
    for (const double size : {least, 1.0, 0x1p1000}) {
        const Point o(0, 0, 0);
        const Point x(size, 0, 0);
        const Point y(0, size, 0);
        EXPECT_EQ(orientation_by_whole_numbers(o, x, y, Point(0, 0, size)), Sign::positive);
        EXPECT_EQ(orientation_by_whole_numbers(o, y, x, Point(0, 0, size)), Sign::negative);
        EXPECT_EQ(orientation_by_whole_numbers(o, x, y, Point(size, size, 0)), Sign::zero);
        EXPECT_EQ(orientation_by_whole_numbers(o, x, y, Point(-size, size, -least)),
                  Sign::negative);
        EXPECT_EQ(orientation_by_whole_numbers(x, y, Point(0, 0, size), o), Sign::negative);
    }
}

}  // namespace
}  // namespace tightflip::geometry
