#include "disguises.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip_graph.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

constexpr Equality oriented{Labels::ignored, Mirror::distinct};
constexpr Equality unoriented{Labels::ignored, Mirror::identified};
constexpr Equality labelled{Labels::kept, Mirror::distinct};

/// Distances from a state to all that can be reached.
std::map<CanonicalCode, int> distances_from(const FlipGraph& graph, const CanonicalCode& start) {
    std::map<CanonicalCode, int> distance{{start, 0}};
    std::vector<CanonicalCode> queue{start};
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const int next = distance.at(queue[i]) + 1;
        for (const CanonicalCode& state : graph.neighbours(queue[i])) {
            if (distance.emplace(state, next).second) queue.push_back(state);
        }
    }
    return distance;
}

int diameter(const FlipGraph& graph, const CanonicalCode& start) {
    int most = 0;
    for (const auto& [state, from_start] : distances_from(graph, start)) {
        for (const auto& [other, distance] : distances_from(graph, state)) {
            most = std::max(most, distance);
        }
    }
    return most;
}

struct Case {
    const char* name;
    FlipGraph graph;
    Triangulation start;
    std::size_t states;
    int diameter;
};

TEST(FlipGraph, HasTheKnownStatesAndDiameters) {
    const std::vector<Case> cases{
        {"two faces", FlipGraph(oriented), families::book(3), 1, 0},
        {"classes of 5", FlipGraph(oriented), families::book(5), 4, 2},
        {"classes of 6", FlipGraph(oriented), families::book(6), 14, 4},
        {"classes of 7, mirror images identified", FlipGraph(unoriented), families::book(7), 54, 7},
        {"labelled, 4", FlipGraph(labelled), families::book(4), 8, 2},
        {"labelled, 5", FlipGraph(labelled), families::book(5), 160, 6},
        {"torus of 3: nothing can be flipped", FlipGraph(oriented),
         families::surface_of_genus(1, 3, 0), 1, 0}};
    for (const auto& [name, graph, start, states, expected] : cases) {
        EXPECT_EQ(distances_from(graph, graph.state(start)).size(), states) << name;
        EXPECT_EQ(diameter(graph, graph.state(start)), expected) << name;
    }
}

/// OEIS A000109; connected by flips that keep the graph simple (Wagner 1936).
TEST(FlipGraph, OfSimpleGraphsHasThoseAlone) {
    const FlipGraph graph(unoriented, true);
    for (const auto& [vertices, classes] :
         {std::pair<Index, std::size_t>{4, 1}, {5, 1}, {6, 2}, {7, 5}, {8, 14}}) {
        const auto reached = distances_from(graph, graph.state(families::stacked(vertices, 1)));
        EXPECT_EQ(reached.size(), classes) << vertices << " vertices";
        for (const auto& [state, distance] : reached) {
            EXPECT_EQ(audit(surface_of(state)).is_simple(), true);
        }
    }
    EXPECT_THROW(static_cast<void>(graph.state(families::book(5))), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(graph.state(families::book(3))), std::invalid_argument);
}

TEST(FlipGraph, HasAnArcForEveryLegalFlip) {
    RandomStream random(2);
    for (const Equality equality : {oriented, unoriented, labelled}) {
        const FlipGraph graph(equality);
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            const Triangulation surface =
                testing::renumbered(families::random(9, seed % 2 == 0 ? 0 : 1, seed), random);
            std::vector<CanonicalCode> expected;
            for (Index e = 0; e < surface.edge_count(); ++e) {
                Triangulation flipped = surface;
                if (flipped.flip({e})) expected.push_back(graph.state(flipped));
            }
            std::vector<CanonicalCode> found = graph.neighbours(graph.state(surface));
            std::ranges::sort(expected);
            std::ranges::sort(found);
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(FlipGraph, RefusesCodesOfAnotherEquality) {
    const FlipGraph graph(oriented);
    const Triangulation surface = families::book(4);
    EXPECT_THROW(static_cast<void>(graph.neighbours(canonical_code(surface, unoriented))),
                 std::invalid_argument);
    EXPECT_EQ(graph.neighbours(graph.state(surface)).size(), 2U);
}

}  // namespace
}  // namespace tightflip::kernel
