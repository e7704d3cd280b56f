#include "allocation_count.hpp"
#include "cone_by_triples.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/convex_cone.hpp>
#include <tightflip/geometry/exact_predicates.hpp>

#include <algorithm>
#include <numbers>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<Index> extreme(const std::vector<Point>& targets) {
    ConvexCone cone;
    cone.span(Point::Zero(), targets);
    EXPECT_TRUE(cone.is_pointed());
    return {cone.extreme_rays().begin(), cone.extreme_rays().end()};
}

bool is_pointed(const std::vector<Point>& targets) {
    ConvexCone cone;
    cone.span(Point::Zero(), targets);
    return cone.is_pointed();
}

TEST(ConvexCone, OfFewRays) {
    EXPECT_THAT(extreme({}), IsEmpty());
    EXPECT_THAT(extreme({{0, 0, 0}}), IsEmpty());
    EXPECT_THAT(extreme({{0, 0, 0}, {1, 2, 3}, {0.5, 1, 1.5}}), ElementsAre(1));
    EXPECT_THAT(extreme({{1, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 1, 0}, {2, 1, 0}}),
                ElementsAre(0, 3));
    EXPECT_THAT(extreme({{1, 0, 0}, {1, 1, 0}, {1, -1, 0}}), ElementsAre(2, 1));
}

TEST(ConvexCone, IsNotPointedWhereItContainsALine) {
    EXPECT_FALSE(is_pointed({{1, 2, 3}, {-2, -4, -6}}));
    EXPECT_FALSE(is_pointed({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}));
    EXPECT_FALSE(is_pointed({{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}));
    EXPECT_FALSE(is_pointed({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}}));   // a wedge
    EXPECT_FALSE(is_pointed({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, 0}}));  // a half-space
    EXPECT_FALSE(is_pointed({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}}));
    EXPECT_TRUE(is_pointed({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, 2.1}}));
    EXPECT_TRUE(is_pointed({{1, 0, 1e-300}, {-1, 1, 1e-300}, {-1, -1, 1e-300}}));
    EXPECT_FALSE(is_pointed({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1e-300}}));
}

TEST(ConvexCone, NamesRaysThatContainALine) {
    kernel::RandomStream random(8);
    int lines = 0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<Point> targets(3 + random.below(7));
        for (Point& target : targets)
            target = i % 2 == 0 ? random_grid_point(random, 2) : random_point(random);
        ConvexCone cone;
        cone.span(Point::Zero(), targets);
        if (cone.is_pointed()) {
            EXPECT_THAT(cone.line(), IsEmpty());
            continue;
        }
        std::vector<Point> named;
        for (const Index ray : cone.line())
            named.push_back(targets[static_cast<std::size_t>(ray)]);
        EXPECT_LE(named.size(), 4U);
        EXPECT_FALSE(is_pointed(named));
        ++lines;
    }
    EXPECT_GT(lines, 500);
}

TEST(ConvexCone, HasItsRaysCounterClockwiseSeenFromOutside) {
    // Seen from above, the outside of a cone that opens downwards, these turn counter-clockwise.
    EXPECT_THAT(extreme({{1, 0, -1}, {0, 1, -1}, {-1, 0, -1}, {0, -1, -1}, {0, 0, -1}}),
                ElementsAre(0, 1, 2, 3));
    const std::vector<Index> reversed = extreme({{1, 0, -1}, {0, -1, -1}, {-1, 0, -1}});
    ASSERT_EQ(reversed.size(), 3U);
    EXPECT_EQ(orientation(Point::Zero(), Point(1, 0, -1), Point(-1, 0, -1), Point(0, -1, -1)),
              Sign::negative);
    EXPECT_THAT(reversed,
                testing::AnyOf(ElementsAre(0, 2, 1), ElementsAre(2, 1, 0), ElementsAre(1, 0, 2)));
}

TEST(ConvexCone, Directions) {
    const Point o(1, 1, 1);
    EXPECT_TRUE(same_direction(o, {2, 3, 1}, {3, 5, 1}));
    EXPECT_TRUE(same_direction(o, {2, 3, 1}, {2, 3, 1}));
    EXPECT_FALSE(same_direction(o, {2, 3, 1}, {0, -1, 1}));
    EXPECT_FALSE(same_direction(o, {2, 3, 1}, {3, 5, 1.0000000000000002}));
    EXPECT_FALSE(same_direction(o, o, {3, 5, 1}));
    EXPECT_FALSE(same_direction(o, o, o));
    EXPECT_TRUE(opposite_direction(o, {2, 3, 1}, {0, -1, 1}));
    EXPECT_FALSE(opposite_direction(o, {2, 3, 1}, {3, 5, 1}));
    EXPECT_FALSE(opposite_direction(o, {2, 3, 1}, {0, -1, 2}));
    EXPECT_FALSE(opposite_direction(o, {2, 3, 1}, o));
}

TEST(ConvexCone, AgreesWithAllTriplesOfRaysOnAGrid) {
    kernel::RandomStream random(77);
    std::array<int, 2> seen{};
    ConvexCone cone;
    for (int trial = 0; trial < 3000; ++trial) {
        const std::uint32_t bound = 1 + random.below(3);
        std::vector<Point> rays(3 + random.below(8));
        for (Point& ray : rays) {
            do {
                ray = random_grid_point(random, bound);
                if (random.below(8) != 0) ray.z() = std::abs(ray.z());
            } while (ray.isZero(0));
        }
        if (!span_space(rays)) continue;
        cone.span(Point::Zero(), rays);
        const bool expected = is_pointed_by_triples(rays);
        ASSERT_EQ(cone.is_pointed(), expected) << trial;
        ++seen.at(expected ? 1 : 0);
        if (!expected) continue;
        const auto found = cone.extreme_rays();
        ASSERT_GE(found.size(), 3U);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto& u = rays[static_cast<std::size_t>(found[i])];
            const auto& v = rays[static_cast<std::size_t>(found[(i + 1) % found.size()])];
            ASSERT_TRUE(is_side(rays, u, v)) << trial;
        }
    }
    EXPECT_GT(seen[0], 300);
    EXPECT_GT(seen[1], 300);
}

/// Directions on a circle about the axis, in any order, with others inside: the circle is found.
TEST(ConvexCone, FindsALargePolygonInAnyOrderWithoutAllocating) {
    constexpr Index corners = 500;
    kernel::RandomStream random(5);
    std::vector<Index> place(2 * corners);
    std::iota(place.begin(), place.end(), 0);
    ConvexCone cone;
    for (int trial = 0; trial < 5; ++trial) {
        random.shuffle(std::span(place));
        std::vector<Point> rays(2 * corners);
        for (Index i = 0; i < corners; ++i) {
            const double turn = 2 * std::numbers::pi * (i + 0.3 * std::sin(i * i)) / corners;
            const Point outer(std::cos(turn), std::sin(turn), -0.3);
            rays[static_cast<std::size_t>(place[static_cast<std::size_t>(i)])] =
                outer * (1 + random.below(5));
            rays[static_cast<std::size_t>(place[static_cast<std::size_t>(i + corners)])] = {
                std::cos(turn + 1) * 0.9, std::sin(turn + 1) * 0.9, -0.3};
        }
        const auto before = bytes_requested();
        cone.span(Point::Zero(), rays);
        if (trial > 0) {
            EXPECT_EQ(bytes_requested(), before);
        }
        ASSERT_TRUE(cone.is_pointed());
        const auto found = cone.extreme_rays();
        ASSERT_EQ(found.size(), static_cast<std::size_t>(corners));
        std::vector<Index> position(2 * corners, -1);
        for (Index i = 0; i < corners; ++i) {
            position[static_cast<std::size_t>(place[static_cast<std::size_t>(i)])] = i;
        }
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Index here = position[static_cast<std::size_t>(found[i])];
            const Index there = position[static_cast<std::size_t>(found[(i + 1) % found.size()])];
            EXPECT_EQ((here + 1) % corners, there);
        }
    }
}

}  // namespace
}  // namespace tightflip::geometry
