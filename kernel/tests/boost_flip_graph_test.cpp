#include <tightflip/kernel/boost_flip_graph.hpp>
#include <tightflip/kernel/families.hpp>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/pending/queue.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<FlipGraph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<FlipGraph>));
BOOST_CONCEPT_ASSERT(
    (boost::ReadWritePropertyMapConcept<StateMap<boost::default_color_type>, CanonicalCode>));
BOOST_CONCEPT_ASSERT((boost::LvaluePropertyMapConcept<StateMap<int>, CanonicalCode>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<StateIndexMap, CanonicalCode>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<FlipGraphTableView>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<FlipGraphTableView>));
BOOST_CONCEPT_ASSERT((boost::VertexAndEdgeListGraphConcept<FlipGraphTableView>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<FlipGraphTableView>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<FlipGraphTableView>));
BOOST_CONCEPT_ASSERT((
    boost::ReadablePropertyGraphConcept<FlipGraphTableView, std::uint32_t, boost::vertex_index_t>));

constexpr Equality oriented{Labels::ignored, Mirror::distinct};
constexpr Equality unoriented{Labels::ignored, Mirror::identified};
constexpr Equality labelled{Labels::kept, Mirror::distinct};
constexpr int infinity = std::numeric_limits<int>::max();

// ---- the implicit graph ----

/// Distances from a state, by Boost's breadth-first search.
StateMap<int> distances_from(const FlipGraph& graph, const CanonicalCode& start) {
    StateMap<int> distance(infinity);
    put(distance, start, 0);
    boost::queue<CanonicalCode> pending;
    boost::breadth_first_visit(
        graph, start, pending,
        boost::make_bfs_visitor(boost::record_distances(distance, boost::on_tree_edge())),
        StateMap<boost::default_color_type>(boost::white_color));
    return distance;
}

/// No flip changes more than four degrees, nor any by more than one.
class DegreeHeuristic {
public:
    explicit DegreeHeuristic(const CanonicalCode& goal) : goal_(degrees(goal)) {}

    int operator()(const CanonicalCode& state) const {
        const std::vector<int> here = degrees(state);
        int difference = 0;
        for (std::size_t i = 0; i < here.size(); ++i)
            difference += std::abs(here[i] - goal_[i]);
        return (difference + 3) / 4;
    }

private:
    static std::vector<int> degrees(const CanonicalCode& state) {
        std::vector<int> degree(static_cast<std::size_t>(state.vertex_count()), 0);
        const Triangulation surface = surface_of(state);
        for (const auto& record : surface.table())
            ++degree[static_cast<std::size_t>(record.origin.id)];
        std::ranges::sort(degree);
        return degree;
    }

    std::vector<int> goal_;
};

struct GoalReached {};

template <class Vertex>
class StopAtGoal : public boost::default_astar_visitor {
public:
    explicit StopAtGoal(Vertex goal) : goal_(std::move(goal)) {}
    template <class Graph>
    void examine_vertex(const Vertex& state, const Graph&) {
        if (state == goal_) throw GoalReached{};
    }

private:
    Vertex goal_;
};

/// The distance that A* finds, and that its predecessors lead all the way along arcs.
int distance_by_astar(const FlipGraph& graph, const CanonicalCode& start,
                      const CanonicalCode& goal) {
    const StateMap<CanonicalCode> predecessor;
    const StateMap<int> distance(infinity);
    const StateMap<int> cost(infinity);
    const DegreeHeuristic heuristic(goal);
    put(predecessor, start, start);
    put(distance, start, 0);
    put(cost, start, heuristic(start));
    try {
        boost::astar_search_no_init(graph, start, heuristic, StopAtGoal<CanonicalCode>(goal),
                                    predecessor, cost, distance, boost::static_property_map<int>(1),
                                    StateMap<boost::default_color_type>(boost::white_color),
                                    StateIndexMap{}, std::less<>{}, std::plus<>{}, infinity, 0);
        ADD_FAILURE() << "the goal was not reached";
    } catch (const GoalReached&) {
    }
    int steps = 0;
    for (CanonicalCode state = goal; state != start; state = get(predecessor, state)) {
        const auto [near, near_end] = adjacent_vertices(get(predecessor, state), graph);
        EXPECT_NE(std::find(near, near_end, state), near_end);
        ++steps;
    }
    EXPECT_EQ(steps, get(distance, goal));
    return steps;
}

TEST(ImplicitFlipGraph, ArcsAreFlips) {
    const FlipGraph graph(oriented);
    const CanonicalCode state = graph.state(families::random(7, 0, 1));
    const auto neighbours = graph.neighbours(state);
    const auto [arc, arc_end] = out_edges(state, graph);
    const auto [near, near_end] = adjacent_vertices(state, graph);
    EXPECT_EQ(out_degree(state, graph), neighbours.size());
    EXPECT_THAT(std::vector<CanonicalCode>(near, near_end),
                ::testing::ElementsAreArray(neighbours));
    ASSERT_EQ(static_cast<std::size_t>(arc_end - arc), neighbours.size());
    std::size_t number = 0;
    for (auto it = arc; it != arc_end; ++it, ++number) {
        EXPECT_EQ(source(*it, graph), state);
        EXPECT_EQ(target(*it, graph), neighbours[number]);
        EXPECT_EQ((*it).number(), number);
        EXPECT_EQ(*it,
                  *std::next(out_edges(state, graph).first, static_cast<std::ptrdiff_t>(number)));
        EXPECT_FALSE(*it == FlipArc{});
    }
}

TEST(ImplicitFlipGraph, BreadthFirstVisitFindsAllStates) {
    struct Case {
        Equality equality;
        Index vertices;
        std::size_t states;
        int diameter;
    };
    for (const auto& [equality, vertices, states, diameter] :
         {Case{oriented, 5, 4, 2}, Case{oriented, 6, 14, 4}, Case{unoriented, 7, 54, 7},
          Case{labelled, 4, 8, 2}, Case{labelled, 5, 160, 6}}) {
        const FlipGraph graph(equality);
        // The book is a peripheral state: one of its distances is the diameter.
        const CanonicalCode start = graph.state(families::book(vertices));
        const StateMap<int> distance = distances_from(graph, start);
        EXPECT_EQ(distance.size(), states);
        int most = 0;
        std::vector<CanonicalCode> pending{start};
        std::set<CanonicalCode> seen{start};
        for (std::size_t i = 0; i < pending.size(); ++i) {
            most = std::max(most, get(distance, pending[i]));
            for (const CanonicalCode& state : graph.neighbours(pending[i])) {
                EXPECT_LE(get(distance, state), get(distance, pending[i]) + 1);
                if (seen.insert(state).second) pending.push_back(state);
            }
        }
        EXPECT_EQ(seen.size(), states);
        EXPECT_EQ(most, diameter);
    }
}

TEST(ImplicitFlipGraph, AStarFindsShortestPaths) {
    for (const Equality equality : {unoriented, labelled}) {
        const FlipGraph graph(equality);
        const CanonicalCode start = graph.state(families::book(equality == labelled ? 5 : 6));
        const StateMap<int> distance = distances_from(graph, start);
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
            const CanonicalCode goal = graph.state(families::random(start.vertex_count(), 0, seed));
            EXPECT_EQ(distance_by_astar(graph, start, goal), get(distance, goal));
        }
    }
}

TEST(StateIndexMap, NumbersStatesAsTheyAreMet) {
    const FlipGraph graph(unoriented);
    const std::vector<StateIndexMap> copies(2, StateIndexMap{});
    const StateIndexMap& index = copies[0];
    const StateIndexMap& copy = copies[1];
    for (const Index vertices : {5, 3, 4})
        get(index, graph.state(families::book(vertices)));
    EXPECT_EQ(get(copy, graph.state(families::book(4))), 2U);
    EXPECT_EQ(get(copy, graph.state(families::book(5))), 0U);
    EXPECT_EQ(copy[graph.state(families::book(6))], 3U);
    EXPECT_EQ(get(index, graph.state(families::book(6))), 3U);
}

TEST(StateMap, HoldsItsInitialValueUntilAnotherIsPut) {
    const FlipGraph graph(unoriented);
    const CanonicalCode three = graph.state(families::book(3));
    const std::vector<StateMap<int>> copies(2, StateMap<int>(7));
    const StateMap<int>& map = copies[0];
    const StateMap<int>& copy = copies[1];
    EXPECT_EQ(get(map, three), 7);
    put(map, three, 8);
    EXPECT_EQ(copy[three], 8);
    EXPECT_EQ(get(copy, graph.state(families::book(4))), 7);
    EXPECT_EQ(map.size(), 2U);
}

// ---- a table ----

/// All that flips reach from the starts, as a table.
class Explored {
public:
    Explored(const FlipGraph& graph, const std::vector<Triangulation>& starts) {
        for (const Triangulation& start : starts)
            number(graph.state(start));
        while (table.size() < states.size()) {
            for (const CanonicalCode& state : graph.neighbours(states[table.size()])) {
                table.targets.push_back(number(state));
            }
            table.offsets.push_back(table.targets.size());
        }
    }

    std::uint32_t number(const CanonicalCode& state) {
        const auto [place, is_new] =
            numbers_.emplace(state, static_cast<std::uint32_t>(states.size()));
        if (is_new) states.push_back(state);
        return place->second;
    }

    FlipGraphTable table;
    std::vector<CanonicalCode> states;

private:
    std::map<CanonicalCode, std::uint32_t> numbers_;
};

std::vector<int> distances_from(const FlipGraphTableView& graph, std::uint32_t start) {
    std::vector<int> distance(num_vertices(graph), infinity);
    distance[start] = 0;
    boost::breadth_first_search(graph, start,
                                boost::visitor(boost::make_bfs_visitor(boost::record_distances(
                                    distance.data(), boost::on_tree_edge()))));
    return distance;
}

TEST(FlipGraphTableView, ListsWhatTheTableHolds) {
    // 0 - 1 twice, 1 - 2, 2 - 2, 3 alone.
    const FlipGraphTable table{.offsets = {0, 2, 5, 7, 7}, .targets = {1, 1, 0, 2, 0, 1, 2}};
    const FlipGraphTableView graph(table);
    EXPECT_EQ(num_vertices(graph), 4U);
    const auto [v, v_end] = vertices(graph);
    EXPECT_THAT(std::vector<std::uint32_t>(v, v_end), ::testing::ElementsAre(0, 1, 2, 3));
    EXPECT_EQ(num_edges(graph), 4U);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> listed;
    for (auto [e, e_end] = edges(graph); e != e_end; ++e) {
        listed.emplace_back(source(*e, graph), target(*e, graph));
    }
    EXPECT_THAT(listed, ::testing::ElementsAre(std::pair(0, 1), std::pair(0, 1), std::pair(1, 2),
                                               std::pair(2, 2)));
    const auto [out, out_end] = out_edges(1, graph);
    ASSERT_EQ(out_end - out, 3);
    EXPECT_EQ(source(out[1], graph), 1U);
    EXPECT_EQ(target(out[1], graph), 2U);
    const auto [near, near_end] = adjacent_vertices(1, graph);
    EXPECT_THAT(std::vector<std::uint32_t>(near, near_end), ::testing::ElementsAre(0, 2, 0));
    EXPECT_EQ(out_degree(3, graph), 0U);
    EXPECT_EQ(get(boost::vertex_index, graph, 2), 2U);

    const FlipGraphTable empty;
    EXPECT_EQ(num_vertices(FlipGraphTableView(empty)), 0U);
    EXPECT_EQ(num_edges(FlipGraphTableView(empty)), 0U);
}

TEST(FlipGraphTableView, BreadthFirstSearchMeasuresDiameters) {
    struct Case {
        Equality equality;
        Index vertices;
        std::size_t states;
        int diameter;
    };
    for (const auto& [equality, vertices, states, diameter] :
         {Case{oriented, 6, 14, 4}, Case{unoriented, 7, 54, 7}, Case{labelled, 4, 8, 2},
          Case{labelled, 5, 160, 6}}) {
        const Explored explored(FlipGraph(equality), {families::book(vertices)});
        const FlipGraphTableView graph(explored.table);
        EXPECT_EQ(num_vertices(graph), states);
        int most = 0;
        for (std::uint32_t state = 0; state < states; ++state) {
            most = std::max(most, std::ranges::max(distances_from(graph, state)));
        }
        EXPECT_EQ(most, diameter);
    }
}

TEST(FlipGraphTableView, ConnectedComponentsTellWhatFlipsCannotJoin) {
    // Spheres, tori and the two classes of genus 2 with three vertices, on which no flip is
    // defined.
    const Explored explored(FlipGraph(oriented),
                            {families::book(6), families::random(4, 1, 1), families::book(5),
                             families::surface_of_genus(2, 3, 0)});
    const FlipGraphTableView graph(explored.table);
    std::vector<int> component(num_vertices(graph));
    EXPECT_EQ(boost::connected_components(graph, component.data()), 4);
    std::map<int, std::size_t> sizes;
    for (const int c : component)
        ++sizes[c];
    EXPECT_EQ(sizes, (std::map<int, std::size_t>{{0, 14}, {1, 7}, {2, 4}, {3, 1}}));
}

TEST(FlipGraphTableView, AStarFindsShortestPaths) {
    const Explored explored(FlipGraph(labelled), {families::book(5)});
    const FlipGraphTableView graph(explored.table);
    const std::vector<int> expected = distances_from(graph, 0);
    for (std::uint32_t goal = 0; goal < num_vertices(graph); goal += 7) {
        std::vector<int> distance(num_vertices(graph));
        const DegreeHeuristic by_degrees(explored.states[goal]);
        try {
            boost::astar_search(
                graph, 0U, [&](std::uint32_t v) { return by_degrees(explored.states[v]); },
                boost::weight_map(boost::static_property_map<int>(1))
                    .distance_map(distance.data())
                    .visitor(StopAtGoal<std::uint32_t>(goal)));
            ADD_FAILURE() << "the goal was not reached";
        } catch (const GoalReached&) {
        }
        EXPECT_EQ(distance[goal], expected[goal]);
    }
}

}  // namespace
}  // namespace tightflip::kernel
