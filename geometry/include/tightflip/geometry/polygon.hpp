/// \file
/// Simple polygons in the plane of the first two coordinates, exact for all finite coordinates.
#pragma once

#include <tightflip/geometry/convex_hull.hpp>

#include <optional>

namespace tightflip::geometry {

/// Two sides, by the corners they start at, that meet elsewhere than consecutive sides have to;
/// empty where the polygon is simple. Straight corners are allowed. O(k^2). Precondition: three
/// corners or more.
[[nodiscard]] std::optional<std::array<Index, 2>> find_crossing_sides(Points polygon);

/// Whether the corners of a simple polygon run counter-clockwise.
[[nodiscard]] bool is_counter_clockwise(Points polygon);

/// The triangles of a simple polygon with counter-clockwise corners, themselves counter-clockwise,
/// by cutting off ears. Straight corners are used too, and no triangle is without area. O(k^2) for
/// most polygons, O(k^3) at worst.
[[nodiscard]] std::vector<Face> triangulate_polygon(Points polygon);

}  // namespace tightflip::geometry
