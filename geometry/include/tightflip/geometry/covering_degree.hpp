/// \file
/// How often a surface goes round a point.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <optional>

namespace tightflip::geometry {

/// The covering degree (winding number) of the surface about a point that does not lie on it: how
/// often the surface, projected to a sphere about the point, covers the sphere; 1 inside an
/// embedded surface whose faces are counter-clockwise seen from outside, 0 outside. Empty where the
/// point lies on a face.
///
/// The signed count of faces that a ray from the point goes through. The ray has the direction
/// (1, t, t^2) for infinitely small t, and so meets no edge, whatever the surface: exact for all
/// finite coordinates. Linear time, no allocation.
[[nodiscard]] std::optional<Index> covering_degree(const SurfaceView& surface, const Point& x);

}  // namespace tightflip::geometry
