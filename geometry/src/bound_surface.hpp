/// \file
/// What all plain criteria share: the surface, its points in moderate units, and the marked vertex.
#pragma once

#include "flip_site.hpp"
#include "scaled_points.hpp"
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/hinge.hpp>

namespace tightflip::geometry {

/// The surface a criterion is bound to.
class BoundSurface {
public:
    BoundSurface(const SurfaceView& surface, Vertex marked)
        : surface_(surface), scaled_(surface.points, marked), marked_(marked) {}

    [[nodiscard]] const SurfaceView& view() const noexcept { return surface_; }
    [[nodiscard]] kernel::HalfedgeTable table() const noexcept { return surface_.table; }
    [[nodiscard]] Vertex marked() const noexcept { return marked_; }
    [[nodiscard]] Index edge_count() const noexcept { return surface_.edge_count(); }

    /// For predicates.
    [[nodiscard]] const Point& exact(Vertex v) const noexcept { return surface_.point(v); }
    /// For measures.
    [[nodiscard]] const Point& scaled(Vertex v) const noexcept {
        return scaled_.points()[static_cast<std::size_t>(v.id)];
    }
    [[nodiscard]] Hinge exact(const HingeCorners& h) const noexcept {
        return {exact(h.a), exact(h.b), exact(h.c), exact(h.d)};
    }
    [[nodiscard]] Hinge scaled(const HingeCorners& h) const noexcept {
        return {scaled(h.a), scaled(h.b), scaled(h.c), scaled(h.d)};
    }
    [[nodiscard]] double in_units(double value, int dimension) const {
        return scaled_.in_units(value, dimension);
    }

    /// Whether a face or the faces at an edge count: none of the marked vertex does.
    [[nodiscard]] bool counts(const FaceCorners& f) const noexcept {
        return f.a != marked_ && f.b != marked_ && f.c != marked_;
    }
    [[nodiscard]] bool counts(const HingeCorners& h) const noexcept { return !h.touches(marked_); }

    /// Calls `use` with the corners of each face that counts, once.
    template <class Use>
    void for_each_face(const Use& use) const {
        for (Index id = 0; id < static_cast<Index>(table().size()); ++id) {
            const Halfedge h{id};
            const Halfedge h1 = kernel::at(table(), h).next;
            const Halfedge h2 = kernel::at(table(), h1).next;
            if (h1 < h || h2 < h) continue;  // each face at its smallest halfedge
            const FaceCorners face{kernel::at(table(), h).origin, kernel::at(table(), h1).origin,
                                   kernel::at(table(), h2).origin};
            if (counts(face)) use(face);
        }
    }

private:
    SurfaceView surface_;
    ScaledPoints scaled_;
    Vertex marked_;
};

}  // namespace tightflip::geometry
