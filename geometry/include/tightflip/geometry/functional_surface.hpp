/// \file
/// Functional data, points with an elevation over the plane, as a closed surface.
#pragma once

#include <tightflip/geometry/delaunay.hpp>
#include <tightflip/geometry/surface.hpp>

namespace tightflip::geometry {

/// A triangulation over the plane whose boundary is closed by one more vertex. That vertex is no
/// datum: its star and link are not to be flipped, and its faces count in no energy.
struct FunctionalSurface {
    Surface surface;
    Vertex marked;  ///< the last label
};

/// The Delaunay triangulation of (x, y), lifted to (x, y, elevation), with counter-clockwise faces
/// seen from above; the marked vertex is joined to every point of the boundary and stands far below
/// its middle. Refused as by `delaunay_in_plane`.
[[nodiscard]] Outcome<FunctionalSurface> functional_surface(std::vector<Point> points);

}  // namespace tightflip::geometry
