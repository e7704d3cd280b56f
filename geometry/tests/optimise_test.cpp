#include "height_grid.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/composed_criteria.hpp>
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/geometry/optimise.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/kernel/audit.hpp>

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

OptimiseResult optimise_by(Surface& surface, std::string_view criterion,
                           const OptimiseOptions& options = {}) {
    const auto made = parse_criterion(criterion, surface.view());
    return optimise(surface.triangulation(), surface.points(), *made, options);
}

/// Whether no flip of the surface improves, asked of a criterion that has seen no flip.
void expect_local_minimum(const Surface& surface, std::string_view name) {
    const auto criterion = parse_criterion(name, surface.view());
    for (Index e = 0; e < surface.triangulation().edge_count(); ++e) {
        if (!surface.triangulation().can_flip(Edge{e})) continue;
        EXPECT_GT(criterion->change(Edge{e}).first(), -1e-9) << name << ", edge " << e;
    }
}

constexpr std::array criteria{"tight",       "mean",      "mean_weighted", "area",
                              "edge_length", "volume",    "abn",           "abn_squares",
                              "delaunay",    "min_angle", "area+0.1*abn"};

TEST(Optimise, EndsInALocalMinimumThatItsFlipsLeadTo) {
    for (const FlipOrder order : {FlipOrder::first, FlipOrder::best}) {
        for (const std::string_view name : criteria) {
            SCOPED_TRACE(name);
            const Surface start = with_random_points(kernel::families::random(40, 0, 3), 5);
            Surface surface = start;
            Energy last = parse_criterion(name, surface.view())->value();
            const OptimiseResult result = optimise_by(
                surface, name, {.order = order, .keep_going = [&](std::int64_t, const Energy& now) {
                                    EXPECT_LT(now, last);
                                    last = now;
                                    return true;
                                }});
            EXPECT_EQ(result.end, OptimiseEnd::local_minimum);
            EXPECT_GT(result.flips.size(), 5U);
            EXPECT_LT(result.after, result.before);
            EXPECT_NEAR(last.first(), result.after.first(),
                        1e-9 * (1 + std::abs(result.before.first())));
            expect_local_minimum(surface, name);
            Triangulation replayed = start.triangulation();
            for (const Edge e : result.flips)
                EXPECT_TRUE(replayed.flip(e));
            EXPECT_EQ(replayed, surface.triangulation());
        }
    }
}

TEST(Optimise, FlippingConcaveEdgesMakesStarShapedConvexDataConvex) {
    Surface twisted = data_sets::twisted_prism(3);
    const OptimiseResult result = optimise_by(twisted, "volume");
    EXPECT_TRUE(is_convex_surface(twisted.view()));
    EXPECT_LT(result.flips.size(), 20U);
    // From the cube's points on squares: convex up to flat edges.
    Surface grid = data_sets::cube_grid(56);
    EXPECT_EQ(optimise_by(grid, "volume").flips.size(), 0U);
    for (const std::uint64_t seed : {1, 2, 3}) {
        Surface sphere = data_sets::random_sphere(300, seed);
        // Away from the hull by flips at convex edges far from one another.
        for (Index e = 0; e < sphere.triangulation().edge_count(); e += 40)
            sphere.triangulation().flip(Edge{e});
        EXPECT_FALSE(is_convex_surface(sphere.view()));
        (void)optimise_by(sphere, "volume");
        EXPECT_TRUE(is_convex_surface(sphere.view()));
    }
}

TEST(Optimise, TightFindsTheHullFromNearby) {
    Surface sphere = data_sets::random_sphere(100, 4);
    for (Index e = 0; e < sphere.triangulation().edge_count(); e += 15)
        sphere.triangulation().flip(Edge{e});
    const OptimiseResult result = optimise_by(sphere, "tight");
    EXPECT_NEAR(result.after.first(), 4 * std::numbers::pi, 1e-9);
    EXPECT_TRUE(is_convex_surface(sphere.view()));
}

TEST(Optimise, LimitsAreKeptAndItGoesOnAfterwards) {
    const Surface start = with_random_points(kernel::families::random(60, 0, 4), 6);
    Surface whole = start;
    const OptimiseResult all = optimise_by(whole, "volume", {.order = FlipOrder::best});
    Surface parts = start;
    const OptimiseResult some =
        optimise_by(parts, "volume", {.order = FlipOrder::best, .max_flips = 10});
    EXPECT_EQ(some.end, OptimiseEnd::flip_limit);
    EXPECT_EQ(some.flips, std::vector<Edge>(all.flips.begin(), all.flips.begin() + 10));
    const OptimiseResult rest = optimise_by(parts, "volume", {.order = FlipOrder::best});
    EXPECT_EQ(rest.end, OptimiseEnd::local_minimum);
    EXPECT_EQ(rest.before, some.after);
    EXPECT_EQ(parts.triangulation(), whole.triangulation());

    Surface stopped = start;
    int calls = 0;
    const OptimiseResult result =
        optimise_by(stopped, "volume",
                    {.keep_going = [&](std::int64_t, const Energy&) { return ++calls < 4; }});
    EXPECT_EQ(result.end, OptimiseEnd::stopped);
    EXPECT_EQ(result.flips.size(), 4U);

    Surface late = start;
    EXPECT_EQ(optimise_by(late, "volume", {.max_time = std::chrono::duration<double>(-1)}).end,
              OptimiseEnd::time_limit);
    EXPECT_EQ(late.triangulation(), start.triangulation());

    Surface exact = start;
    const auto needed = static_cast<std::int64_t>(all.flips.size());
    EXPECT_EQ(optimise_by(exact, "volume", {.order = FlipOrder::best, .max_flips = needed}).end,
              OptimiseEnd::local_minimum);
}

TEST(Optimise, OfEqualImprovementsTheLowestNumberIsDone) {
    // A cube inside out: its twelve edges are concave, each with as much to gain.
    Surface surface = moved(cube(), Eigen::Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0)));
    Edge lowest{};
    for (Index e = surface.triangulation().edge_count() - 1; e >= 0; --e) {
        if (edge_shape(surface.view(), Edge{e}) == EdgeShape::concave) lowest = Edge{e};
    }
    for (const std::uint64_t seed : {0, 1, 2, 3}) {
        Surface start = surface;
        const OptimiseResult result =
            optimise_by(start, "volume", {.order = FlipOrder::best, .seed = seed, .max_flips = 1});
        EXPECT_EQ(result.flips, std::vector<Edge>{lowest});
    }
}

TEST(Optimise, LockedEdgesStay) {
    const Surface start = with_random_points(kernel::families::random(40, 1, 4), 6);
    const std::vector<Edge> locked{{3}, {10}, {11}, {50}};
    Surface free = start;
    const OptimiseResult without = optimise_by(free, "area");
    Surface surface = start;
    const OptimiseResult result = optimise_by(surface, "area", {.locked = locked});
    const std::set<Edge> flipped(result.flips.begin(), result.flips.end());
    const std::set<Edge> flipped_without(without.flips.begin(), without.flips.end());
    int would_flip = 0;
    for (const Edge e : locked) {
        EXPECT_FALSE(flipped.contains(e));
        would_flip += flipped_without.contains(e) ? 1 : 0;
        const Halfedge h = halfedge_of(e);
        EXPECT_EQ(surface.triangulation().origin(h), start.triangulation().origin(h));
        EXPECT_EQ(surface.triangulation().target(h), start.triangulation().target(h));
    }
    EXPECT_GT(would_flip, 0);
    const std::vector<Edge> none{{100000}};
    EXPECT_THROW((void)optimise_by(surface, "area", {.locked = none}), std::out_of_range);
}

TEST(Optimise, SimpleSurfacesStaySimpleWhereAsked) {
    int multigraphs = 0;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        const Surface start = with_random_points(kernel::families::stacked(30, seed), seed);
        for (const FlipOrder order : {FlipOrder::first, FlipOrder::best}) {
            Surface surface = start;
            (void)optimise_by(surface, "area", {.order = order, .allowed = AllowedFlips::simple});
            EXPECT_TRUE(audit(surface.triangulation()).is_simple().value());
            // No simple flip improves any more, whatever was turned down on the way.
            const OptimiseResult again =
                optimise_by(surface, "area", {.allowed = AllowedFlips::simple});
            EXPECT_EQ(again.flips.size(), 0U);
        }
        Surface surface = start;
        (void)optimise_by(surface, "area");
        multigraphs += audit(surface.triangulation()).is_simple().value() ? 0 : 1;
    }
    EXPECT_GT(multigraphs, 0);
}

TEST(Optimise, EmbeddedSurfacesStayEmbeddedWhereAsked) {
    int self_intersecting = 0;
    for (const FlipOrder order : {FlipOrder::first, FlipOrder::best}) {
        const Surface start = data_sets::skewed_cylinder(6);
        Surface surface = start;
        const OptimiseResult result =
            optimise_by(surface, "area", {.order = order, .allowed = AllowedFlips::embedded});
        EXPECT_TRUE(is_embedded(surface.view()));
        EXPECT_LT(result.after, result.before);
        const OptimiseResult again =
            optimise_by(surface, "area", {.allowed = AllowedFlips::embedded});
        EXPECT_EQ(again.flips.size(), 0U);
        Surface free = start;
        (void)optimise_by(free, "area", {.order = order});
        self_intersecting += is_embedded(free.view()) ? 0 : 1;
    }
    EXPECT_GT(self_intersecting, 0);
}

TEST(Optimise, ASeedChoosesTheOrder) {
    const Surface start = with_random_points(kernel::families::random(60, 0, 4), 6);
    const auto flips = [&](std::uint64_t seed) {
        Surface surface = start;
        return optimise_by(surface, "mean", {.seed = seed}).flips;
    };
    EXPECT_EQ(flips(7), flips(7));
    EXPECT_NE(flips(7), flips(8));
    EXPECT_NE(flips(7), flips(0));
}

TEST(Optimise, LawsonsProcedureMakesHeightsDelaunay) {
    HeightGrid grid = random_height_grid(8, 2);
    const auto lifted =
        make_criterion(CriterionKind::delaunay_plane, grid.surface.view(), grid.marked);
    const OptimiseResult result =
        optimise(grid.surface.triangulation(), grid.surface.points(), *lifted);
    EXPECT_GT(result.flips.size(), 0U);
    const auto fresh =
        make_criterion(CriterionKind::delaunay_plane, grid.surface.view(), grid.marked);
    for (Index e = 0; e < grid.surface.triangulation().edge_count(); ++e)
        EXPECT_GE(fresh->change(Edge{e}).first(), 0);
}

}  // namespace
}  // namespace tightflip::geometry
