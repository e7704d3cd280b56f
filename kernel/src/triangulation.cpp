#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <array>
#include <stdexcept>
#include <string>

namespace tightflip::kernel {

Index Triangulation::degree(Halfedge h) const {
    Index degree = 0;
    for ([[maybe_unused]] const Halfedge spoke : star(h))
        ++degree;
    return degree;
}

std::vector<Halfedge> Triangulation::outgoing() const {
    std::vector<Halfedge> outgoing(static_cast<std::size_t>(vertex_count_));
    for (Index h = halfedge_count(); h-- > 0;) {
        outgoing[static_cast<std::size_t>(origin({h}).id)] = {h};
    }
    return outgoing;
}

std::vector<Halfedge> Triangulation::faces() const {
    std::vector<Halfedge> faces;
    faces.reserve(static_cast<std::size_t>(face_count()));
    for (Index h = 0; h < halfedge_count(); ++h) {
        if (next({h}).id > h && previous({h}).id > h) faces.push_back({h});
    }
    return faces;
}

// A flip reads a chain of records: the edge's own, the two after them, the two after those. The
// records of later edges are asked for in three stages, so that each link of a chain has come from
// memory when the next is followed. Flips in between may change what a stage saw; then only the
// prefetch is wasted.
std::size_t Triangulation::flip_all(std::span<const Edge> edges) {
    constexpr std::size_t stage = 8;
    for (const Edge e : edges)
        static_cast<void>(checked(e));
    const MutableHalfedgeTable records(records_);
    std::size_t flipped = 0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        // The built-in stands here bare: a function that only prefetches counts as pure with GCC,
        // which then drops its calls.
        if (k + 3 * stage < edges.size()) {
            const Halfedge near = halfedge_of(edges[k + stage]);
            const Halfedge far = halfedge_of(edges[k + 2 * stage]);
            __builtin_prefetch(&at(records, at(records, at(records, near).next).next), 1);
            __builtin_prefetch(&at(records, at(records, at(records, twin(near)).next).next), 1);
            __builtin_prefetch(&at(records, at(records, far).next), 1);
            __builtin_prefetch(&at(records, at(records, twin(far)).next), 1);
            __builtin_prefetch(&at(records, halfedge_of(edges[k + 3 * stage])), 1);
        }
        if (kernel::flip(records, edges[k])) ++flipped;
    }
    return flipped;
}

void Triangulation::refuse_handle(const char* kind, Index id) const {
    const Index count = kind[0] == 'e' ? edge_count() : halfedge_count();
    throw std::out_of_range(std::string(kind) + " " + std::to_string(id) +
                            " does not exist: the surface has " + std::to_string(count) +
                            " of them, numbered from 0");
}

AuditReport audit(const Triangulation& surface, const AuditOptions& options) {
    return audit(surface.table(), surface.vertex_count(), options);
}

}  // namespace tightflip::kernel

std::size_t std::hash<tightflip::kernel::Triangulation>::operator()(
    const tightflip::kernel::Triangulation& surface) const noexcept {
    using tightflip::kernel::mix;
    auto code = static_cast<std::uint64_t>(surface.vertex_count());
    for (const auto& [next, origin] : surface.table()) {
        code = mix(code ^ ((static_cast<std::uint64_t>(next.id) << 32) |
                           static_cast<std::uint64_t>(origin.id)));
    }
    return code;
}
