#include "surfaces.hpp"
#include <tightflip/kernel/boost_graph.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <set>
#include <type_traits>
#include <unordered_set>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/chrobak_payne_drawing.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/is_kuratowski_subgraph.hpp>
#include <boost/graph/is_straight_line_drawing.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/graph/planar_canonical_ordering.hpp>
#include <boost/graph/planar_face_traversal.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<GraphView>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<GraphView>));
BOOST_CONCEPT_ASSERT((boost::VertexAndEdgeListGraphConcept<GraphView>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<GraphView>));
BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<GraphView>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<GraphView>));
BOOST_CONCEPT_ASSERT(
    (boost::ReadablePropertyGraphConcept<GraphView, Vertex, boost::vertex_index_t>));
BOOST_CONCEPT_ASSERT(
    (boost::ReadablePropertyGraphConcept<GraphView, GraphEdge, boost::edge_index_t>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<RotationSystem, Vertex>));
static_assert(boost::is_undirected_graph<GraphView>::value);
static_assert(std::is_same_v<boost::graph_traits<GraphView>::edge_parallel_category,
                             boost::allow_parallel_edge_tag>);

using SimpleGraph =
    boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS, boost::no_property,
                          boost::property<boost::edge_index_t, std::size_t>>;

/// The graph with each bundle of parallel edges made one.
SimpleGraph simple_graph_under(const GraphView& graph) {
    SimpleGraph simple(num_vertices(graph));
    for (auto [e, end] = edges(graph); e != end; ++e) {
        boost::add_edge(get(boost::vertex_index, graph, source(*e, graph)),
                        get(boost::vertex_index, graph, target(*e, graph)), simple);
    }
    return simple;
}

std::vector<Triangulation> simple_spheres() {
    std::vector<Triangulation> surfaces{families::tetrahedron(), families::double_wheel(9),
                                        families::icosphere(1)};
    for (std::uint64_t seed = 0; seed < 4; ++seed)
        surfaces.push_back(families::stacked(30, seed));
    return surfaces;
}

std::vector<Triangulation> multigraph_spheres() {
    std::vector<Triangulation> surfaces{families::book(3), families::book(4), families::book(12)};
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        surfaces.push_back(families::random(6 + 7 * static_cast<Index>(seed), 0, seed));
    }
    return surfaces;
}

std::vector<Triangulation> higher_genus() {
    return {families::torus_grid(4, 5), families::surface_of_genus(2, 30, 1),
            families::random(3, 1, 5), families::random(12, 1, 6), families::random(9, 3, 7)};
}

std::vector<Triangulation> all_surfaces() {
    std::vector<Triangulation> all = simple_spheres();
    for (const auto& more : {multigraph_spheres(), higher_genus()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

/// Its graph is K7.
Triangulation seven_vertex_torus() {
    return build(testing::seven_vertex_torus()).value();
}

// ---- the view says what the surface says ----

TEST(GraphView, CountsAndListsEveryVertexAndEdgeOnce) {
    for (const Triangulation& surface : all_surfaces()) {
        const GraphView graph(surface);
        ASSERT_EQ(num_vertices(graph), static_cast<std::size_t>(surface.vertex_count()));
        ASSERT_EQ(num_edges(graph), static_cast<std::size_t>(surface.edge_count()));
        const auto [v, v_end] = vertices(graph);
        const std::set<Vertex> listed_vertices(v, v_end);
        EXPECT_EQ(listed_vertices.size(), num_vertices(graph));
        EXPECT_EQ(listed_vertices.rbegin()->id, surface.vertex_count() - 1);
        const auto [e, e_end] = edges(graph);
        const std::unordered_set<GraphEdge> listed_edges(e, e_end);
        EXPECT_EQ(listed_edges.size(), num_edges(graph));
        std::set<std::size_t> numbers;
        for (const GraphEdge edge : listed_edges) {
            numbers.insert(get(boost::edge_index, graph, edge));
        }
        EXPECT_EQ(numbers.size(), num_edges(graph));
        EXPECT_EQ(*numbers.rbegin(), num_edges(graph) - 1);
    }
}

TEST(GraphView, EdgesAtAVertexComeInRotationOrderWithTheirEndsTheRightWayRound) {
    for (const Triangulation& surface : all_surfaces()) {
        const GraphView graph(surface);
        std::size_t ends = 0;
        for (auto [v, v_end] = vertices(graph); v != v_end; ++v) {
            const auto [out, out_end] = out_edges(*v, graph);
            const auto [in, in_end] = in_edges(*v, graph);
            const auto [near, near_end] = adjacent_vertices(*v, graph);
            const std::vector<GraphEdge> outs(out, out_end);
            const std::vector<GraphEdge> ins(in, in_end);
            const std::vector<Vertex> nears(near, near_end);
            ASSERT_EQ(degree(*v, graph), outs.size());
            ASSERT_EQ(out_degree(*v, graph), outs.size());
            ASSERT_EQ(in_degree(*v, graph), ins.size());
            ASSERT_EQ(ins, outs);  // the same edges, seen from the other ends
            ASSERT_EQ(nears.size(), outs.size());
            ends += outs.size();
            for (std::size_t i = 0; i < outs.size(); ++i) {
                ASSERT_EQ(source(outs[i], graph), *v);
                ASSERT_EQ(target(outs[i], graph), nears[i]);
                ASSERT_EQ(source(ins[i], graph), nears[i]);
                ASSERT_EQ(target(ins[i], graph), *v);
                // Counter-clockwise: between an edge and the next lies the face of the first.
                const Halfedge h = outs[i].halfedge;
                ASSERT_EQ(twin(outs[(i + 1) % outs.size()].halfedge), surface.previous(h));
            }
        }
        EXPECT_EQ(ends, 2 * num_edges(graph));
    }
}

TEST(GraphView, AnEdgeIsOneEdgeFromBothEndsAndParallelEdgesAreSeveral) {
    const Triangulation surface = families::book(12);
    const GraphView graph(surface);
    const GraphEdge e{Halfedge{6}};
    const GraphEdge back{Halfedge{7}};
    EXPECT_EQ(e, back);
    EXPECT_EQ(hash_value(e), hash_value(back));
    EXPECT_FALSE(e < back || back < e);
    EXPECT_EQ(get(boost::edge_index, graph, e), get(boost::edge_index, graph, back));
    EXPECT_EQ(source(e, graph), target(back, graph));
    EXPECT_NE(e, GraphEdge{Halfedge{8}});

    const auto [out, end] = out_edges(Vertex{0}, graph);
    std::set<GraphEdge> to_the_other_pole;
    std::copy_if(out, end, std::inserter(to_the_other_pole, to_the_other_pole.end()),
                 [&](GraphEdge spoke) { return target(spoke, graph) == Vertex{1}; });
    EXPECT_EQ(to_the_other_pole.size(), 10U);
}

TEST(GraphView, TheNullVertexIsNoVertex) {
    const Triangulation surface = families::tetrahedron();
    const auto [v, end] = vertices(GraphView(surface));
    EXPECT_EQ(std::find(v, end, boost::graph_traits<GraphView>::null_vertex()), end);
}

// ---- Boost's algorithms run on it ----

TEST(GraphView, SearchesAndShortestPathsReachEveryVertexAndAgree) {
    for (const Triangulation& surface : all_surfaces()) {
        const GraphView graph(surface);
        const auto index = get(boost::vertex_index, graph);
        std::vector<int> component(num_vertices(graph));
        EXPECT_EQ(boost::connected_components(
                      graph, boost::make_iterator_property_map(component.begin(), index)),
                  1);

        std::vector<int> steps(num_vertices(graph), 0);
        boost::breadth_first_search(
            graph, Vertex{0},
            boost::visitor(boost::make_bfs_visitor(boost::record_distances(
                boost::make_iterator_property_map(steps.begin(), index), boost::on_tree_edge()))));
        std::vector<int> length(num_vertices(graph));
        boost::dijkstra_shortest_paths(
            graph, Vertex{0},
            boost::weight_map(boost::make_static_property_map<GraphEdge>(1))
                .distance_map(boost::make_iterator_property_map(length.begin(), index)));
        EXPECT_EQ(steps, length);
        EXPECT_EQ(std::count(steps.begin(), steps.end(), 0), 1);
    }
}

TEST(GraphView, ASpanningTreeHasOneEdgeLessThanVertices) {
    for (const Triangulation& surface : all_surfaces()) {
        const GraphView graph(surface);
        std::vector<GraphEdge> tree;
        boost::kruskal_minimum_spanning_tree(
            graph, std::back_inserter(tree),
            boost::weight_map(boost::make_static_property_map<GraphEdge>(1)));
        EXPECT_EQ(tree.size() + 1, num_vertices(graph));
    }
}

// The link of a vertex is a closed walk that avoids it (no loops), so no vertex separates.
TEST(GraphView, NoVertexOfASurfaceWithoutLoopsSeparatesItsGraph) {
    for (const Triangulation& surface : all_surfaces()) {
        const GraphView graph(surface);
        std::vector<Vertex> separating;
        boost::articulation_points(graph, std::back_inserter(separating));
        EXPECT_THAT(separating, ::testing::IsEmpty());
    }
}

// ---- the rotation system as an embedding ----

/// Collects the walks of a face traversal as cycles of edge numbers and vertices.
struct FaceCollector : boost::planar_face_traversal_visitor {
    std::vector<std::vector<GraphEdge>> edges;
    std::vector<std::vector<Vertex>> corners;

    void begin_face() {
        edges.emplace_back();
        corners.emplace_back();
    }
    void next_edge(GraphEdge e) { edges.back().push_back(e); }
    void next_vertex(Vertex v) { corners.back().push_back(v); }
};

/// Sides and corners of a face from its smallest side on.
using FaceWalk = std::vector<std::pair<Index, Index>>;

FaceWalk from_its_least(FaceWalk walk) {
    std::rotate(walk.begin(), std::min_element(walk.begin(), walk.end()), walk.end());
    return walk;
}

std::multiset<FaceWalk> faces_of(const Triangulation& surface) {
    std::multiset<FaceWalk> faces;
    for (const Halfedge h : surface.faces()) {
        FaceWalk walk;
        for (const Halfedge side : surface.face_sides(h)) {
            walk.emplace_back(edge_of(side).id, surface.origin(side).id);
        }
        faces.insert(from_its_least(std::move(walk)));
    }
    return faces;
}

std::multiset<FaceWalk> faces_traversed(const GraphView& graph) {
    FaceCollector collector;
    boost::planar_face_traversal(graph, RotationSystem(graph), collector);
    std::multiset<FaceWalk> faces;
    for (std::size_t f = 0; f < collector.edges.size(); ++f) {
        FaceWalk walk;
        for (std::size_t i = 0; i < collector.edges[f].size(); ++i) {
            walk.emplace_back(edge_of(collector.edges[f][i].halfedge).id,
                              collector.corners[f][i].id);
        }
        faces.insert(from_its_least(std::move(walk)));
    }
    return faces;
}

TEST(RotationSystem, FaceTraversalWalksTheFacesOfTheSurfaceInTheirDirection) {
    for (const Triangulation& surface : all_surfaces()) {
        const GraphView graph(surface);
        const std::multiset<FaceWalk> walked = faces_traversed(graph);
        EXPECT_EQ(walked.size(), static_cast<std::size_t>(surface.face_count()));
        EXPECT_EQ(walked, faces_of(surface));
    }
}

TEST(RotationSystem, IsAnEmbeddingFromWhichBoostDrawsSimpleSpheresWithStraightEdges) {
    struct Point {
        std::size_t x = 0;
        std::size_t y = 0;
    };
    for (const Triangulation& surface : simple_spheres()) {
        const GraphView graph(surface);
        const RotationSystem rotations(graph);
        std::vector<Vertex> ordering;
        boost::planar_canonical_ordering(graph, rotations, std::back_inserter(ordering));
        ASSERT_EQ(ordering.size(), num_vertices(graph));
        std::vector<Point> points(num_vertices(graph));
        const auto drawing =
            boost::make_iterator_property_map(points.begin(), get(boost::vertex_index, graph));
        boost::chrobak_payne_straight_line_drawing(graph, rotations, ordering.begin(),
                                                   ordering.end(), drawing);
        EXPECT_TRUE(boost::is_straight_line_drawing(graph, drawing));
    }
}

// ---- Boyer and Myrvold's planarity test as an outside oracle ----
//
// Boost neither forbids nor promises parallel edges there. So it is asked twice, about the
// multigraph and about the simple graph under it, which is planar exactly when the multigraph is.

void flip_at_random(Triangulation& surface, int attempts, RandomStream& random) {
    const auto edge_count = static_cast<std::uint32_t>(surface.edge_count());
    for (int i = 0; i < attempts; ++i) {
        static_cast<void>(surface.flip(Edge{static_cast<Index>(random.below(edge_count))}));
    }
}

bool joins_some_pair_twice(const GraphView& graph) {
    return boost::num_edges(simple_graph_under(graph)) < num_edges(graph);
}

TEST(Planarity, HoldsOnSpheresAfterEveryRunOfFlips) {
    RandomStream random(2024);
    int simple_states = 0;
    int multigraph_states = 0;
    for (Triangulation surface : all_surfaces()) {
        if (surface.genus() != 0) continue;
        for (int run = 0; run < 40; ++run) {
            const GraphView graph(surface);
            ++(joins_some_pair_twice(graph) ? multigraph_states : simple_states);
            ASSERT_TRUE(boost::boyer_myrvold_planarity_test(graph));
            ASSERT_TRUE(boost::boyer_myrvold_planarity_test(simple_graph_under(graph)));
            ASSERT_EQ(faces_traversed(graph), faces_of(surface));
            flip_at_random(surface, run < 20 ? 1 : surface.edge_count(), random);
        }
    }
    EXPECT_GT(simple_states, 20);
    EXPECT_GT(multigraph_states, 200);
}

/// Non-planar, and the witness that Boost gives is a subdivision of K5 or K3,3.
void expect_non_planar(const GraphView& graph) {
    std::vector<GraphEdge> kuratowski;
    EXPECT_FALSE(boost::boyer_myrvold_planarity_test(
        boost::boyer_myrvold_params::graph = graph,
        boost::boyer_myrvold_params::kuratowski_subgraph = std::back_inserter(kuratowski)));
    EXPECT_TRUE(boost::is_kuratowski_subgraph(graph, kuratowski.begin(), kuratowski.end()));
}

TEST(Planarity, FailsOnTheSevenVertexTorusWhoseGraphIsComplete) {
    const Triangulation surface = seven_vertex_torus();
    const GraphView graph(surface);
    ASSERT_EQ(surface.genus(), 1);
    ASSERT_EQ(boost::num_edges(simple_graph_under(graph)), 21U);  // all pairs of seven vertices
    expect_non_planar(graph);
}

// A simple graph with more than 3 V - 6 edges is not planar, and a simple surface of genus g has
// 3 V - 6 + 6 g; parallel edges do not change planarity.
TEST(Planarity, FailsOnSimpleSurfacesOfHigherGenusAndAgreesWithTheSimpleGraphUnderMultigraphs) {
    for (const Triangulation& surface :
         {families::torus_grid(3, 3), families::torus_grid(4, 5),
          families::surface_of_genus(2, 30, 1), families::surface_of_genus(3, 40, 2)}) {
        const GraphView graph(surface);
        ASSERT_FALSE(joins_some_pair_twice(graph));
        expect_non_planar(graph);
    }
    RandomStream random(99);
    int planar = 0;
    int non_planar = 0;
    for (Triangulation surface :
         {seven_vertex_torus(), families::torus_grid(3, 4), families::random(8, 1, 3),
          families::random(4, 2, 4), families::random(30, 2, 5)}) {
        for (int run = 0; run < 30; ++run) {
            const GraphView graph(surface);
            const bool expected = boost::boyer_myrvold_planarity_test(simple_graph_under(graph));
            ++(expected ? planar : non_planar);
            ASSERT_EQ(boost::boyer_myrvold_planarity_test(graph), expected);
            if (!expected) expect_non_planar(graph);
            flip_at_random(surface, surface.edge_count(), random);
        }
    }
    EXPECT_GT(planar, 10);
    EXPECT_GT(non_planar, 10);
}

}  // namespace
}  // namespace tightflip::kernel
