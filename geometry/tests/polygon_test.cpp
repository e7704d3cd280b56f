#include "shapes.hpp"
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/polygon.hpp>

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

double doubled_area(Points polygon) {
    double sum = 0;
    const Point* before = &polygon.back();
    for (const Point& point : polygon) {
        sum += before->x() * point.y() - before->y() * point.x();
        before = &point;
    }
    return sum;
}

/// Counter-clockwise about the origin, at random distances.
std::vector<Point> star_polygon(int corners, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    std::vector<Point> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const double radius = 1.2 + random_coordinate(random);
        polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    return polygon;
}

/// Teeth upon a bar, with straight corners in its base.
std::vector<Point> comb(int teeth) {
    std::vector<Point> polygon;
    for (int i = 0; i <= 2 * teeth; ++i)
        polygon.emplace_back(i, 0, 0);
    for (int i = 2 * teeth; i >= 0; --i)
        polygon.emplace_back(i, i % 2 == 0 ? 1 : 5, 0);
    return polygon;
}

void expect_triangulated(Points polygon) {
    const auto triangles = triangulate_polygon(polygon);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    double area = 0;
    for (const Face& face : triangles) {
        std::vector<Point> corners;
        for (const Index i : face)
            corners.push_back(polygon[static_cast<std::size_t>(i)]);
        EXPECT_EQ(orientation_in_plane(corners[0], corners[1], corners[2]), Sign::positive);
        area += doubled_area(corners);
    }
    EXPECT_NEAR(area, doubled_area(polygon), 1e-12 * area);  // with all positive: no overlaps
}

TEST(Polygon, EarsFillSimplePolygons) {
    for (std::uint64_t seed = 0; seed < 30; ++seed)
        expect_triangulated(star_polygon(3 + static_cast<int>(seed) * 3, seed));
    for (const int teeth : {1, 2, 10})
        expect_triangulated(comb(teeth));
    expect_triangulated(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}});
    expect_triangulated(std::vector<Point>{
        {0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}, {0, 4, 0}, {0, 2, 0}});
}

TEST(Polygon, NoEarIsCutAlongACornerOnItsThirdSide) {
    std::vector<Point> notched{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {-2, 4, 0}};
    for (std::size_t first = 0; first < notched.size(); ++first) {
        std::ranges::rotate(notched, notched.begin() + 1);
        expect_triangulated(notched);
    }
}

TEST(Polygon, EveryTurningIsKnown) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        auto polygon = star_polygon(11, seed);
        EXPECT_TRUE(is_counter_clockwise(polygon));
        EXPECT_FALSE(find_crossing_sides(polygon));
        std::ranges::reverse(polygon);
        EXPECT_FALSE(is_counter_clockwise(polygon));
        EXPECT_FALSE(find_crossing_sides(polygon));
    }
    EXPECT_FALSE(find_crossing_sides(comb(5)));
}

TEST(Polygon, SidesThatMeetAreNamed) {
    using Sides = std::array<Index, 2>;
    const auto find = [](const std::vector<Point>& polygon) {
        return find_crossing_sides(polygon);
    };
    EXPECT_EQ(find({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}), (Sides{0, 2}));
    // A corner on another side, and one on another corner.
    EXPECT_EQ(find({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}}), (Sides{0, 2}));
    EXPECT_EQ(find({{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {0, 0, 0}, {-2, 1, 0}, {-2, -1, 0}}),
              (Sides{0, 2}));
    // Sides that fold back, stand still, or lie on one line.
    EXPECT_EQ(find({{0, 0, 0}, {3, 0, 0}, {1, 0, 0}, {1, 1, 0}}), (Sides{0, 1}));
    EXPECT_EQ(find({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {3, 0, 0}, {1, 0, 0}, {2, 0, 0}}),
              (Sides{3, 4}));
    EXPECT_EQ(find({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Sides{0, 1}));
    EXPECT_EQ(find({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), (Sides{0, 2}));
    EXPECT_TRUE(find({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 0, 0}, {2, 0, 0}, {2, 3, 0}}));
}

}  // namespace
}  // namespace tightflip::geometry
