#include "naive_flip_graph.hpp"

#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/canonical.hpp>

#include <algorithm>
#include <utility>

namespace tightflip::fuzz {

using kernel::Edge;
using kernel::Equality;
using kernel::Halfedge;
using kernel::Handedness;
using kernel::Mirror;
using kernel::Triangulation;

NaiveCode naive_code(const Triangulation& surface, Equality equality) {
    NaiveCode least;
    for (Halfedge h{0}; h.id < surface.halfedge_count(); ++h.id) {
        for (const Handedness handedness : {Handedness::kept, Handedness::mirrored}) {
            if (handedness == Handedness::mirrored && equality.mirror == Mirror::distinct) continue;
            NaiveCode code = rooted_code(surface, {h, handedness}, equality.labels);
            if (least.empty() || code < least) least = std::move(code);
        }
    }
    return least;
}

namespace {

NaiveGraph explore_naively(const Triangulation& start, Equality equality, bool simple_only) {
    NaiveGraph graph;
    const auto number_of = [&](const Triangulation& surface, std::size_t distance) {
        const auto [place, is_new] =
            graph.number.emplace(naive_code(surface, equality), graph.surfaces.size());
        if (is_new) {
            graph.surfaces.push_back(surface);
            graph.distance.push_back(distance);
        }
        return place->second;
    };
    number_of(start, 0);
    for (std::size_t k = 0; k < graph.surfaces.size(); ++k) {
        std::vector<std::size_t> row;
        for (Edge e{0}; e.id < start.edge_count(); ++e.id) {
            Triangulation there = graph.surfaces[k];
            if (!there.flip(e) || (simple_only && !is_simple(there))) continue;
            row.push_back(number_of(there, graph.distance[k] + 1));
        }
        std::ranges::sort(row);
        graph.arcs.push_back(row);
    }
    return graph;
}

}  // namespace

bool is_simple(const Triangulation& surface) {
    return audit(surface).is_simple().value();
}

std::vector<std::uint64_t> levels(const NaiveGraph& graph, std::size_t from) {
    std::vector<char> is_reached(graph.arcs.size(), 0);
    std::vector<std::size_t> level{from};
    is_reached[from] = 1;
    std::vector<std::uint64_t> counts;
    while (!level.empty()) {
        counts.push_back(level.size());
        std::vector<std::size_t> beyond;
        for (const std::size_t state : level) {
            for (const std::size_t next : graph.arcs[state]) {
                if (std::exchange(is_reached[next], 1) == 0) beyond.push_back(next);
            }
        }
        level = std::move(beyond);
    }
    return counts;
}

NaiveGraphs::NaiveGraphs(const Triangulation& start, Equality equality, bool simple_only)
    : equality_(equality), simple_only_(simple_only) {
    static_cast<void>(place(start));
}

NaiveGraphs::Place NaiveGraphs::place(const Triangulation& surface) {
    const NaiveCode code = naive_code(surface, equality_);
    for (std::size_t k = 0; k < components_.size(); ++k) {
        const auto found = components_[k].number.find(code);
        if (found != components_[k].number.end()) return {k, found->second};
    }
    components_.push_back(explore_naively(surface, equality_, simple_only_));
    return {components_.size() - 1, 0};
}

const std::vector<std::size_t>& NaiveGraphs::eccentricities() {
    const NaiveGraph& first = components_.front();
    for (std::size_t s = eccentricities_.size(); s < first.arcs.size(); ++s)
        eccentricities_.push_back(levels(first, s).size() - 1);
    return eccentricities_;
}

}  // namespace tightflip::fuzz
