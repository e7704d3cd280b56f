/// \file
/// This library's kernel in the ways it can be used. Every kernel measured has the same shape: it
/// is made from a surface, `flip_each` flips a list in order and says how many were done, and
/// `faces` shows the result.
#pragma once

#include "workload.hpp"

namespace tightflip::kernel::bench {

/// One call of `Triangulation::flip` an edge: handle check, legality test, flip.
class OneByOne {
public:
    static constexpr const char* name = "tightflip, flip";

    explicit OneByOne(const Triangulation& start) : surface_(start) {}

    std::size_t flip_each(std::span<const Edge> edges) {
        std::size_t done = 0;
        for (const Edge e : edges) {
            if (surface_.flip(e)) ++done;
        }
        return done;
    }
    [[nodiscard]] FaceList faces() const {
        FaceList faces;
        for (const Halfedge h : surface_.faces()) {
            const Halfedge next = surface_.next(h);
            faces.push_back(
                {surface_.origin(h).id, surface_.origin(next).id, surface_.opposite(h).id});
        }
        return faces;
    }
    [[nodiscard]] Triangulation& surface() noexcept { return surface_; }

private:
    Triangulation surface_;
};

/// `Triangulation::flip_all`.
class Batched : public OneByOne {
public:
    static constexpr const char* name = "tightflip, flip_all";

    using OneByOne::OneByOne;
    std::size_t flip_each(std::span<const Edge> edges) { return surface().flip_all(edges); }
};

/// With a map from each vertex to a halfedge that leaves it, kept up to date.
class WithVertexMap : public OneByOne {
public:
    static constexpr const char* name = "tightflip, flip, and a vertex map kept";

    explicit WithVertexMap(const Triangulation& start)
        : OneByOne(start), outgoing_(start.outgoing()) {}

    std::size_t flip_each(std::span<const Edge> edges) {
        std::size_t done = 0;
        for (const Edge e : edges) {
            const HalfedgeTable table = surface().table();
            const Halfedge h = halfedge_of(e);
            const Vertex a = at(table, h).origin;
            const Vertex b = at(table, twin(h)).origin;
            const Halfedge from_b = at(table, h).next;
            const Halfedge from_a = at(table, twin(h)).next;
            if (!surface().flip(e)) continue;
            ++done;
            leave(a, h, from_a);
            leave(b, twin(h), from_b);
        }
        return done;
    }

private:
    void leave(Vertex v, Halfedge old, Halfedge other) {
        Halfedge& entry = outgoing_[static_cast<std::size_t>(v.id)];
        if (entry == old) entry = other;
    }

    std::vector<Halfedge> outgoing_;
};

}  // namespace tightflip::kernel::bench
