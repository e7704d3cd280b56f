/// \file
/// Flip graphs as Boost.Graph sees them: the implicit one, and one explored into a table.
///
/// `FlipGraph` models IncidenceGraph and AdjacencyGraph of a directed graph with parallel arcs, for
/// algorithms that discover what they visit (breadth_first_visit, astar_search_no_init). Their
/// property maps have to be made for vertices nobody can list: `StateMap` and `StateIndexMap`.
/// \code
///     const FlipGraph graph({Labels::ignored, Mirror::identified});
///     boost::queue<CanonicalCode> pending;
///     boost::breadth_first_visit(graph, graph.state(start), pending, visitor,
///                                StateMap<boost::default_color_type>(boost::white_color));
/// \endcode
/// `FlipGraphTableView` shows a table as an undirected graph that can be listed (VertexListGraph,
/// EdgeListGraph, IncidenceGraph, AdjacencyGraph, with `vertex_index`), for breadth_first_search,
/// connected_components, astar_search and their like.
#pragma once

#include <tightflip/kernel/flip_graph.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

namespace tightflip::kernel {

// ---- the implicit graph ----

namespace detail {

/// A state and what its flips lead to, shared by the arcs and iterators that speak of it.
struct ExpandedState {
    CanonicalCode state;
    std::vector<CanonicalCode> neighbours;
};

struct FlipGraphTraversal : boost::incidence_graph_tag, boost::adjacency_graph_tag {};

}  // namespace detail

/// A legal flip of a state: the n-th of its arcs.
class FlipArc {
public:
    FlipArc() = default;
    FlipArc(std::shared_ptr<const detail::ExpandedState> from, std::size_t number) noexcept
        : from_(std::move(from)), number_(number) {}

    [[nodiscard]] const CanonicalCode& source() const noexcept { return from_->state; }
    [[nodiscard]] const CanonicalCode& target() const noexcept {
        return from_->neighbours[number_];
    }
    /// Its number among the arcs of its source.
    [[nodiscard]] std::size_t number() const noexcept { return number_; }

    friend bool operator==(const FlipArc& a, const FlipArc& b) noexcept {
        return a.number_ == b.number_ &&
               (a.from_ == b.from_ || (a.from_ && b.from_ && a.source() == b.source()));
    }

private:
    std::shared_ptr<const detail::ExpandedState> from_;
    std::size_t number_ = 0;
};

/// The arcs of one state, in order.
class FlipArcIterator : public boost::iterator_facade<FlipArcIterator, FlipArc,
                                                      boost::random_access_traversal_tag, FlipArc> {
public:
    FlipArcIterator() = default;
    FlipArcIterator(std::shared_ptr<const detail::ExpandedState> from, std::size_t number) noexcept
        : from_(std::move(from)), number_(number) {}

private:
    friend class boost::iterator_core_access;

    [[nodiscard]] FlipArc dereference() const { return {from_, number_}; }
    [[nodiscard]] bool equal(const FlipArcIterator& other) const noexcept {
        return number_ == other.number_;
    }
    void increment() noexcept { ++number_; }
    void decrement() noexcept { --number_; }
    void advance(std::ptrdiff_t steps) noexcept { number_ += static_cast<std::size_t>(steps); }
    [[nodiscard]] std::ptrdiff_t distance_to(const FlipArcIterator& other) const noexcept {
        return static_cast<std::ptrdiff_t>(other.number_) - static_cast<std::ptrdiff_t>(number_);
    }

    std::shared_ptr<const detail::ExpandedState> from_;
    std::size_t number_ = 0;
};

namespace detail {

struct TargetOfArc {
    CanonicalCode operator()(const FlipArc& arc) const { return arc.target(); }
};

}  // namespace detail

using FlipNeighbourIterator =
    boost::transform_iterator<detail::TargetOfArc, FlipArcIterator, CanonicalCode, CanonicalCode>;

inline CanonicalCode source(const FlipArc& arc, const FlipGraph&) {
    return arc.source();
}
inline CanonicalCode target(const FlipArc& arc, const FlipGraph&) {
    return arc.target();
}
/// Expands the state: that is the work of a search.
inline std::pair<FlipArcIterator, FlipArcIterator> out_edges(const CanonicalCode& state,
                                                             const FlipGraph& graph) {
    const auto from = std::make_shared<const detail::ExpandedState>(
        detail::ExpandedState{state, graph.neighbours(state)});
    return {{from, 0}, {from, from->neighbours.size()}};
}
inline std::size_t out_degree(const CanonicalCode& state, const FlipGraph& graph) {
    return graph.neighbours(state).size();
}
inline std::pair<FlipNeighbourIterator, FlipNeighbourIterator> adjacent_vertices(
    const CanonicalCode& state, const FlipGraph& graph) {
    const auto [begin, end] = out_edges(state, graph);
    return {FlipNeighbourIterator(begin), FlipNeighbourIterator(end)};
}

// ---- property maps for states met on the way ----

/// A property of states that is `initial` until it is put. Copies share their content.
template <class Value>
class StateMap {
public:
    using key_type = CanonicalCode;
    using value_type = Value;
    using reference = Value&;
    using category = boost::lvalue_property_map_tag;

    explicit StateMap(Value initial = Value{})
        : initial_(std::move(initial)), values_(std::make_shared<Values>()) {}

    reference operator[](const CanonicalCode& state) const {
        return values_->try_emplace(state, initial_).first->second;
    }
    friend reference get(const StateMap& map, const CanonicalCode& state) { return map[state]; }
    friend void put(const StateMap& map, const CanonicalCode& state, Value value) {
        map[state] = std::move(value);
    }

    /// States asked about so far.
    [[nodiscard]] std::size_t size() const noexcept { return values_->size(); }

private:
    using Values = std::unordered_map<CanonicalCode, Value>;

    Value initial_;
    std::shared_ptr<Values> values_;
};

/// Numbers states 0, 1, 2, ... as it is asked about them. Copies share the numbers.
class StateIndexMap {
public:
    using key_type = CanonicalCode;
    using value_type = std::size_t;
    using reference = std::size_t;
    using category = boost::readable_property_map_tag;

    std::size_t operator[](const CanonicalCode& state) const {
        return numbers_->try_emplace(state, numbers_->size()).first->second;
    }
    friend std::size_t get(const StateIndexMap& map, const CanonicalCode& state) {
        return map[state];
    }

private:
    using Numbers = std::unordered_map<CanonicalCode, std::size_t>;

    std::shared_ptr<Numbers> numbers_ = std::make_shared<Numbers>();
};

// ---- a table ----

/// An arc of a table: `number` is its place among all targets.
struct TableArc {
    std::uint32_t source = 0;
    std::uint32_t target = 0;
    std::uint64_t number = 0;

    friend constexpr bool operator==(TableArc, TableArc) noexcept = default;
};

namespace detail {

struct FlipGraphTableTraversal : boost::vertex_list_graph_tag,
                                 boost::edge_list_graph_tag,
                                 boost::incidence_graph_tag,
                                 boost::adjacency_graph_tag {};

}  // namespace detail

/// The arcs of one state of a table.
class TableArcIterator
    : public boost::iterator_facade<TableArcIterator, TableArc, boost::random_access_traversal_tag,
                                    TableArc> {
public:
    TableArcIterator() = default;
    TableArcIterator(const FlipGraphTable& table, std::uint32_t source,
                     std::uint64_t number) noexcept
        : table_(&table), source_(source), number_(number) {}

private:
    friend class boost::iterator_core_access;

    [[nodiscard]] TableArc dereference() const noexcept {
        return {source_, table_->targets[number_], number_};
    }
    [[nodiscard]] bool equal(const TableArcIterator& other) const noexcept {
        return number_ == other.number_;
    }
    void increment() noexcept { ++number_; }
    void decrement() noexcept { --number_; }
    void advance(std::ptrdiff_t steps) noexcept { number_ += static_cast<std::uint64_t>(steps); }
    [[nodiscard]] std::ptrdiff_t distance_to(const TableArcIterator& other) const noexcept {
        return static_cast<std::ptrdiff_t>(other.number_) - static_cast<std::ptrdiff_t>(number_);
    }

    const FlipGraphTable* table_ = nullptr;
    std::uint32_t source_ = 0;
    std::uint64_t number_ = 0;
};

/// All arcs of a table that do not lead to a lesser state.
class TableEdgeIterator : public boost::iterator_facade<TableEdgeIterator, TableArc,
                                                        boost::forward_traversal_tag, TableArc> {
public:
    TableEdgeIterator() = default;
    /// From the first such arc at or after `number`.
    TableEdgeIterator(const FlipGraphTable& table, std::uint64_t number) noexcept
        : table_(&table), number_(number) {
        pass_others();
    }

private:
    friend class boost::iterator_core_access;

    [[nodiscard]] TableArc dereference() const noexcept {
        return {source_, table_->targets[number_], number_};
    }
    [[nodiscard]] bool equal(const TableEdgeIterator& other) const noexcept {
        return number_ == other.number_;
    }
    void increment() noexcept {
        ++number_;
        pass_others();
    }
    void pass_others() noexcept {
        for (; number_ < table_->targets.size(); ++number_) {
            while (table_->offsets[source_ + std::size_t{1}] <= number_)
                ++source_;
            if (source_ <= table_->targets[number_]) return;
        }
    }

    const FlipGraphTable* table_ = nullptr;
    std::uint32_t source_ = 0;
    std::uint64_t number_ = 0;
};

/// A table as a graph; the table must outlive it and stay where it is.
///
/// It is undirected, for every flip has a flip back: out_edges gives a state's own row, and the
/// list of edges has each edge once, as the arc from its lesser end. (Where states are classes with
/// symmetries, the two rows may disagree on how many parallel edges there are.)
class FlipGraphTableView {
public:
    // ---- the names boost::graph_traits looks for ----

    using vertex_descriptor = std::uint32_t;
    using edge_descriptor = TableArc;
    using directed_category = boost::undirected_tag;
    using edge_parallel_category = boost::allow_parallel_edge_tag;
    using traversal_category = detail::FlipGraphTableTraversal;
    using vertices_size_type = std::size_t;
    using edges_size_type = std::size_t;
    using degree_size_type = std::size_t;
    using vertex_iterator = boost::counting_iterator<std::uint32_t>;
    using edge_iterator = TableEdgeIterator;
    using out_edge_iterator = TableArcIterator;
    using adjacency_iterator = std::vector<std::uint32_t>::const_iterator;

    [[nodiscard]] static constexpr vertex_descriptor null_vertex() noexcept {
        return ~vertex_descriptor{0};
    }

    /// Linear time: counts the edges.
    explicit FlipGraphTableView(const FlipGraphTable& table) : table_(&table) {
        const auto [begin, end] = edges(*this);
        edge_count_ = static_cast<std::size_t>(std::distance(begin, end));
    }
    explicit FlipGraphTableView(FlipGraphTable&&) = delete;  // it would not outlive the view

    [[nodiscard]] const FlipGraphTable& table() const noexcept { return *table_; }

    // ---- the functions Boost finds by the type of their argument ----

    friend std::size_t num_vertices(const FlipGraphTableView& g) noexcept {
        return g.table_->size();
    }
    friend std::size_t num_edges(const FlipGraphTableView& g) noexcept { return g.edge_count_; }
    friend std::pair<vertex_iterator, vertex_iterator> vertices(const FlipGraphTableView& g) {
        return {vertex_iterator(0), vertex_iterator(static_cast<std::uint32_t>(num_vertices(g)))};
    }
    friend std::pair<edge_iterator, edge_iterator> edges(const FlipGraphTableView& g) {
        return {{*g.table_, 0}, {*g.table_, g.table_->targets.size()}};
    }
    friend vertex_descriptor source(TableArc e, const FlipGraphTableView&) noexcept {
        return e.source;
    }
    friend vertex_descriptor target(TableArc e, const FlipGraphTableView&) noexcept {
        return e.target;
    }
    friend std::pair<out_edge_iterator, out_edge_iterator> out_edges(vertex_descriptor v,
                                                                     const FlipGraphTableView& g) {
        return {{*g.table_, v, g.table_->offsets[v]},
                {*g.table_, v, g.table_->offsets[v + std::size_t{1}]}};
    }
    friend std::pair<adjacency_iterator, adjacency_iterator> adjacent_vertices(
        vertex_descriptor v, const FlipGraphTableView& g) {
        const auto place = [&](std::size_t state) {
            return g.table_->targets.begin() +
                   static_cast<std::ptrdiff_t>(g.table_->offsets[state]);
        };
        return {place(v), place(v + std::size_t{1})};
    }
    friend std::size_t out_degree(vertex_descriptor v, const FlipGraphTableView& g) {
        return g.table_->degree(v);
    }

private:
    const FlipGraphTable* table_;
    std::size_t edge_count_ = 0;
};

using TableIndexMap = boost::typed_identity_property_map<std::uint32_t>;

inline TableIndexMap get(boost::vertex_index_t, const FlipGraphTableView&) noexcept {
    return {};
}
inline std::uint32_t get(boost::vertex_index_t, const FlipGraphTableView&,
                         std::uint32_t v) noexcept {
    return v;
}

}  // namespace tightflip::kernel

template <>
struct boost::graph_traits<tightflip::kernel::FlipGraph> {
    using vertex_descriptor = tightflip::kernel::CanonicalCode;
    using edge_descriptor = tightflip::kernel::FlipArc;
    using directed_category = boost::directed_tag;
    using edge_parallel_category = boost::allow_parallel_edge_tag;
    using traversal_category = tightflip::kernel::detail::FlipGraphTraversal;
    using degree_size_type = std::size_t;
    using out_edge_iterator = tightflip::kernel::FlipArcIterator;
    using adjacency_iterator = tightflip::kernel::FlipNeighbourIterator;

    [[nodiscard]] static vertex_descriptor null_vertex() { return {}; }
};

template <>
struct boost::property_map<tightflip::kernel::FlipGraphTableView, boost::vertex_index_t> {
    using type = tightflip::kernel::TableIndexMap;
    using const_type = type;
};
template <>
struct boost::property_map<const tightflip::kernel::FlipGraphTableView, boost::vertex_index_t>
    : boost::property_map<tightflip::kernel::FlipGraphTableView, boost::vertex_index_t> {};
