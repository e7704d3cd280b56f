/// \file
/// A point of a triangle's plane and the triangle.
#pragma once

#include <tightflip/geometry/exact_predicates.hpp>

namespace tightflip::geometry {

/// Whether x lies in the triangle or on its boundary. Precondition: a, b, c are not collinear, and
/// x lies in their plane.
[[nodiscard]] inline bool triangle_contains(const Point& a, const Point& b, const Point& c,
                                            const Point& x) {
    return coplanar_side(a, b, c, x) != Sign::negative &&
           coplanar_side(b, c, a, x) != Sign::negative &&
           coplanar_side(c, a, b, x) != Sign::negative;
}

}  // namespace tightflip::geometry
