/// \file
/// An initial triangulation of data that are seen from one point inside.
#pragma once

#include <tightflip/geometry/data_refusal.hpp>
#include <tightflip/geometry/surface.hpp>

namespace tightflip::geometry {

struct StarShapedSurface {
    Surface surface;
    /// The faces that do not turn their inner side to the centre; exact. With none the surface is
    /// star-shaped about the centre, and so embedded.
    Index faces_turned_away = 0;
};

/// The points are projected from the centre to a sphere, and the hull of the projections is lifted
/// back. Projections are rounded to doubles, so that the hull is that of points near the sphere: it
/// is a valid sphere in any case, but where directions are closer than rounding, some faces may
/// look the wrong way, which `faces_turned_away` says exactly. Projections that rounding has put
/// inside the hull go into the face in front of them. Genus 0. O(n log n) in practice; O(n) for
/// each such projection. Refused: what `convex_hull` refuses (data in one plane, not finite, too
/// few); centre_outside where it is not strictly inside the hull; shared_direction, decided
/// exactly; a point at the centre shares its direction with itself.
[[nodiscard]] Outcome<StarShapedSurface> star_shaped_surface(std::vector<Point> points,
                                                             const Point& centre);

}  // namespace tightflip::geometry
