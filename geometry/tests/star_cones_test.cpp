#include "star_cones.hpp"

#include "allocation_count.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/curvature.hpp>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

std::vector<Surface> samples() {
    std::vector<Surface> surfaces{regular_tetrahedron(), cube(), octahedron(), icosahedron()};
    std::uint64_t seed = 1;
    for (const Triangulation& family : all_families()) {
        surfaces.push_back(with_random_points(family, ++seed));
        for (const std::uint32_t bound : {1U, 2U})
            surfaces.push_back(with_grid_points(family, seed, bound));
    }
    return surfaces;
}

TEST(StarCones, HaveThePositiveCurvatureOfTheStar) {
    for (const Surface& surface : samples()) {
        const StarCones cones(surface.view());
        StarMeter meter;
        for (Index h = 0; h < surface.triangulation().halfedge_count(); ++h) {
            EXPECT_NEAR(cones.positive_curvature(Halfedge{h}),
                        meter.measure(surface.view(), Halfedge{h}).positive, 1e-13);
        }
    }
}

TEST(StarCones, SayWhatAnEdgeMoreOrLessChanges) {
    kernel::RandomStream random(3);
    for (Surface& surface : samples()) {
        Triangulation& triangulation = surface.triangulation();
        StarCones cones(surface.view());
        for (int i = 0; i < 60; ++i) {
            const Edge e{static_cast<Index>(
                random.below(static_cast<std::uint32_t>(triangulation.edge_count())))};
            if (!triangulation.can_flip(e)) continue;
            const auto q = kernel::Quadrilateral::around(triangulation.table(), e);
            const Vertex a = triangulation.origin(q.h);
            const Vertex c = triangulation.origin(q.h2);
            const double loss = cones.change_without(q.h);
            const double gain = cones.change_across(q.h);
            const double loss_from = cones.positive_curvature(q.h);
            const double gain_from = cones.positive_curvature(q.h2);
            ASSERT_TRUE(triangulation.flip(e));
            const StarCones after(surface.view());
            const auto outgoing = triangulation.outgoing();
            const auto of = [&](Vertex v) {
                return after.positive_curvature(outgoing[static_cast<std::size_t>(v.id)]);
            };
            EXPECT_NEAR(loss_from + loss, of(a), 1e-13);
            EXPECT_NEAR(gain_from + gain, of(c), 1e-13);
            cones.flipped(e);
        }
    }
}

/// Asks for everything after each flip, so that whatever is kept too long is seen.
TEST(StarCones, ForgetWhatAFlipChanges) {
    kernel::RandomStream random(4);
    for (Surface& surface : samples()) {
        Triangulation& triangulation = surface.triangulation();
        StarCones cones(surface.view());
        const auto count = static_cast<std::uint32_t>(triangulation.edge_count());
        for (int i = 0; i < 25; ++i) {
            const Edge e{static_cast<Index>(random.below(count))};
            if (!triangulation.can_flip(e)) continue;
            i % 4 == 0 ? triangulation.unflip(e) : triangulation.flip(e);
            cones.flipped(e);
            StarCones fresh(surface.view());
            for (Index h = 0; h < triangulation.halfedge_count(); ++h) {
                const Halfedge side{h};
                ASSERT_NEAR(cones.positive_curvature(side), fresh.positive_curvature(side), 1e-13);
                ASSERT_NEAR(cones.change_without(side), fresh.change_without(side), 1e-13);
                ASSERT_NEAR(cones.change_across(side), fresh.change_across(side), 1e-13);
            }
        }
    }
}

TEST(StarCones, DoNotAllocateWhenAskedInGeneralPosition) {
    const Surface surface = with_random_points(kernel::families::stacked(200, 4), 4);
    const Triangulation& triangulation = surface.triangulation();
    StarCones cones(surface.view());
    const auto ask = [&] {
        double sum = 0;
        for (Index h = 0; h < triangulation.halfedge_count(); ++h) {
            sum += cones.change_without(Halfedge{h});
            sum += cones.change_across(Halfedge{h});
        }
        return sum;
    };
    const std::size_t before = bytes_requested();
    EXPECT_NE(ask(), 0);
    EXPECT_EQ(bytes_requested(), before);
}

}  // namespace
}  // namespace tightflip::geometry
