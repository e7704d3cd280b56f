/// \file
/// The four types of spatial quadrilaterals (Alboul et al., section 4.2.1, Figure 11).
///
/// A spatial quadrilateral is what the two faces at an edge form. Its development is the plane
/// quadrilateral that appears when one face is turned about the edge until both are coplanar and
/// side by side.
#pragma once

#include <tightflip/geometry/hinge.hpp>

#include <cstdint>

namespace tightflip::geometry {

/// The shape of the development, by its angles at the two ends of the edge.
enum class Development : std::uint8_t {
    convex,      ///< both are less than pi
    straight,    ///< one is pi: the development is a triangle with a vertex on a side
    reflex,      ///< one is more than pi
    degenerate,  ///< one of the faces, or both, lie on a line, and there may be no
                 ///< angle
};

/// Exact for all finite coordinates; constant time, without allocation except where floating point
/// cannot decide (nearly straight developments, or lengths out of 1e-60 .. 1e60).
[[nodiscard]] Development development(const Hinge& hinge);

/// The paper's types: the first letter tells the development, the second the edge, convex or reflex
/// (the paper's other word for concave).
enum class QuadrilateralType : std::uint8_t {
    cc,    ///< convex development, convex edge
    cr,    ///< convex development, concave edge
    rc,    ///< reflex development, convex edge
    rr,    ///< reflex development, concave edge
    none,  ///< not in general position: straight, flat, folded or degenerate
};

/// Exact for all finite coordinates; cost as above.
[[nodiscard]] QuadrilateralType quadrilateral_type(const Hinge& hinge);

[[nodiscard]] inline Development development(const SurfaceView& surface, Edge e) {
    return development(Hinge::at(surface, e));
}
[[nodiscard]] inline QuadrilateralType quadrilateral_type(const SurfaceView& surface, Edge e) {
    return quadrilateral_type(Hinge::at(surface, e));
}

}  // namespace tightflip::geometry
