#include <tightflip/kernel/flip_graph.hpp>

#include <algorithm>
#include <stdexcept>

namespace tightflip::kernel {
namespace {

/// Whether the edge that a flip of `e` would make is there already.
bool makes_parallel_edge(const Triangulation& surface, Edge e) {
    const Halfedge from = surface.previous(halfedge_of(e));
    const Vertex to = surface.opposite(twin(halfedge_of(e)));
    const Neighbours neighbours = surface.neighbours(from);
    return std::any_of(neighbours.begin(), neighbours.end(), [&](Vertex v) { return v == to; });
}

}  // namespace

CanonicalCode FlipGraph::state(const Triangulation& surface) const {
    if (simple_only_ && audit(surface).is_simple() != true) {
        throw std::invalid_argument(
            "the surface is no state of this flip graph: its edges are no simple graph");
    }
    return canonical_code(surface, equality_);
}

std::vector<CanonicalCode> FlipGraph::neighbours(const CanonicalCode& state) const {
    if (state.equality() != equality_) {
        throw std::invalid_argument("the code was made for another meaning of equality");
    }
    Triangulation surface = surface_of(state);
    std::vector<CanonicalCode> reached;
    for (Index e = 0; e < surface.edge_count(); ++e) {
        if (simple_only_ && makes_parallel_edge(surface, {e})) continue;
        if (!surface.flip({e})) continue;
        reached.push_back(canonical_code(surface, equality_));
        static_cast<void>(surface.unflip({e}));
    }
    return reached;
}

}  // namespace tightflip::kernel
