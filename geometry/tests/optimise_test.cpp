#include "height_grid.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/composed_criteria.hpp>
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/geometry/optimise.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/random_flips.hpp>

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

/// Optimises: the energy falls with each flip, no flip improves at the end, and the flips lead
/// there.
OptimiseResult expect_plain_search(const Surface& start, std::string_view name, FlipOrder order) {
    SCOPED_TRACE(testing::Message() << name << (order == FlipOrder::best ? ", best" : ", first"));
    Surface surface = start;
    Energy last = parse_criterion(name, surface.view())->value();
    OptimiseResult result = optimise_by(
        surface, name, {.order = order, .keep_going = [&](std::int64_t, const Energy& now) {
                            EXPECT_LT(now, last);
                            last = now;
                            return true;
                        }});
    EXPECT_EQ(result.end, OptimiseEnd::local_minimum);
    EXPECT_NEAR(last.first(), result.after.first(), 1e-9 * (1 + std::abs(result.before.first())));
    expect_local_minimum(surface, name);
    Triangulation replayed = start.triangulation();
    for (const Edge e : result.flips)
        EXPECT_TRUE(replayed.flip(e));
    EXPECT_EQ(replayed, surface.triangulation());
    return result;
}

TEST(Optimise, EndsInALocalMinimumThatItsFlipsLeadTo) {
    const Surface start = with_random_points(kernel::families::random(40, 0, 3), 5);
    for (const FlipOrder order : {FlipOrder::first, FlipOrder::best}) {
        for (const std::string_view name : criteria) {
            const OptimiseResult result = expect_plain_search(start, name, order);
            EXPECT_GT(result.flips.size(), 5U) << name;
            EXPECT_LT(result.after, result.before) << name;
        }
    }
}

TEST(Optimise, TheEnergyOfNoSurfaceRises) {
    for (const FlipOrder order : {FlipOrder::first, FlipOrder::best}) {
        for (const std::string_view name : criteria) {
            std::uint64_t seed = 0;
            for (const Triangulation& family : all_families()) {
                ++seed;
                expect_plain_search(with_random_points(family, seed), name, order);
                expect_plain_search(with_grid_points(family, seed, 2), name, order);
            }
        }
    }
}

/// The same surface with its edges in another order, turned about at random, and other labels.
Surface disguised(const Surface& surface, std::uint64_t seed) {
    const Triangulation& t = surface.triangulation();
    kernel::RandomStream random(seed);
    const auto shuffled = [&](Index count) {
        std::vector<Index> order(static_cast<std::size_t>(count));
        for (Index i = 0; i < count; ++i)
            order[static_cast<std::size_t>(i)] = i;
        random.shuffle(std::span(order));
        return order;
    };
    std::vector<Index> halfedges(static_cast<std::size_t>(t.halfedge_count()));
    const std::vector<Index> edges = shuffled(t.edge_count());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto side = static_cast<Index>(random.below(2));
        halfedges[2 * e] = 2 * edges[e] + side;
        halfedges[2 * e + 1] = 2 * edges[e] + 1 - side;
    }
    std::vector<kernel::HalfedgeRecord> records(halfedges.size());
    for (std::size_t h = 0; h < halfedges.size(); ++h) {
        kernel::HalfedgeRecord record = t.table()[h];
        record.next.id = halfedges[static_cast<std::size_t>(record.next.id)];
        records[static_cast<std::size_t>(halfedges[h])] = record;
    }
    const Surface renumbered(kernel::build(std::move(records), t.vertex_count()).value(),
                             {surface.points().begin(), surface.points().end()});
    return relabelled(renumbered, shuffled(t.vertex_count()));
}

TEST(Optimise, BestFirstEndsTheSameWhateverTheNumbers) {
    // Points in general position and no parallel edges: nothing ties.
    Surface start = data_sets::random_sphere(80, 3);
    kernel::flip_at_random(start.triangulation(), {.count = 160, .seed = 3, .simple = true});
    const Surface other = disguised(start, 7);
    EXPECT_NE(other.triangulation(), start.triangulation());
    for (const std::string_view name :
         {"mean", "mean_weighted", "area", "edge_length", "volume", "abn_squares", "delaunay"}) {
        const auto ended = [&](Surface surface) {
            const OptimiseResult result = optimise_by(
                surface, name, {.order = FlipOrder::best, .allowed = AllowedFlips::simple});
            return std::pair(result.flips.size(), result.after);
        };
        const auto [flips, after] = ended(start);
        const auto [other_flips, other_after] = ended(other);
        EXPECT_EQ(flips, other_flips) << name;
        EXPECT_GT(flips, 20U) << name;
        EXPECT_EQ(after.levels[0] == 0, other_after.levels[0] == 0) << name;
        for (std::size_t level = 0; level < Energy::max_levels; ++level) {
            EXPECT_NEAR(after.levels[level], other_after.levels[level],
                        1e-9 * std::abs(after.levels[level]))
                << name;
        }
    }
}

TEST(Optimise, BestDoesWhatImprovesMost) {
    Surface surface = with_random_points(kernel::families::random(30, 0, 3), 5);
    Surface followed = surface;
    const OptimiseResult result = optimise_by(surface, "area", {.order = FlipOrder::best});
    ASSERT_GT(result.flips.size(), 10U);
    for (const Edge done : result.flips) {
        const auto criterion = parse_criterion("area", followed.view());
        const double change = criterion->change(done).first();
        for (Index e = 0; e < followed.triangulation().edge_count(); ++e) {
            if (!followed.triangulation().can_flip(Edge{e})) continue;
            EXPECT_LE(change, criterion->change(Edge{e}).first() + 1e-9) << "edge " << e;
        }
        ASSERT_TRUE(followed.triangulation().flip(done));
    }
}

TEST(Optimise, TracesTheEnergy) {
    const Surface start = with_random_points(kernel::families::random(40, 0, 3), 5);
    for (const FlipOrder order : {FlipOrder::first, FlipOrder::best}) {
        std::vector<EnergyAt> all;
        Surface surface = start;
        const OptimiseResult result = optimise_by(
            surface, "area",
            {.order = order, .keep_going = [&](std::int64_t flips, const Energy& energy) {
                 all.push_back({flips, energy});
                 return true;
             }});
        EXPECT_TRUE(result.trace.empty());
        all.insert(all.begin(), {0, result.before});
        const auto flips = static_cast<std::int64_t>(result.flips.size());
        for (const std::int64_t every : {std::int64_t{1}, std::int64_t{7}, flips, 10 * flips}) {
            std::vector<EnergyAt> expected;
            for (const EnergyAt& at : all) {
                if (at.flips % every == 0 || at.flips == flips) expected.push_back(at);
            }
            surface = start;
            EXPECT_EQ(optimise_by(surface, "area", {.order = order, .trace_every = every}).trace,
                      expected);
        }
        // Of a local minimum, which is where this has led, there is one energy.
        const auto again = optimise_by(surface, "area", {.trace_every = 1});
        ASSERT_EQ(again.trace.size(), 1U);
        EXPECT_EQ(again.trace.front(), (EnergyAt{0, again.before}));
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

/// Says of every flip that it improves, and never does.
class FalsePromise final : public Criterion {
public:
    explicit FalsePromise(Energy value) : value_(value) {}

    [[nodiscard]] Energy value() const override { return value_; }
    [[nodiscard]] Energy change(Edge /*e*/) override { return -1; }
    void flipped(Edge /*e*/) override { ++reports; }
    void append_affected(Edge e, std::vector<Edge>& edges) const override { edges.push_back(e); }

    int reports = 0;

private:
    Energy value_;
};

TEST(Optimise, EndsWhereChangesPromiseWhatValuesDoNotKeep) {
    for (const FlipOrder order : {FlipOrder::first, FlipOrder::best}) {
        Surface surface = octahedron();
        const Triangulation start = surface.triangulation();
        FalsePromise criterion(7.0);
        const OptimiseResult result = optimise(surface.triangulation(), surface.points(), criterion,
                                               {.order = order, .trace_every = 1});
        EXPECT_EQ(result.end, OptimiseEnd::local_minimum);
        EXPECT_TRUE(result.flips.empty());
        EXPECT_EQ(surface.triangulation(), start);
        EXPECT_GT(criterion.reports, 0);
        EXPECT_EQ(result.trace.back(), (EnergyAt{0, 7.0}));
    }
}

}  // namespace
}  // namespace tightflip::geometry
