/// \file
/// Pinch points: vertices at which the surface meets itself locally (Alboul et al., section 5).
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <vector>

namespace tightflip::geometry {

/// Whether the origin of `h` is a pinch point: whether two faces of its star meet beyond what they
/// share (see self_intersections.hpp).
///
/// That is a local property though the faces are large: what two faces have in common is convex and
/// holds the vertex, so from any other common point they have the whole segment to the vertex in
/// common, and their directions from it meet. Without faces of zero area the link, drawn on the
/// sphere of directions, is a closed curve, and the vertex is a pinch point just where the curve
/// touches or crosses itself. A surface has pinch points just where it has local
/// self-intersections, of which they are the common vertices.
///
/// O((d + k) log d) for degree d, where k arcs of the link are so near each other that their boxes
/// meet; no more than the first pair is looked for.
[[nodiscard]] bool is_pinch_point(const SurfaceView& surface, Halfedge h);

/// All pinch points in ascending order; O(n log d) for n faces where the k above are small.
[[nodiscard]] std::vector<Vertex> pinch_points(const SurfaceView& surface);

}  // namespace tightflip::geometry
