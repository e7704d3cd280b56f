/// \file
/// The multigraph of a surface as Boost.Graph sees it. The only kernel header that needs Boost.
///
/// `GraphView` models VertexListGraph, EdgeListGraph, IncidenceGraph, BidirectionalGraph and
/// AdjacencyGraph of an undirected graph in which parallel edges are edges of their own. It carries
/// the property maps `vertex_index` and `edge_index`, and `RotationSystem` is its planar embedding
/// on the sphere.
/// \code
///     const GraphView graph(surface);
///     std::vector<int> component(boost::num_vertices(graph));
///     boost::connected_components(graph, component.data());
/// \endcode
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <functional>
#include <utility>
#include <vector>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

namespace tightflip::kernel {

/// An undirected edge, seen from one of its ends: `source` is the origin of the halfedge. Equality,
/// order and hash are those of the edge, whichever end it is seen from.
struct GraphEdge {
    Halfedge halfedge;

    friend constexpr bool operator==(GraphEdge a, GraphEdge b) noexcept {
        return edge_of(a.halfedge) == edge_of(b.halfedge);
    }
    friend constexpr auto operator<=>(GraphEdge a, GraphEdge b) noexcept {
        return edge_of(a.halfedge) <=> edge_of(b.halfedge);
    }
    friend std::size_t hash_value(GraphEdge e) noexcept {
        return std::hash<Edge>{}(edge_of(e.halfedge));
    }
};

namespace circulate {

struct ShowOutEdge {
    constexpr GraphEdge operator()(HalfedgeTable, Halfedge h) const noexcept { return {h}; }
};
struct ShowInEdge {
    constexpr GraphEdge operator()(HalfedgeTable, Halfedge h) const noexcept { return {twin(h)}; }
};

}  // namespace circulate

namespace detail {

struct ToVertex {
    constexpr Vertex operator()(Index id) const noexcept { return {id}; }
};
struct ToGraphEdge {
    constexpr GraphEdge operator()(Index id) const noexcept { return {halfedge_of(Edge{id})}; }
};

/// Descriptors that come by value from the numbers 0, 1, 2, ...
template <class To, class Descriptor>
using NumberedIterator =
    boost::transform_iterator<To, boost::counting_iterator<Index>, Descriptor, Descriptor>;

struct GraphViewTraversal : boost::vertex_list_graph_tag,
                            boost::edge_list_graph_tag,
                            boost::bidirectional_graph_tag,
                            boost::adjacency_graph_tag {};

}  // namespace detail

/// A view that owns only one halfedge a vertex: the surface must outlive it and stay where it is.
/// A flip of the surface invalidates the view, its iterators and its property maps; make a new one
/// (linear time). Edges and neighbours of a vertex come counter-clockwise seen from outside;
/// degrees take time linear in them.
class GraphView {
    using OutEdges = Circulation<circulate::AboutVertex, circulate::ShowOutEdge>;
    using InEdges = Circulation<circulate::AboutVertex, circulate::ShowInEdge>;

public:
    // ---- the names boost::graph_traits looks for ----

    using vertex_descriptor = Vertex;
    using edge_descriptor = GraphEdge;
    using directed_category = boost::undirected_tag;
    using edge_parallel_category = boost::allow_parallel_edge_tag;
    using traversal_category = detail::GraphViewTraversal;
    using vertices_size_type = std::size_t;
    using edges_size_type = std::size_t;
    using degree_size_type = std::size_t;
    using vertex_iterator = detail::NumberedIterator<detail::ToVertex, Vertex>;
    using edge_iterator = detail::NumberedIterator<detail::ToGraphEdge, GraphEdge>;
    using out_edge_iterator = OutEdges::iterator;
    using in_edge_iterator = InEdges::iterator;
    using adjacency_iterator = Neighbours::iterator;

    [[nodiscard]] static constexpr Vertex null_vertex() noexcept { return {}; }

    explicit GraphView(const Triangulation& surface)
        : table_(surface.table()), outgoing_(surface.outgoing()) {}
    explicit GraphView(Triangulation&&) = delete;  // it would not outlive the view

    [[nodiscard]] HalfedgeTable table() const noexcept { return table_; }
    /// The halfedge with which the turn about `v` begins. Precondition: `v` exists.
    [[nodiscard]] Halfedge first_halfedge(Vertex v) const noexcept {
        return outgoing_[static_cast<std::size_t>(v.id)];
    }

    // ---- the functions Boost finds by the type of their argument ----

    friend std::size_t num_vertices(const GraphView& g) noexcept { return g.outgoing_.size(); }
    friend std::size_t num_edges(const GraphView& g) noexcept { return g.table_.size() / 2; }
    friend std::pair<vertex_iterator, vertex_iterator> vertices(const GraphView& g) {
        return numbered<vertex_iterator>(num_vertices(g));
    }
    friend std::pair<edge_iterator, edge_iterator> edges(const GraphView& g) {
        return numbered<edge_iterator>(num_edges(g));
    }

    friend Vertex source(GraphEdge e, const GraphView& g) noexcept {
        return at(g.table_, e.halfedge).origin;
    }
    friend Vertex target(GraphEdge e, const GraphView& g) noexcept {
        return at(g.table_, twin(e.halfedge)).origin;
    }

    friend std::pair<out_edge_iterator, out_edge_iterator> out_edges(Vertex v, const GraphView& g) {
        return g.turn<OutEdges>(v);
    }
    friend std::pair<in_edge_iterator, in_edge_iterator> in_edges(Vertex v, const GraphView& g) {
        return g.turn<InEdges>(v);
    }
    friend std::pair<adjacency_iterator, adjacency_iterator> adjacent_vertices(Vertex v,
                                                                               const GraphView& g) {
        return g.turn<Neighbours>(v);
    }

    friend std::size_t degree(Vertex v, const GraphView& g) {
        const auto [begin, end] = g.turn<OutEdges>(v);
        return static_cast<std::size_t>(std::distance(begin, end));
    }
    friend std::size_t out_degree(Vertex v, const GraphView& g) { return degree(v, g); }
    friend std::size_t in_degree(Vertex v, const GraphView& g) { return degree(v, g); }

private:
    template <class Iterator>
    static std::pair<Iterator, Iterator> numbered(std::size_t count) {
        return {Iterator(boost::counting_iterator<Index>(0)),
                Iterator(boost::counting_iterator<Index>(static_cast<Index>(count)))};
    }
    template <class Range>
    [[nodiscard]] std::pair<typename Range::iterator, typename Range::iterator> turn(
        Vertex v) const {
        const Range range(table_, first_halfedge(v));
        return {range.begin(), range.end()};
    }

    HalfedgeTable table_;
    std::vector<Halfedge> outgoing_;
};

/// The property maps `vertex_index` and `edge_index`: the number behind a descriptor.
template <class Key>
struct GraphIndexMap {
    using key_type = Key;
    using value_type = std::size_t;
    using reference = std::size_t;
    using category = boost::readable_property_map_tag;

    friend constexpr std::size_t get(GraphIndexMap, Key key) noexcept { return number(key); }
    constexpr std::size_t operator[](Key key) const noexcept { return number(key); }

private:
    static constexpr std::size_t number(Vertex v) noexcept {
        return static_cast<std::size_t>(v.id);
    }
    static constexpr std::size_t number(GraphEdge e) noexcept {
        return static_cast<std::size_t>(edge_of(e.halfedge).id);
    }
};
using VertexIndexMap = GraphIndexMap<Vertex>;
using EdgeIndexMap = GraphIndexMap<GraphEdge>;

inline VertexIndexMap get(boost::vertex_index_t, const GraphView&) noexcept {
    return {};
}
inline EdgeIndexMap get(boost::edge_index_t, const GraphView&) noexcept {
    return {};
}
inline std::size_t get(boost::vertex_index_t, const GraphView&, Vertex v) noexcept {
    return get(VertexIndexMap{}, v);
}
inline std::size_t get(boost::edge_index_t, const GraphView&, GraphEdge e) noexcept {
    return get(EdgeIndexMap{}, e);
}

/// The edges at one vertex in the order Boost asks of an embedding: clockwise. Its iterators go
/// both ways, as Boost's drawing algorithms need.
class Rotation {
public:
    class iterator : public boost::iterator_facade<iterator, GraphEdge,
                                                   boost::bidirectional_traversal_tag, GraphEdge> {
    public:
        iterator() noexcept = default;
        iterator(HalfedgeTable table, Halfedge start, bool ended) noexcept
            : table_(table), start_(start), current_(start), ended_(ended) {}

    private:
        friend class boost::iterator_core_access;

        [[nodiscard]] GraphEdge dereference() const noexcept { return {current_}; }
        [[nodiscard]] bool equal(const iterator& other) const noexcept {
            return current_ == other.current_ && ended_ == other.ended_;
        }
        void increment() noexcept {
            current_ = at(table_, twin(current_)).next;
            ended_ = current_ == start_;
        }
        void decrement() noexcept {
            current_ = circulate::AboutVertex{}(table_, current_);
            ended_ = false;
        }

        HalfedgeTable table_;
        Halfedge start_;
        Halfedge current_;
        bool ended_ = false;
    };
    using const_iterator = iterator;

    Rotation(HalfedgeTable table, Halfedge start) noexcept : table_(table), start_(start) {}
    [[nodiscard]] iterator begin() const noexcept { return {table_, start_, false}; }
    [[nodiscard]] iterator end() const noexcept { return {table_, start_, true}; }

private:
    HalfedgeTable table_;
    Halfedge start_;
};

/// The rotation system of the surface as a property map from vertices to their `Rotation`. On the
/// sphere it is a Boost PlanarEmbedding: `boost::planar_face_traversal` over it walks the faces of
/// the surface, each in its own direction, parallel edges or not. On other surfaces it is the same
/// rotation system, which no plane drawing realises. Valid as long as the view.
class RotationSystem {
public:
    using key_type = Vertex;
    using value_type = Rotation;
    using reference = Rotation;
    using category = boost::readable_property_map_tag;

    explicit RotationSystem(const GraphView& graph) noexcept : graph_(&graph) {}
    explicit RotationSystem(GraphView&&) = delete;  // it would not outlive the map

    [[nodiscard]] Rotation operator[](Vertex v) const noexcept {
        return {graph_->table(), graph_->first_halfedge(v)};
    }
    friend Rotation get(const RotationSystem& rotations, Vertex v) noexcept { return rotations[v]; }

private:
    const GraphView* graph_;
};

}  // namespace tightflip::kernel

template <>
struct std::hash<tightflip::kernel::GraphEdge> {
    std::size_t operator()(tightflip::kernel::GraphEdge e) const noexcept { return hash_value(e); }
};

template <>
struct boost::property_map<tightflip::kernel::GraphView, boost::vertex_index_t> {
    using type = tightflip::kernel::VertexIndexMap;
    using const_type = type;
};
template <>
struct boost::property_map<tightflip::kernel::GraphView, boost::edge_index_t> {
    using type = tightflip::kernel::EdgeIndexMap;
    using const_type = type;
};
template <class Tag>
struct boost::property_map<const tightflip::kernel::GraphView, Tag>
    : boost::property_map<tightflip::kernel::GraphView, Tag> {};
