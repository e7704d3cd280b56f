#include "targets/flip_script.hpp"

#include "script_input.hpp"
#include "targets.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

std::vector<kernel::FlipLog> seed_logs() {
    std::vector<kernel::FlipLog> logs;
    for (const Seed& seed : flip_script_target.seeds())
        logs.push_back(decode_script(seed.bytes).log());
    return logs;
}

/// The least degree that any vertex has at any step.
kernel::Index least_degree(const kernel::FlipLog& log) {
    kernel::Triangulation surface = log.start;
    kernel::Index least = audit(surface).degrees->min;
    for (const kernel::Edge e : log.flips) {
        static_cast<void>(surface.flip(e));
        least = std::min(least, audit(surface).degrees->min);
    }
    return least;
}

TEST(FlipScriptSeeds, HaveBooksDegenerateFlipsRefusalsAndHigherGenus) {
    std::set<kernel::Index> genera;
    bool vertex_of_degree_two_made_and_unmade = false;
    bool refusal = false;
    bool torus_of_three = false;
    bool same_edge_four_times = false;
    for (const kernel::FlipLog& log : seed_logs()) {
        genera.insert(log.start.genus());
        torus_of_three |= log.start.genus() == 1 && log.start.vertex_count() == 3;
        kernel::Triangulation surface = log.start;
        for (const kernel::Edge e : log.flips)
            refusal |= !surface.flip(e);
        vertex_of_degree_two_made_and_unmade |= audit(log.start).degrees->min == 3 &&
                                                least_degree(log) == 2 &&
                                                audit(surface).degrees->min == 3;
        same_edge_four_times |=
            log.flips.size() == 4 && log.flips == std::vector(4, log.flips.front());
    }
    EXPECT_EQ(genera, (std::set<kernel::Index>{0, 1, 2, 3}));
    EXPECT_TRUE(vertex_of_degree_two_made_and_unmade);
    EXPECT_TRUE(refusal);
    EXPECT_TRUE(torus_of_three);
    EXPECT_TRUE(same_edge_four_times);
}

TEST(FlipScriptSeeds, HaveEveryKindOfStart) {
    std::set<std::string_view> kinds;
    for (const Seed& seed : flip_script_target.seeds())
        kinds.insert(decode_script(seed.bytes).kind->name);
    EXPECT_EQ(kinds.size(), properties::start_kinds().size());
}

}  // namespace
}  // namespace tightflip::fuzz
