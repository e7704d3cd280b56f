#include "height_grid.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/composed_criteria.hpp>
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/strategy.hpp>
#include <tightflip/geometry/surface_file.hpp>
#include <tightflip/kernel/audit.hpp>

#include <cmath>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

double energy(const Surface& surface, const std::string& criterion) {
    return parse_criterion(criterion, surface.view())->value().first();
}

/// After so many random flips a vertex.
Surface shaken(Surface surface, int flips, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    const auto edges = static_cast<std::uint32_t>(surface.triangulation().edge_count());
    for (Index i = 0; i < flips * surface.triangulation().vertex_count(); ++i)
        surface.triangulation().flip(Edge{static_cast<Index>(random.below(edges))});
    return surface;
}

StrategyResult run(Strategy strategy, Surface& surface, const std::string& criterion,
                   const OptimiseOptions& options = {}) {
    return optimise_by(strategy, surface.triangulation(), surface.points(), goal_by_text(criterion),
                       options);
}

double energy_after(Strategy strategy, Surface surface, const std::string& criterion) {
    return run(strategy, surface, criterion).after.first();
}

bool is_simple(const Triangulation& surface) {
    std::set<std::pair<Vertex, Vertex>> edges;
    for (Index h = 0; h < surface.halfedge_count(); ++h) {
        if (!edges.emplace(surface.origin({h}), surface.target({h})).second) return false;
    }
    return true;
}

/// What holds of every result: the flips lead from the start to the end, a valid surface of the
/// same genus, whose energy is the one that is said.
void expect_sound(const Surface& start, const Surface& end, const StrategyResult& result,
                  const std::string& criterion) {
    EXPECT_EQ(result.before.first(), energy(start, criterion));
    EXPECT_EQ(result.after.first(), energy(end, criterion));
    EXPECT_LE(result.after, result.before);
    Triangulation replayed = start.triangulation();
    for (const Edge e : result.flips)
        EXPECT_TRUE(replayed.flip(e));
    EXPECT_EQ(replayed, end.triangulation());
    EXPECT_TRUE(kernel::audit(end.triangulation()).is_valid());
    EXPECT_EQ(end.triangulation().genus(), start.triangulation().genus());
}

std::vector<Surface> starts() {
    return {shaken(data_sets::random_sphere(40, 3), 1, 1),
            with_random_points(kernel::families::random(30, 0, 5), 6),
            shaken(data_sets::bumpy_torus(48, 1), 2, 2),
            with_random_points(kernel::families::random(25, 2, 3), 4),
            with_grid_points(kernel::families::random(30, 0, 2), 9, 2),
            shaken(data_sets::cube_grid(26), 3, 3)};
}

TEST(Strategy, NamesAreFoundAndInOrder) {
    std::size_t i = 0;
    for (const StrategyInfo& info : all_strategies()) {
        EXPECT_EQ(static_cast<std::size_t>(info.strategy), i++);
        EXPECT_EQ(strategy_by_name(info.name), info.strategy);
        EXPECT_EQ(geometry::info(info.strategy).name, info.name);
        EXPECT_FALSE(info.description.empty());
    }
    EXPECT_EQ(i, 7U);
    EXPECT_FALSE(strategy_by_name("nothing"));
    EXPECT_EQ(strategy_by_name("hull"), Strategy::hull);
}

struct Search {
    std::string criterion;
    FlipOrder order = FlipOrder::first;
};

TEST(Strategy, NoneEndsAboveLocalSearch) {
    int better = 0;
    for (const auto& [criterion, order] :
         {Search{"tight"}, Search{"tight", FlipOrder::best}, Search{"area"}, Search{"delaunay"},
          Search{"tight,mean_weighted", FlipOrder::best}}) {
        for (const Surface& start : starts()) {
            Surface plain = start;
            const auto made = parse_criterion(criterion, plain.view());
            const double least =
                optimise(plain.triangulation(), plain.points(), *made, {.order = order})
                    .after.first();
            for (const StrategyInfo& info : all_strategies()) {
                SCOPED_TRACE(criterion + " " + std::string(info.name));
                Surface surface = start;
                const StrategyResult result =
                    run(info.strategy, surface, criterion, {.order = order});
                expect_sound(start, surface, result, criterion);
                if (result.refusal.fault != StrategyFault::none) continue;
                EXPECT_EQ(result.end, OptimiseEnd::local_minimum);
                EXPECT_LE(result.after.first(), least + 1e-12 * std::abs(least));
                better += result.after.first() < 0.99 * least ? 1 : 0;
                if (info.strategy != Strategy::local) continue;
                EXPECT_EQ(surface.triangulation(), plain.triangulation());
            }
        }
    }
    EXPECT_GT(better, 60);
}

TEST(Strategy, EachDoesWhatTheOneBeforeCannot) {
    // What local search leaves of the excess over the least energy known, from bad starts.
    const auto excess = [](Strategy strategy, const Surface& start, double least) {
        return energy_after(strategy, start, "tight") - least;
    };
    const Surface torus = data_sets::bumpy_torus(240, 2);
    const double least_torus = energy_after(Strategy::kicks, torus, "tight");
    const Surface bad_torus = shaken(torus, 1, 7);
    EXPECT_LT(excess(Strategy::look_ahead, bad_torus, least_torus),
              0.5 * excess(Strategy::local, bad_torus, least_torus));

    const Surface sphere = data_sets::bumpy_sphere(200, 2);
    const double least_sphere = energy_after(Strategy::kicks, sphere, "tight");
    EXPECT_LT(least_sphere, energy_after(Strategy::alternate, sphere, "tight"));
    const Surface bad_sphere = shaken(sphere, 10, 8);
    EXPECT_LT(excess(Strategy::alternate, bad_sphere, least_sphere),
              0.3 * excess(Strategy::look_ahead, bad_sphere, least_sphere));
    EXPECT_LT(excess(Strategy::star, bad_sphere, least_sphere), 0.02 * least_sphere);
    EXPECT_GT(excess(Strategy::look_ahead, bad_sphere, least_sphere), least_sphere);
}

TEST(Strategy, AutomaticEndsInTheHullWhereItIsWanted) {
    for (const std::string criterion : {"tight", "mean_weighted", "volume"}) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const Surface sphere = data_sets::random_ellipsoid(60, seed);
            Surface surface(kernel::families::random(60, 0, seed),
                            {sphere.points().begin(), sphere.points().end()});
            const StrategyResult result = run(Strategy::automatic, surface, criterion);
            EXPECT_EQ(result.used, Strategy::hull);
            EXPECT_TRUE(is_convex_surface(surface.view()));
        }
        Surface grid = shaken(data_sets::cube_grid(56), 5, 1);
        EXPECT_EQ(run(Strategy::automatic, grid, criterion).used, Strategy::hull);
        EXPECT_TRUE(is_convex_surface(grid.view(), FlatEdges::admitted));
    }
    // Inside out the hull has the same energy; it is turned all the same.
    const Surface tetrahedron = regular_tetrahedron();
    Surface reversed(kernel::build(Faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, 4).value(),
                     {tetrahedron.points().begin(), tetrahedron.points().end()});
    (void)run(Strategy::automatic, reversed, "tight");
    EXPECT_TRUE(is_convex_surface(reversed.view()));
    // Area wants another surface (Figure 4), which it also finds from the hull.
    Surface cylinder = data_sets::skewed_cylinder(8);
    const double hull_area = energy(cylinder, "area");
    EXPECT_NE(run(Strategy::automatic, cylinder, "area").used, Strategy::hull);
    EXPECT_LT(energy(cylinder, "area"), hull_area);
    Surface other = data_sets::skewed_cylinder(8);
    EXPECT_LT(run(Strategy::hull, other, "area").after.first(), hull_area);
}

TEST(Strategy, LockedEdgesAndAllowedFlipsAreKeptTo) {
    const Surface start = shaken(data_sets::bumpy_sphere(60, 1), 1, 4);
    std::vector<Edge> locked;
    for (Index e = 0; e < start.triangulation().edge_count(); e += 3)
        locked.push_back(Edge{e});
    const Surface tame = data_sets::skewed_cylinder(6);
    for (const StrategyInfo& info : all_strategies()) {
        SCOPED_TRACE(info.name);
        const bool needs_path = info.strategy == Strategy::star || info.strategy == Strategy::hull;
        Surface surface = start;
        const StrategyResult result = run(info.strategy, surface, "tight", {.locked = locked});
        EXPECT_EQ(result.refusal.fault,
                  needs_path ? StrategyFault::locked_edges : StrategyFault::none);
        EXPECT_EQ(result.flips.empty(), needs_path);
        for (const Edge e : result.flips)
            EXPECT_NE(e.id % 3, 0);

        for (const AllowedFlips allowed : {AllowedFlips::simple, AllowedFlips::embedded}) {
            Surface kept = tame;
            const StrategyResult kept_result =
                run(info.strategy, kept, "area", {.allowed = allowed});
            EXPECT_EQ(kept_result.refusal.fault,
                      needs_path ? StrategyFault::restricted_flips : StrategyFault::none);
            EXPECT_TRUE(is_simple(kept.triangulation()));
            EXPECT_TRUE(allowed == AllowedFlips::simple || is_embedded(kept.view()));
        }
    }
    Surface free = tame;
    (void)run(Strategy::alternate, free, "area");
    EXPECT_FALSE(is_embedded(free.view()));
}

TEST(Strategy, RefusalsAreValuesThatSayWhatWouldHelp) {
    const auto refusal = [](Strategy strategy, Surface surface) {
        const Surface before = surface;
        const StrategyResult result = run(strategy, surface, "tight");
        EXPECT_EQ(surface.triangulation(), before.triangulation());
        EXPECT_EQ(result.after, result.before);
        EXPECT_THAT(message(result.refusal), testing::HasSubstr("take another strategy"));
        return result.refusal;
    };
    for (const Strategy strategy : {Strategy::star, Strategy::hull}) {
        EXPECT_EQ(refusal(strategy, data_sets::bumpy_torus(36, 1)).fault,
                  StrategyFault::not_a_sphere);
    }
    const StrategyRefusal inside = refusal(Strategy::hull, data_sets::bumpy_sphere(50, 1));
    EXPECT_EQ(inside.fault, StrategyFault::data);
    EXPECT_EQ(inside.data.fault, DataFault::interior_point);
    EXPECT_EQ(refusal(Strategy::star, with_grid_points(kernel::families::random(40, 0, 1), 1, 1))
                  .data.fault,
              DataFault::shared_direction);
    EXPECT_EQ(message(StrategyRefusal{}), "");
    EXPECT_THAT(message({StrategyFault::too_flat}), testing::HasSubstr("flat"));
}

TEST(Strategy, LimitsAreForTheWhole) {
    const Surface start = shaken(data_sets::bumpy_sphere(80, 1), 3, 4);
    const double plain = energy_after(Strategy::local, start, "tight");
    for (const StrategyInfo& info : all_strategies()) {
        if (info.strategy == Strategy::hull) continue;
        SCOPED_TRACE(info.name);
        for (const std::int64_t most : {0, 10, 1000, 20000}) {
            Surface surface = start;
            std::int64_t last = 0;
            Energy least = energy(start, "tight");
            const StrategyResult result =
                run(info.strategy, surface, "tight",
                    {.max_flips = most, .keep_going = [&](std::int64_t flips, const Energy& now) {
                         EXPECT_TRUE(flips == last || flips == last + 1);
                         EXPECT_LE(now, least);
                         last = flips;
                         least = now;
                         return true;
                     }});
            EXPECT_LE(last, most);
            EXPECT_LE(static_cast<std::int64_t>(result.flips.size()), last);
            expect_sound(start, surface, result, "tight");
            EXPECT_NEAR(least.first(), result.after.first(), 1e-9);
            EXPECT_TRUE(most > 10 || result.end == OptimiseEnd::flip_limit);
            EXPECT_TRUE(most < 1000 || result.after.first() <= plain + 1e-9);
        }
        for (const int calls_allowed : {1, 200, 1500}) {
            if (info.strategy == Strategy::local && calls_allowed > 200) continue;
            Surface surface = start;
            int calls = 0;
            const StrategyResult result = run(info.strategy, surface, "tight",
                                              {.keep_going = [&](std::int64_t, const Energy&) {
                                                  return ++calls < calls_allowed;
                                              }});
            EXPECT_EQ(result.end, OptimiseEnd::stopped);
            EXPECT_EQ(calls, calls_allowed);
            expect_sound(start, surface, result, "tight");
        }
        Surface late = start;
        EXPECT_EQ(run(info.strategy, late, "tight", {.max_time = std::chrono::seconds(-1)}).end,
                  OptimiseEnd::time_limit);
        EXPECT_EQ(late.triangulation(), start.triangulation());
    }
    // Too few flips for the path to the hull are still enough for something.
    const Surface convex = shaken(data_sets::random_sphere(200, 1), 3, 1);
    Surface surface = convex;
    const StrategyResult result = run(Strategy::automatic, surface, "tight", {.max_flips = 60});
    EXPECT_EQ(result.end, OptimiseEnd::flip_limit);
    EXPECT_EQ(result.flips.size(), 60U);
    expect_sound(convex, surface, result, "tight");
}

TEST(Strategy, TheSeedChooses) {
    const Surface start = shaken(data_sets::bumpy_torus(60, 1), 1, 4);
    for (const StrategyInfo& info : all_strategies()) {
        const auto flips = [&](std::uint64_t seed) {
            Surface surface = start;
            return run(info.strategy, surface, "mean", {.seed = seed}).flips;
        };
        EXPECT_EQ(flips(7), flips(7)) << info.name;
        const bool has_one_order = info.strategy == Strategy::local ||
                                   info.strategy == Strategy::look_ahead ||
                                   info.strategy == Strategy::alternate;
        if (!has_one_order) continue;
        EXPECT_NE(flips(7), flips(8)) << info.name;
    }
}

TEST(Strategy, TheTraceIsThatOfTheWantedCriterionAlongTheFlips) {
    const Surface start = shaken(data_sets::bumpy_sphere(100, 1), 5, 4);
    Surface surface = start;
    const StrategyResult result =
        run(Strategy::automatic, surface, "mean_weighted", {.trace_every = 50});
    ASSERT_GT(result.trace.size(), 3U);
    Surface along = start;
    std::size_t done = 0;
    for (const EnergyAt& at : result.trace) {
        for (; static_cast<std::int64_t>(done) < at.flips; ++done)
            along.triangulation().flip(result.flips[done]);
        EXPECT_NEAR(at.energy.first(), energy(along, "mean_weighted"), 1e-9);
    }
    EXPECT_EQ(done, result.flips.size());
    EXPECT_EQ(run(Strategy::alternate, along, "mean_weighted").trace.size(), 0U);
}

TEST(Strategy, HeightFieldsStayHeightFields) {
    for (const std::string criterion : {"jnd", "bending", "delaunay_plane", "tight"}) {
        SCOPED_TRACE(criterion);
        HeightGrid grid = random_height_grid(7, 2);
        Surface plain = grid.surface;
        const Goal goal = goal_by_text(criterion, grid.marked);
        const StrategyResult local =
            optimise_by(Strategy::local, plain.triangulation(), plain.points(), goal);
        for (const Strategy strategy : {Strategy::alternate, Strategy::kicks}) {
            Surface surface = grid.surface;
            const StrategyResult result =
                optimise_by(strategy, surface.triangulation(), surface.points(), goal);
            EXPECT_EQ(result.refusal.fault, StrategyFault::none);
            EXPECT_GT(result.flips.size(), 0U);
            EXPECT_LE(result.after.first(), local.after.first() + 1e-9);
            // The criterion wants every face seen from above.
            if (criterion != "tight") {
                EXPECT_NO_THROW((void)parse_criterion("jnd", surface.view(), grid.marked));
            }
        }
        Surface surface = grid.surface;
        EXPECT_EQ(optimise_by(Strategy::star, surface.triangulation(), surface.points(), goal)
                      .refusal.fault,
                  StrategyFault::restricted_flips);
    }
}

/// Well-known models, where they are at hand.
class OptimisedModel : public testing::TestWithParam<std::string> {};

TEST_P(OptimisedModel, KeepsItsTopologyUnderEveryCriterion) {
    const auto path = std::filesystem::path(TIGHTFLIP_MESHES) / GetParam();
    if (!exists(path)) GTEST_SKIP() << path << " is not here";
    const Surface start = read_surface_file(path);
    for (const CriterionInfo& criterion : all_criteria()) {
        if (criterion.needs_heights) continue;
        SCOPED_TRACE(criterion.name);
        const std::string name(criterion.name);
        Surface plain = start;
        const StrategyResult local = run(Strategy::local, plain, name);
        EXPECT_EQ(local.end, OptimiseEnd::local_minimum);
        expect_sound(start, plain, local, name);
        EXPECT_LT(local.after, local.before);
        Surface surface = start;
        const StrategyResult result = run(Strategy::automatic, surface, name,
                                          {.max_flips = 2 * start.triangulation().edge_count()});
        expect_sound(start, surface, result, name);
        EXPECT_LE(result.after.first(), local.after.first());
    }
}

INSTANTIATE_TEST_SUITE_P(Models, OptimisedModel,
                         testing::Values("spot.obj", "fandisk.obj", "rocker-arm.obj"),
                         [](const auto& test) {
                             return test.param.substr(0, test.param.find_first_of(".-"));
                         });

}  // namespace
}  // namespace tightflip::geometry
