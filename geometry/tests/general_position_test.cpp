/// \file
/// General position of sets whose lines and planes can be counted by hand, and against
/// determinants in integers.
#include "self_intersecting_shapes.hpp"
#include <tightflip/geometry/general_position.hpp>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

std::vector<Point> grid(int x_size, int y_size, int z_size) {
    std::vector<Point> points;
    for (int x = 0; x < x_size; ++x) {
        for (int y = 0; y < y_size; ++y) {
            for (int z = 0; z < z_size; ++z)
                points.emplace_back(x, y, z);
        }
    }
    return points;
}

TEST(GeneralPosition, OfGrids) {
    const auto cube_points = general_position(grid(2, 2, 2));
    EXPECT_EQ(cube_points.coincident.count, 0);
    EXPECT_EQ(cube_points.collinear.count, 0);
    EXPECT_EQ(cube_points.coplanar.count, 12);  // six squares, six rectangles through the middle
    EXPECT_FALSE(cube_points.holds());
    const auto square = general_position(grid(3, 3, 1));
    EXPECT_EQ(square.collinear.count, 8);
    // Of 126 quadruples each line of three has six.
    EXPECT_EQ(square.coplanar.count, 126 - 8 * 6);
    EXPECT_EQ(general_position(grid(3, 3, 3)).collinear.count, 49);
    EXPECT_EQ(general_position(octahedron().points()).coplanar.count, 3);
    EXPECT_EQ(general_position(regular_tetrahedron().points()).coplanar.count, 0);
    EXPECT_TRUE(general_position(regular_tetrahedron().points()).holds());
    EXPECT_TRUE(general_position(Points{}).holds());
}

TEST(GeneralPosition, CountsEachOffenceOnce) {
    // Three points equal, and two: four pairs; seen as points, only three, on a line.
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 0, 0},
                                    {2, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}};
    const auto position = general_position(points);
    EXPECT_EQ(position.coincident.count, 4);
    const std::vector<std::array<Vertex, 2>> pairs{{Vertex{0}, Vertex{2}},
                                                   {Vertex{0}, Vertex{5}},
                                                   {Vertex{1}, Vertex{4}},
                                                   {Vertex{2}, Vertex{5}}};
    EXPECT_EQ(position.coincident.first, pairs);
    EXPECT_EQ(position.collinear.count, 3 * 2);
    EXPECT_EQ(position.coplanar.count, 0);
    EXPECT_EQ(general_position(points, 2).coincident.first,
              std::vector(pairs.begin(), pairs.begin() + 2));
    EXPECT_EQ(general_position(points, 2).coincident.count, 4);
    EXPECT_EQ(general_position(points, 2).collinear.first.size(), 2U);
    EXPECT_EQ(position.collinear.first.front(), (std::array{Vertex{0}, Vertex{1}, Vertex{3}}));
}

TEST(GeneralPosition, AgreesWithIntegerDeterminants) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Surface surface = with_grid_points(kernel::families::stacked(14, 1), seed, 2);
        std::vector<std::array<Vertex, 4>> coplanar;
        const auto point = [&](Index v) { return surface.points()[static_cast<std::size_t>(v)]; };
        const auto collinear = [&](Index a, Index b, Index c) {
            return (point(b) - point(a)).cross(point(c) - point(a)).isZero(0);
        };
        for (Index a = 0; a < 14; ++a) {
            for (Index b = 0; b < a; ++b) {
                for (Index c = 0; c < b; ++c) {
                    for (Index d = 0; d < c; ++d) {
                        const Point normal = (point(b) - point(a)).cross(point(c) - point(a));
                        if (normal.dot(point(d) - point(a)) != 0) continue;
                        if (collinear(a, b, c) || collinear(a, b, d) || collinear(a, c, d) ||
                            collinear(b, c, d)) {
                            continue;
                        }
                        coplanar.push_back({Vertex{d}, Vertex{c}, Vertex{b}, Vertex{a}});
                    }
                }
            }
        }
        std::ranges::sort(coplanar);
        ASSERT_GT(coplanar.size(), 5U);
        const auto position =
            general_position(surface.view(), {.all_up_to = 14, .kept = 1U << 20U});
        EXPECT_EQ(position.scope, PositionScope::all_points);
        EXPECT_EQ(position.coplanar.first, coplanar);
        EXPECT_EQ(position.coplanar.count, static_cast<std::int64_t>(coplanar.size()));
    }
}

TEST(GeneralPosition, OfLargeSurfacesIsOfWhatFlipsMeet) {
    const auto flips = general_position(cube().view(), {.all_up_to = 7});
    EXPECT_EQ(flips.scope, PositionScope::flips);
    EXPECT_EQ(flips.coplanar.count, 6);  // the squares, whose diagonals are edges
    EXPECT_EQ(flips.collinear.count, 0);
    EXPECT_EQ(general_position(cube().view(), {.all_up_to = 8}).coplanar.count, 12);
    const Surface random = with_random_points(kernel::families::random(500, 1, 1), 2);
    EXPECT_TRUE(general_position(random.view()).holds());
    EXPECT_EQ(general_position(random.view()).scope, PositionScope::flips);
}

/// What a flip meets after flips is met before them too: each triple and quadruple that the table
/// shows as faces or as what a flip makes of them is among all.
TEST(GeneralPosition, FlipsMeetSomeOfAllOffences) {
    std::int64_t collinear_count = 0;
    std::int64_t coplanar_count = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        for (const Triangulation& triangulation :
             {kernel::families::random(20, 1, seed), kernel::families::book(12)}) {
            const Surface surface = with_grid_points(triangulation, seed, 1);
            const auto all = general_position(surface.view(), {.all_up_to = 99, .kept = 1U << 20U});
            const auto some = general_position(surface.view(), {.all_up_to = 0, .kept = 1U << 20U});
            EXPECT_EQ(some.coincident.first, all.coincident.first);
            EXPECT_TRUE(std::ranges::includes(all.collinear.first, some.collinear.first));
            EXPECT_TRUE(std::ranges::includes(all.coplanar.first, some.coplanar.first));
            collinear_count += some.collinear.count;
            coplanar_count += some.coplanar.count;
            // Each face on a line with different corners is among them.
            for (const Halfedge h : surface.triangulation().faces()) {
                std::vector<Vertex> corners;
                for (const Vertex v : surface.triangulation().face_corners(h))
                    corners.push_back(v);
                std::ranges::sort(corners);
                const std::array triple{corners[0], corners[1], corners[2]};
                EXPECT_EQ(std::ranges::binary_search(some.collinear.first, triple),
                          std::ranges::binary_search(all.collinear.first, triple));
            }
        }
    }
    EXPECT_GT(collinear_count, 5);
    EXPECT_GT(coplanar_count, 20);
}

}  // namespace
}  // namespace tightflip::geometry
