// A mesh as Boost.Graph users keep one: a graph, its edges numbered, and a rotation at every
// vertex.
#include "kernels.hpp"

#include <algorithm>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

namespace tightflip::properties {
namespace {

/// Dart 2e leaves one end of edge e and dart 2e + 1 the other; next turns back about the target.
struct BoostGraphKernel {
    using EdgeNumber = boost::property<boost::edge_index_t, Index>;
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                        boost::no_property, EdgeNumber>;
    static constexpr std::string_view name = "Boost.Graph and a rotation system";
    static constexpr KernelClass allowed = KernelClass::simple;
    using Side = Index;

    BoostGraphKernel(Index vertices, std::span<const std::array<Index, 3>> faces)
        : graph(static_cast<std::size_t>(vertices)), rotation(graph.m_vertices.size()) {
        // At a, a face abc puts the dart to c right after the dart to b, counter-clockwise.
        std::vector<std::vector<std::pair<Index, Index>>> following(rotation.size());
        for (const auto& face : faces) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Index a = face[i];
                const Index b = face[(i + 1) % 3];
                following[index(a)].emplace_back(b, face[(i + 2) % 3]);
                if (a < b) add(a, b, static_cast<Index>(origins.size() / 2));
            }
        }
        for (Index v = 0; v < vertices; ++v) {
            Index to = following[index(v)].front().first;
            for (std::size_t i = 0; i < following[index(v)].size(); ++i) {
                rotation[index(v)].push_back(dart(v, to));
                to = std::ranges::find(following[index(v)], to, &std::pair<Index, Index>::first)
                         ->second;
            }
        }
    }

    [[nodiscard]] std::array<Index, 3> counts() const {
        const auto edges = static_cast<Index>(num_edges(graph));
        return {static_cast<Index>(num_vertices(graph)), edges, 2 * edges / 3};
    }
    [[nodiscard]] std::vector<Side> sides() const {
        std::vector<Side> all;
        for (Index d = 0; d < static_cast<Index>(origins.size()); ++d)
            all.push_back(d);
        return all;
    }
    [[nodiscard]] Side across(Side d) const { return d ^ 1; }
    [[nodiscard]] Index origin(Side d) const { return origins[index(d)]; }
    /// The dart before the twin about the target.
    [[nodiscard]] Side next(Side d) const {
        const auto& around = rotation[index(origin(across(d)))];
        const auto back = std::ranges::find(around, across(d));
        return back == around.begin() ? around.back() : *(back - 1);
    }
    [[nodiscard]] bool can_flip(Side d) const {
        const Index c = origin(next(next(d)));
        const Index e = origin(next(next(across(d))));
        return c != e && !edge(index(c), index(e), graph).second;
    }
    void flip(Side d) {
        const Side t = across(d);
        const Side to_c = next(d);  // leaves b; the new dart at c comes right before its twin
        const Side to_d = next(t);  // leaves a
        const Index c = origin(next(to_c));
        const Index opposite = origin(next(to_d));
        const Side at_c = next(to_c);  // c to a
        const Side at_d = next(to_d);  // d to b
        remove_edge(index(origin(d)), index(origin(t)), graph);
        std::erase(rotation[index(origin(d))], d);
        std::erase(rotation[index(origin(t))], t);
        insert_after(at_d, d, opposite);
        insert_after(at_c, t, c);
        const auto e = d / 2;
        add_edge(index(c), index(opposite), EdgeNumber(e), graph);
    }
    /// Connected, simple, and every face a triangle.
    [[nodiscard]] bool is_valid() const {
        std::vector<int> component(num_vertices(graph));
        if (connected_components(graph, component.data()) != 1) return false;
        for (const Side d : sides()) {
            if (origin(d) == origin(across(d)) || next(next(next(d))) != d) return false;
        }
        for (auto [v, end] = vertices(graph); v != end; ++v) {
            const auto [first, last] = adjacent_vertices(*v, graph);
            std::vector<std::size_t> neighbours(first, last);
            std::ranges::sort(neighbours);
            if (std::ranges::adjacent_find(neighbours) != neighbours.end()) return false;
        }
        return true;
    }

private:
    static std::size_t index(Index i) { return static_cast<std::size_t>(i); }
    void add(Index a, Index b, Index e) {
        add_edge(index(a), index(b), EdgeNumber(e), graph);
        origins.push_back(a);
        origins.push_back(b);
    }
    [[nodiscard]] Side dart(Index from, Index to) const {
        const auto found = edge(index(from), index(to), graph).first;
        const Side d = 2 * get(boost::edge_index, graph, found);
        return origin(d) == from ? d : across(d);
    }
    /// Puts a dart right after another about their origin.
    void insert_after(Side place, Side d, Index from) {
        auto& around = rotation[index(from)];
        origins[index(d)] = from;
        around.insert(std::ranges::find(around, place) + 1, d);
    }

    Graph graph;
    std::vector<Index> origins;               // of each dart
    std::vector<std::vector<Side>> rotation;  // the darts that leave a vertex, counter-clockwise
};

}  // namespace

KernelDescription boost_graph_kernel() {
    return kernel_description<BoostGraphKernel>();
}

}  // namespace tightflip::properties
