#include "axis_sweep.hpp"

#include "shapes.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

void expect_sweep(Points points, const std::array<Index, 4>& corners, std::uint64_t seed) {
    const PerturbedPoints perturbed(points, corners);
    const auto sweep = axis_sweep(points, perturbed, seed);
    ASSERT_TRUE(sweep);
    ASSERT_EQ(sweep->order.size(), points.size() - 1);
    std::vector<Vertex> all = sweep->order;
    all.push_back(sweep->hub);
    std::ranges::sort(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        ASSERT_EQ(all[i], Vertex{static_cast<Index>(i)});
    // Seen from the hub the last of any first few is a corner of their hull in the plane: all the
    // others are on one side of the lines from it to two of them.
    const auto& order = sweep->order;
    for (std::size_t last = 2; last < order.size(); ++last) {
        for (const Sign side : {Sign::positive, Sign::negative}) {
            EXPECT_TRUE(
                std::any_of(order.begin(), order.begin() + static_cast<long>(last), [&](Vertex x) {
                    return std::all_of(
                        order.begin(), order.begin() + static_cast<long>(last), [&](Vertex y) {
                            return perturbed.side(sweep->hub, order[last], x, y) != side;
                        });
                }));
        }
    }
}

TEST(AxisSweep, AddsPointsOutsideThoseBefore) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        std::vector<Point> points = random_points(25, seed);
        for (Point& point : points)
            point.normalize();
        expect_sweep(points, {0, 1, 2, 3}, seed);
    }
}

TEST(AxisSweep, OrdersCollinearAndCoplanarPoints) {
    // The surface of a cube of 2 x 2 x 2 cells.
    std::vector<Point> points;
    for (int v = 0; v < 27; ++v) {
        if (v != 13) points.emplace_back(v % 3, v / 3 % 3, v / 9);
    }
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        expect_sweep(points, {0, 1, 3, 9}, seed);
}

TEST(AxisSweep, FindsNoneWhereNoAxisTouchesInACorner) {
    // Coincident points are never on different sides of an axis.
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
    const PerturbedPoints perturbed(points, {0, 1, 2, 3});
    EXPECT_FALSE(axis_sweep(points, perturbed, 1));
}

}  // namespace
}  // namespace tightflip::geometry
