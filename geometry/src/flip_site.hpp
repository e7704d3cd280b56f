/// \file
/// The faces and edges that a flip replaces, by the labels of their corners.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/kernel/flip.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tightflip::geometry {

struct FaceCorners {
    Vertex a, b, c;
};

/// Edge ab between the faces (a, b, c) and (b, a, d).
struct HingeCorners {
    Vertex a, b, c, d;

    [[nodiscard]] static HingeCorners at(kernel::HalfedgeTable table, Edge e) noexcept {
        return at(table, kernel::Quadrilateral::around(table, e));
    }
    [[nodiscard]] static HingeCorners at(kernel::HalfedgeTable table,
                                         const kernel::Quadrilateral& q) noexcept {
        return {kernel::at(table, q.h).origin, kernel::at(table, q.t).origin,
                kernel::at(table, q.h2).origin, kernel::at(table, q.t2).origin};
    }
    [[nodiscard]] bool touches(Vertex v) const noexcept {
        return a == v || b == v || c == v || d == v;
    }
    [[nodiscard]] std::array<FaceCorners, 2> faces() const noexcept {
        return {{{a, b, c}, {b, a, d}}};
    }
    /// The edge that the flip puts in its place.
    [[nodiscard]] HingeCorners flipped() const noexcept { return {d, c, a, b}; }
};

/// The edges of the two faces at an edge: it and the four around it, fewer where these coincide.
class AffectedEdges {
public:
    [[nodiscard]] static AffectedEdges before_flip(kernel::HalfedgeTable table, Edge e) noexcept {
        const auto q = kernel::Quadrilateral::around(table, e);
        const HingeCorners hinge = HingeCorners::at(table, q);
        return {table, q, hinge, {hinge.a, hinge.b, hinge.b, hinge.a}};
    }
    /// The same edges as the flip of `e` would leave them.
    [[nodiscard]] static AffectedEdges after_flip(kernel::HalfedgeTable table, Edge e) noexcept {
        const auto q = kernel::Quadrilateral::around(table, e);
        const HingeCorners hinge = HingeCorners::at(table, q);
        return {table, q, hinge.flipped(), {hinge.d, hinge.d, hinge.c, hinge.c}};
    }

    [[nodiscard]] std::span<const HingeCorners> hinges() const noexcept {
        return {hinges_.data(), count_};
    }
    [[nodiscard]] std::span<const Edge> edges() const noexcept { return {edges_.data(), count_}; }

private:
    /// `apexes` are the third corners of the faces at h1, h2, t1, t2.
    AffectedEdges(kernel::HalfedgeTable table, const kernel::Quadrilateral& q,
                  const HingeCorners& middle, const std::array<Vertex, 4>& apexes) noexcept {
        push(edge_of(q.h), middle);
        const std::array outer{q.h1, q.h2, q.t1, q.t2};
        for (std::size_t i = 0; i < outer.size(); ++i) {
            const Halfedge near = outer[i];
            const Halfedge far = twin(near);
            Vertex apex =
                kernel::at(table, kernel::at(table, kernel::at(table, far).next).next).origin;
            bool is_second = false;
            for (std::size_t j = 0; j < outer.size(); ++j) {
                if (outer[j] != far) continue;
                apex = apexes[j];
                is_second = j < i;
            }
            if (is_second) continue;
            push(edge_of(near),
                 {kernel::at(table, near).origin, kernel::at(table, far).origin, apexes[i], apex});
        }
    }

    void push(Edge e, const HingeCorners& hinge) noexcept {
        edges_[count_] = e;
        hinges_[count_++] = hinge;
    }

    std::array<HingeCorners, 5> hinges_{};
    std::array<Edge, 5> edges_{};
    std::size_t count_ = 0;
};

/// Appends the edges of the two faces at `e`.
inline void append_edges_of_faces(kernel::HalfedgeTable table, Edge e, std::vector<Edge>& edges) {
    const auto q = kernel::Quadrilateral::around(table, e);
    for (const Halfedge h : {q.h, q.h1, q.h2, q.t1, q.t2})
        edges.push_back(edge_of(h));
}

/// Appends the edges of the two faces at `e` and of the four beside them.
inline void append_edges_of_faces_beside(kernel::HalfedgeTable table, Edge e,
                                         std::vector<Edge>& edges) {
    append_edges_of_faces(table, e, edges);
    const auto q = kernel::Quadrilateral::around(table, e);
    for (const Halfedge side : {q.h1, q.h2, q.t1, q.t2}) {
        const Halfedge second = kernel::at(table, twin(side)).next;
        edges.push_back(edge_of(second));
        edges.push_back(edge_of(kernel::at(table, second).next));
    }
}

}  // namespace tightflip::geometry
