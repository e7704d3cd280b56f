/// \file
/// The convex hull of points in space, exact for all finite coordinates.
#pragma once

#include <tightflip/geometry/data_refusal.hpp>
#include <tightflip/geometry/surface.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace tightflip::geometry {

using Face = std::array<Index, 3>;

/// Where a point stands with respect to the hull.
enum class HullPosition : std::uint8_t {
    extreme,   ///< a corner of the hull
    boundary,  ///< on a face or an edge of the hull, and not a corner
    inside,
};

struct ConvexHull {
    /// Counter-clockwise seen from outside; their corners are the extreme points. A facet with more
    /// than three corners is the fan from its lowest label. Each face starts with its lowest label,
    /// and the faces are in lexicographic order: they depend on the points alone.
    std::vector<Face> faces;
    /// Of every point. Points that coincide have one position, and the lowest of their labels
    /// stands for all in the faces.
    std::vector<HullPosition> positions;
    /// Of every boundary point the face it lies on (or one of two), and -1 of the others.
    std::vector<Index> face_of;
    /// Two labels for each point but the first that stands at one place: its own, and the lowest.
    std::vector<std::array<Index, 2>> coincident;
};

/// Quickhull (Barber, Dobkin and Huhdanpaa, ACM TOMS 22 (1996)) in which every decision is exact;
/// floating point only chooses what to add next. A face is seen only from strictly above its plane,
/// so that no degenerate face ever arises; points on the hull are carried along with the face they
/// lie on. O(n log n) in practice, quadratic at worst; about 20 bytes a point and 90 a face.
/// Refused: too_few_points (below 4), not_finite, collinear_points (coincident ones too),
/// coplanar_points.
[[nodiscard]] Outcome<ConvexHull> convex_hull(Points points);

/// A closed surface, convex up to flat edges, whose vertices are all the points; the hull's faces
/// are split at the boundary points in an order fixed by the labels. O(n log n) expected, beyond
/// the hull. Refused beyond what `convex_hull` refuses: coincident_points, interior_point.
[[nodiscard]] Outcome<Surface> convex_surface(std::vector<Point> points);

}  // namespace tightflip::geometry
