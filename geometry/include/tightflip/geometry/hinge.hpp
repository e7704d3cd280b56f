/// \file
/// The four points at an edge.
#pragma once

#include <tightflip/geometry/surface.hpp>

namespace tightflip::geometry {

/// Edge ab and the corners opposite it in its faces (a, b, c) and (b, a, d). Refers to the points.
struct Hinge {
    const Point& a;
    const Point& b;
    const Point& c;
    const Point& d;

    [[nodiscard]] static Hinge at(const SurfaceView& surface, Edge e) noexcept {
        const Halfedge h = halfedge_of(e);
        return {surface.origin(h), surface.target(h), surface.opposite(h),
                surface.opposite(twin(h))};
    }
};

}  // namespace tightflip::geometry
