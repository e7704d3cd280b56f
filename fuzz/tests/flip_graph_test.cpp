#include "targets/flip_graph.hpp"

#include "bytes.hpp"
#include "targets.hpp"
#include <tightflip/kernel/random.hpp>

#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using kernel::States;

TEST(FlipGraphInput, IsSizeEffortThreadsAndSeed) {
    const FlipGraphCase graph = decode_flip_graph(InputBytes{1, 3, 2, 1, 4, 1});
    EXPECT_EQ(graph.request.vertices, 6);
    EXPECT_EQ(graph.request.genus, 0);
    EXPECT_EQ(graph.request.states, States::classes);
    EXPECT_EQ(graph.request.distances, kernel::DistanceEffort::extremes);
    EXPECT_EQ(graph.threads, 2U);
    EXPECT_EQ(graph.seed, 260U);
    EXPECT_EQ(decode_flip_graph({}).request.vertices, 3);
}

TEST(FlipGraph, HoldsForAnyBytesInAnyOrder) {
    // What is kept of a size must not depend on which of its inputs came first.
    kernel::RandomStream random(3);
    for (int k = 0; k < 40; ++k) {
        InputBytes bytes{format_version};
        for (int i = 0; i < 5; ++i)
            bytes.push_back(static_cast<std::uint8_t>(random.bits()));
        ASSERT_EQ(flip_graph_objection(decode_flip_graph(bytes)), "") << k;
    }
}

TEST(FlipGraphSeeds, AreOfEveryKindOfStateAndSeveralGenera) {
    std::set<States> states;
    std::set<kernel::Index> genera;
    std::set<bool> simple;
    for (const Seed& seed : flip_graph_target.seeds()) {
        const auto request = decode_flip_graph(seed.bytes).request;
        states.insert(request.states);
        genera.insert(request.genus);
        simple.insert(request.simple_only);
    }
    EXPECT_EQ(states.size(), 3U);
    EXPECT_EQ(genera, (std::set<kernel::Index>{0, 1, 2}));
    EXPECT_EQ(simple.size(), 2U);
}

}  // namespace
}  // namespace tightflip::fuzz
