/// \file
/// From where a face is seen from outside.
#pragma once

#include <tightflip/geometry/exact_predicates.hpp>

namespace tightflip::geometry {

/// Which side of the face of `h` is turned to a point: positive the outer one, negative the inner
/// one, zero where the point lies in the plane of the face, or the face on a line. Other faces may
/// stand in between. Exact; constant time.
[[nodiscard]] inline Sign visible_side(const SurfaceView& surface, Halfedge h, const Point& from) {
    return orientation(surface.origin(h), surface.target(h), surface.opposite(h), from);
}

}  // namespace tightflip::geometry
