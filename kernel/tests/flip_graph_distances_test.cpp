#include <tightflip/kernel/flip_graph_distances.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::ElementsAre;
using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

FlipGraphTable graph_of(std::size_t states, const Edges& edges) {
    std::vector<std::vector<std::uint32_t>> rows(states);
    for (const auto& [a, b] : edges) {
        rows[a].push_back(b);
        rows[b].push_back(a);
    }
    FlipGraphTable graph;
    for (const auto& row : rows) {
        graph.targets.insert(graph.targets.end(), row.begin(), row.end());
        graph.offsets.push_back(graph.targets.size());
    }
    return graph;
}

/// A tree with some edges more.
FlipGraphTable random_graph(std::uint32_t states, std::uint32_t more, std::uint64_t seed) {
    RandomStream random(seed);
    Edges edges;
    for (std::uint32_t i = 1; i < states; ++i)
        edges.emplace_back(random.below(i), i);
    for (std::uint32_t i = 0; i < more; ++i) {
        edges.emplace_back(random.below(states), random.below(states));
    }
    return graph_of(states, edges);
}

std::vector<Distance> all_eccentricities(const FlipGraphTable& graph) {
    std::vector<Distance> result;
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        const auto distances = distances_from(graph, i);
        result.push_back(*std::ranges::max_element(distances));
    }
    return result;
}

Eccentricities bound(const FlipGraphTable& graph, EccentricityGoal goal, unsigned threads = 1) {
    const auto search = [&](std::uint32_t source) {
        const auto distances = distances_from(graph, source);
        return Reach{distances, distances};
    };
    return bound_eccentricities(graph.size(), search, goal, threads);
}

TEST(DistancesFrom, CountArcs) {
    const FlipGraphTable graph = graph_of(6, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 4}});
    EXPECT_THAT(distances_from(graph, 0), ElementsAre(0, 1, 2, 1, 2, unreached));
}

TEST(ComponentsOf, AreNumberedByTheirLeastStates) {
    const FlipGraphTable graph = graph_of(6, {{4, 1}, {0, 3}, {3, 5}});
    const Components parts = components(graph);
    EXPECT_EQ(parts.count(), 3U);
    EXPECT_THAT(parts.of, ElementsAre(0, 1, 2, 0, 1, 0));
    EXPECT_THAT(parts.least, ElementsAre(0, 1, 2));
}

class BoundEccentricities : public ::testing::TestWithParam<std::uint32_t> {
protected:
    const FlipGraphTable graph = random_graph(60, GetParam() % 50, GetParam());
    const std::vector<Distance> truth = all_eccentricities(graph);
};

TEST_P(BoundEccentricities, ExtremesAreExact) {
    const Eccentricities found = bound(graph, EccentricityGoal::extremes);
    EXPECT_EQ(found.radius, *std::ranges::min_element(truth));
    EXPECT_EQ(found.diameter, *std::ranges::max_element(truth));
    std::vector<std::uint32_t> outermost;
    for (std::uint32_t i = 0; i < truth.size(); ++i) {
        EXPECT_LE(found.lower[i], truth[i]);
        EXPECT_GE(found.upper[i], truth[i]);
        if (truth[i] == found.diameter) outermost.push_back(i);
    }
    EXPECT_EQ(found.peripheral(), outermost);
}

TEST_P(BoundEccentricities, AllAreExactWhereAskedFor) {
    const Eccentricities found = bound(graph, EccentricityGoal::all);
    EXPECT_EQ(found.lower, truth);
    EXPECT_EQ(found.upper, truth);
    const auto counts = found.counts();
    ASSERT_EQ(counts.size(), std::size_t{found.diameter} + 1);
    for (std::size_t e = 0; e < counts.size(); ++e) {
        EXPECT_EQ(static_cast<std::ptrdiff_t>(counts[e]),
                  std::ranges::count(truth, static_cast<Distance>(e)));
    }
}

TEST_P(BoundEccentricities, ThreadsDoNotMatter) {
    const Eccentricities one = bound(graph, EccentricityGoal::extremes, 1);
    const Eccentricities three = bound(graph, EccentricityGoal::extremes, 3);
    EXPECT_EQ(one.lower, three.lower);
    EXPECT_EQ(one.upper, three.upper);
    EXPECT_EQ(one.searches, three.searches);
}

INSTANTIATE_TEST_SUITE_P(Seeds, BoundEccentricities, ::testing::Range<std::uint32_t>(0, 40));

TEST(BoundEccentricitiesOnce, SparesSearchesOnAPath) {
    Edges path;
    for (std::uint32_t i = 1; i < 1000; ++i)
        path.emplace_back(i - 1, i);
    const Eccentricities found = bound(graph_of(1000, path), EccentricityGoal::extremes);
    EXPECT_EQ(found.diameter, 999);
    EXPECT_EQ(found.radius, 500);
    EXPECT_LT(found.searches, 20U);
}

TEST(BoundEccentricitiesOnce, ASingleStateIsItsOwnCentre) {
    const Eccentricities found = bound(graph_of(1, {}), EccentricityGoal::extremes);
    EXPECT_EQ(found.diameter, 0);
    EXPECT_EQ(found.radius, 0);
    EXPECT_THAT(found.peripheral(), ElementsAre(0));
}

/// States that stand for orbits: near and far differ. Four corners of a square by two, as two
/// orbits of a path a0 - b0 - b1 - a1: every a has eccentricity 3, every b 2.
TEST(BoundEccentricitiesOnce, FarDistancesCountWhereStatesAreOrbits) {
    const auto search = [](std::uint32_t source) {
        return source == 0 ? Reach{{0, 1}, {3, 2}} : Reach{{1, 0}, {2, 1}};
    };
    const Eccentricities found = bound_eccentricities(2, search, EccentricityGoal::all, 1);
    EXPECT_THAT(found.lower, ElementsAre(3, 2));
    EXPECT_THAT(found.upper, ElementsAre(3, 2));
}

}  // namespace
}  // namespace tightflip::kernel
