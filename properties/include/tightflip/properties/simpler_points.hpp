/// \file
/// What to try in place of a surface's points when a failing case is made small.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <vector>

namespace tightflip::properties {

/// Simpler points than these, as many, those that are much simpler first: all at the origin; all on
/// grids of few integers; then one point at the origin or at the first point, and one coordinate
/// less, rounded, or without its sign. "Simpler" has no endless descent: fewer coordinates that are
/// not integers below 1024, then a smaller sum of these integers, then fewer negative ones. Empty
/// where all points are at the origin. O(V^2) time and memory.
[[nodiscard]] std::vector<std::vector<geometry::Point>> simpler_points(geometry::Points points);

}  // namespace tightflip::properties
