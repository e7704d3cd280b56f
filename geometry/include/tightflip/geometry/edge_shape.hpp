/// \file
/// What the surface does at an edge, decided exactly.
#pragma once

#include <tightflip/geometry/hinge.hpp>

#include <cstdint>

namespace tightflip::geometry {

/// How the two faces at an edge lie. On edge ab between the faces abc and bad, seen from outside:
enum class EdgeShape : std::uint8_t {
    convex,      ///< d lies below the plane of abc: the dihedral angle inside is less than pi
    concave,     ///< d lies above it
    flat,        ///< coplanar, the faces side by side
    folded,      ///< coplanar, the faces on each other; always so at a vertex of degree 2
    degenerate,  ///< one of the faces, or both, lie on a line: no plane, and nothing to say
};

/// Exact for all finite coordinates; constant time. Folded edges are neither convex nor concave nor
/// flat: their exterior angle is pi with no sign.
[[nodiscard]] EdgeShape edge_shape(const Hinge& hinge);
[[nodiscard]] inline EdgeShape edge_shape(const SurfaceView& surface, Edge e) {
    return edge_shape(Hinge::at(surface, e));
}

}  // namespace tightflip::geometry
