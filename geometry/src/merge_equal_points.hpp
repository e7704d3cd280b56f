/// \file
/// One vertex for all corners that stand at one point, as formats without indices mean it.
#pragma once

#include <tightflip/geometry/triangle_soup.hpp>

namespace tightflip::geometry {

/// Merges points whose coordinates are equal (-0 equals 0) and numbers them, with the position of
/// the first, in the order of their first appearance. O(n log n) time whatever the coordinates.
void merge_equal_points(TriangleSoup& soup);

}  // namespace tightflip::geometry
