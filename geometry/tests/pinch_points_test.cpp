/// \file
/// Pinch points of known surfaces, as the common vertices of local self-intersections, and as what
/// happens arbitrarily near a vertex.
#include "self_intersecting_shapes.hpp"
#include <tightflip/geometry/pinch_points.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/triangle_intersection.hpp>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<Index> labels(const std::vector<Vertex>& vertices) {
    std::vector<Index> result;
    for (const Vertex v : vertices)
        result.push_back(v.id);
    return result;
}

TEST(PinchPoints, OfKnownSurfaces) {
    for (const Surface& surface :
         {regular_tetrahedron(), cube(), octahedron(), icosahedron(), round_torus(7, 9)}) {
        EXPECT_THAT(pinch_points(surface.view()), IsEmpty());
    }
    EXPECT_THAT(labels(pinch_points(bow_tie().view())), ElementsAre(0, 1));
    EXPECT_THAT(labels(pinch_points(scaled(bow_tie(), 1000).view())), ElementsAre(0, 1));
    EXPECT_THAT(labels(pinch_points(scaled(bow_tie(), -1000).view())), ElementsAre(0, 1));
    EXPECT_THAT(labels(pinch_points(wound_bipyramid(7, 2).view())), ElementsAre(0, 1));
    // Two faces back to back, at every vertex.
    const Surface sphere{kernel::families::book(3), {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}};
    EXPECT_THAT(labels(pinch_points(sphere.view())), ElementsAre(0, 1, 2));
}

/// A spike from one side of a torus through the opposite one.
TEST(PinchPoints, AreNotWhereOnlyStrangersMeet) {
    const Surface torus = round_torus(12, 12);
    std::vector<Point> points(torus.points().begin(), torus.points().end());
    points[0] = {-3.1, 0.05, 0.03};
    const Surface spiked{torus.triangulation(), points};
    const auto found = find_self_intersections(spiked.view());
    EXPECT_EQ(found.local_count, 0);
    EXPECT_GT(found.global_count, 0);
    EXPECT_THAT(pinch_points(spiked.view()), IsEmpty());
}

TEST(PinchPoints, AreTheCommonVerticesOfLocalSelfIntersections) {
    std::size_t seen = 0;
    std::size_t not_seen = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        for (const Triangulation& triangulation : all_families()) {
            for (const Surface& surface :
                 {with_grid_points(triangulation, seed, static_cast<std::uint32_t>(1 + seed)),
                  with_random_points(triangulation, seed)}) {
                std::set<Index> expected;
                for (const FacePair& pair :
                     find_self_intersections(surface.view(), 1U << 30U).pairs) {
                    for (const Vertex v : surface.triangulation().face_corners(pair.first)) {
                        for (const Vertex w : surface.triangulation().face_corners(pair.second)) {
                            if (v == w) expected.insert(v.id);
                        }
                    }
                }
                ASSERT_EQ(labels(pinch_points(surface.view())),
                          std::vector(expected.begin(), expected.end()));
                const auto outgoing = surface.triangulation().outgoing();
                for (const Halfedge h : outgoing) {
                    const Index v = surface.triangulation().origin(h).id;
                    ASSERT_EQ(is_pinch_point(surface.view(), h), expected.contains(v));
                }
                seen += expected.size();
                not_seen += surface.points().size() - expected.size();
            }
        }
    }
    EXPECT_GT(seen, 500U);
    EXPECT_GT(not_seen, 500U);
}

/// Faces cut off near the vertex, each to its own size, meet as the whole ones do.
TEST(PinchPoints, AreLocal) {
    kernel::RandomStream random(3);
    int seen = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const Point v = random_grid_point(random, 3);
        Triangle f{v, random_grid_point(random, 3), random_grid_point(random, 3)};
        Triangle g{v, random_grid_point(random, 3), random_grid_point(random, 3)};
        const bool expected = triangles_meet_beyond(f, g, std::span(&v, 1));
        for (Triangle* t : {&f, &g}) {
            for (const std::size_t i : {1U, 2U})
                t->at(i) = v + (t->at(i) - v) * std::ldexp(1, -static_cast<int>(random.below(20)));
        }
        ASSERT_EQ(triangles_meet_beyond(f, g, std::span(&v, 1)), expected) << trial;
        if (expected) ++seen;
    }
    EXPECT_GT(seen, 300);
    EXPECT_LT(seen, 2700);
}

/// All pairs of a star of this degree would be 5 * 10^9.
TEST(PinchPoints, OfALargeStar) {
    constexpr Index rim = 100000;
    const Surface wheel = wound_bipyramid(rim, 1);
    EXPECT_THAT(pinch_points(wheel.view()), IsEmpty());
    std::vector<Point> points(wheel.points().begin(), wheel.points().end());
    std::swap(points[500], points[501]);
    const Surface crossed{wheel.triangulation(), points};
    EXPECT_THAT(labels(pinch_points(crossed.view())),
                testing::AllOf(testing::Contains(0), testing::Contains(1)));
}

}  // namespace
}  // namespace tightflip::geometry
