/// \file
/// Functional surfaces: faces over the plane of the first two coordinates.
#pragma once

#include "bound_surface.hpp"

namespace tightflip::geometry {

/// Throws std::invalid_argument, naming the criterion, where the surface has no marked vertex or
/// one of its other faces is not counter-clockwise seen from above. Exact; linear time.
void require_height_field(const BoundSurface& surface, std::string_view criterion);

/// Whether the flip of an edge leaves the faces counter-clockwise seen from above: the
/// quadrilateral in the plane is strictly convex. Exact.
[[nodiscard]] bool flip_keeps_plane(const BoundSurface& surface, const HingeCorners& hinge);

}  // namespace tightflip::geometry
