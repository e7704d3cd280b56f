#include "targets/optimise.hpp"

#include "targets.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using geometry::AllowedFlips;
using geometry::FlipOrder;
using geometry::Strategy;

TEST(OptimiseInput, IsSurfaceCriterionStrategyOptionsAndLockedEdges) {
    const OptimiseCase run =
        decode_optimise(InputBytes{1, 0, 0, 0, 0, 1, 7, 3, 2, 4, 5, 2, 0, 7, 0});
    EXPECT_EQ(run.surface.start().triangulation().vertex_count(), 4);
    EXPECT_EQ(run.surface.point_kind, &properties::point_kinds()[1]);
    EXPECT_EQ(run.surface.point_seed, 7U);
    EXPECT_EQ(run.criterion, "area");
    EXPECT_EQ(run.strategy, Strategy::look_ahead);
    EXPECT_EQ(run.options.allowed, AllowedFlips::simple);
    EXPECT_EQ(run.options.order, FlipOrder::best);
    EXPECT_EQ(run.options.max_flips, 10);
    EXPECT_EQ(run.locked, (std::vector<kernel::Edge>{{2}, {1}}));
}

TEST(OptimiseInput, KeepsRunsShort) {
    const OptimiseCase run = decode_optimise(InputBytes(200, 255));
    EXPECT_LE(run.locked.size(), most_locked_edges);
    EXPECT_EQ(run.options.max_flips, 64);
    const auto kinds = properties::start_kinds();
    for (std::uint8_t kind = 0; kind < kinds.size(); ++kind) {
        for (std::uint8_t genus = 0; genus < 4; ++genus) {
            const OptimiseCase largest = decode_optimise(InputBytes{1, kind, 8, genus, 1});
            const kernel::Index most =
                std::max(6, kinds[kind].least_vertices(kinds[kind].any_genus ? genus : 0));
            EXPECT_LE(largest.surface.start().triangulation().vertex_count(), most);
        }
    }
}

TEST(OptimiseSeeds, AskForEveryCriterionStrategyAndKindOfPoints) {
    std::set<std::string> criteria;
    std::set<Strategy> strategies;
    std::set<std::string_view> points;
    std::set<AllowedFlips> allowed;
    for (const Seed& seed : optimise_target.seeds()) {
        const OptimiseCase run = decode_optimise(seed.bytes);
        criteria.insert(run.criterion);
        strategies.insert(run.strategy);
        points.insert(run.surface.point_kind->name);
        allowed.insert(run.options.allowed);
    }
    EXPECT_GE(criteria.size(), 13U);
    EXPECT_EQ(strategies.size(), geometry::all_strategies().size());
    EXPECT_EQ(points.size(), properties::point_kinds().size());
    EXPECT_EQ(allowed.size(), 3U);
}

}  // namespace
}  // namespace tightflip::fuzz
