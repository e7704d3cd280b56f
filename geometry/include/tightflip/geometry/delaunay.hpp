/// \file
/// The Delaunay triangulation of points in the plane, exact for all finite coordinates.
#pragma once

#include <tightflip/geometry/convex_hull.hpp>

namespace tightflip::geometry {

struct PlaneTriangulation {
    /// Counter-clockwise seen from above, each from its lowest label on, in lexicographic order.
    std::vector<Face> faces;
    /// The boundary counter-clockwise from its lowest label on; points within a straight side
    /// included.
    std::vector<Index> boundary;
};

/// Of the first two coordinates of the points; the third is not looked at. Where more than three
/// points lie on one empty circle, that with the highest label counts as slightly outside (a
/// symbolic perturbation of the lifted points), so that the triangulation depends on the points and
/// their labels alone. By insertion in an order that is random in the large and near in the small
/// (Amenta, Choi and Rote, SoCG 2003), with Lawson's flips: O(n log n) expected. Refused:
/// too_few_points (below 3), not_finite, coincident_points (in the plane), collinear_points.
[[nodiscard]] Outcome<PlaneTriangulation> delaunay_in_plane(Points points);

}  // namespace tightflip::geometry
