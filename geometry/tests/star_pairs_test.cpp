#include "star_pairs.hpp"

#include "self_intersecting_shapes.hpp"
#include <tightflip/geometry/self_intersections.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using Pairs = std::multiset<std::pair<Halfedge, Halfedge>>;

Pairs pairs_shown(const Surface& surface, Halfedge h) {
    StarPairs star;
    star.read(surface.view(), h);
    Pairs pairs;
    EXPECT_FALSE(star.any([&](Halfedge f, Halfedge g) {
        pairs.emplace(std::min(f, g), std::max(f, g));
        return false;
    }));
    return pairs;
}

TEST(StarPairs, LeaveOutNoneThatMeets) {
    int seen = 0;
    for (const Triangulation& triangulation : all_families()) {
        for (const Surface& surface :
             {with_grid_points(triangulation, 1, 1), with_grid_points(triangulation, 2, 3),
              scaled(with_random_points(triangulation, 3), -1000)}) {
            for (const Halfedge h : triangulation.outgoing()) {
                const Pairs shown = pairs_shown(surface, h);
                for (const Halfedge f : triangulation.star(h)) {
                    for (const Halfedge g : triangulation.star(h)) {
                        if (f >= g) continue;
                        ASSERT_LE(shown.count({f, g}), 1U);
                        if (!faces_meet(surface.view(), f, g)) continue;
                        ASSERT_EQ(shown.count({f, g}), 1U);
                        ++seen;
                    }
                }
            }
        }
    }
    EXPECT_GT(seen, 1000);
}

TEST(StarPairs, AreFewWhereTheStarIsOpen) {
    constexpr Index rim = 5000;
    const Surface wheel = wound_bipyramid(rim, 1);
    const Pairs shown = pairs_shown(wheel, wheel.triangulation().outgoing()[0]);
    EXPECT_GE(shown.size(), static_cast<std::size_t>(rim));  // those side by side
    EXPECT_LE(shown.size(), static_cast<std::size_t>(5 * rim));
}

}  // namespace
}  // namespace tightflip::geometry
