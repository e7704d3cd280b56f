#include "workload.hpp"

#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>

namespace tightflip::kernel::bench {
namespace {

constexpr std::uint64_t seed = 20260101;

/// The value of `make(key)`, made at the first call with this key and kept.
template <class Value, class Make>
const Value& remembered(std::map<Index, Value>& store, Index key, Make&& make) {
    const auto found = store.find(key);
    return found != store.end() ? found->second : store.emplace(key, make()).first->second;
}

Edge random_edge(RandomStream& random, const Triangulation& surface) {
    return {static_cast<Index>(random.below(static_cast<std::uint32_t>(surface.edge_count())))};
}

/// Whether the two corners opposite `e` are distinct and no edge joins them yet.
bool flip_keeps_simple(const Triangulation& surface, Edge e) {
    const Halfedge to_c = surface.previous(halfedge_of(e));
    const Vertex d = surface.opposite(twin(halfedge_of(e)));
    const auto neighbours = surface.neighbours(to_c);
    return surface.can_flip(e) &&
           std::find(neighbours.begin(), neighbours.end(), d) == neighbours.end();
}

/// The subdivided sphere whose size, 4 or 10 times a power of 4 and 2 more, comes closest.
Triangulation subdivided_sphere(Index vertices) {
    const auto size = [](Index base, int level) { return (base << (2 * level)) + 2; };
    const auto error = [&](Index base, int level) {
        return std::abs(size(base, level) - vertices);
    };
    const auto best_level = [&](Index base) {
        int level = 0;
        while (error(base, level + 1) < error(base, level))
            ++level;
        return level;
    };
    const int octa = best_level(4);
    const int ico = best_level(10);
    return error(4, octa) < error(10, ico) ? families::octasphere(octa) : families::icosphere(ico);
}

/// The same surface with vertices and edges numbered at random: neighbours lie nowhere near.
Triangulation renumbered(const Triangulation& surface, RandomStream& random) {
    const auto permutation = [&](Index count) {
        std::vector<Index> numbers(static_cast<std::size_t>(count));
        std::iota(numbers.begin(), numbers.end(), 0);
        random.shuffle(std::span(numbers));
        return numbers;
    };
    const std::vector<Index> vertex = permutation(surface.vertex_count());
    const std::vector<Index> edge = permutation(surface.edge_count());
    const auto renamed = [&](Halfedge h) {
        return Halfedge{2 * edge[static_cast<std::size_t>(edge_of(h).id)] + h.id % 2};
    };
    std::vector<HalfedgeRecord> records(surface.table().size());
    for (Index h = 0; h < surface.halfedge_count(); ++h) {
        records[static_cast<std::size_t>(renamed({h}).id)] = {
            renamed(surface.next({h})), {vertex[static_cast<std::size_t>(surface.origin({h}).id)]}};
    }
    return build(std::move(records), surface.vertex_count()).value();
}

}  // namespace

const Triangulation& multigraph_sphere(Index vertices) {
    static std::map<Index, Triangulation> store;
    return remembered(store, vertices, [&] { return families::random(vertices, 0, seed); });
}

const Triangulation& simple_sphere(Index vertices) {
    static std::map<Index, Triangulation> store;
    return remembered(store, vertices, [&] {
        RandomStream random(seed);
        Triangulation surface = renumbered(subdivided_sphere(vertices), random);
        for (Index k = 0; k < 5 * surface.edge_count(); ++k) {
            const Edge e = random_edge(random, surface);
            if (flip_keeps_simple(surface, e)) static_cast<void>(surface.flip(e));
        }
        return surface;
    });
}

const std::vector<Edge>& random_edges(const Triangulation& surface) {
    static std::map<Index, std::vector<Edge>> store;
    return remembered(store, surface.edge_count(), [&] {
        std::vector<Edge> edges(run_length);
        RandomStream random(seed + 1);
        std::ranges::generate(edges, [&] { return random_edge(random, surface); });
        return edges;
    });
}

const std::vector<Edge>& flippable_edges(Index vertices) {
    static std::map<Index, std::vector<Edge>> store;
    return remembered(store, vertices, [&] {
        Triangulation surface = multigraph_sphere(vertices);
        std::vector<Edge> edges;
        edges.reserve(run_length);
        RandomStream random(seed + 2);
        while (edges.size() < run_length) {
            const Edge e = random_edge(random, surface);
            if (surface.flip(e)) edges.push_back(e);
        }
        return edges;
    });
}

FaceList sorted_faces(FaceList faces) {
    for (auto& face : faces)
        std::ranges::rotate(face, std::ranges::min_element(face));
    std::ranges::sort(faces);
    return faces;
}

}  // namespace tightflip::kernel::bench
