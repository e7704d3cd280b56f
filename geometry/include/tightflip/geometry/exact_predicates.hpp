/// \file
/// Signs of determinants, exact for all finite doubles (filtered; CGAL's exact-predicate kernel).
///
/// Every combinatorial decision of this layer is made of these. None allocates where its filter
/// decides, which is nearly always; cost some ten nanoseconds.
#pragma once

#include <tightflip/geometry/surface.hpp>

namespace tightflip::geometry {

/// -1, 0 or 1.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

[[nodiscard]] constexpr Sign operator-(Sign sign) noexcept {
    return static_cast<Sign>(-static_cast<int>(sign));
}

/// The sign of det(b - a, c - a, d - a): positive where d lies on the side of the plane abc from
/// which a, b, c are seen counter-clockwise. For a face abc seen from outside, that is outside.
[[nodiscard]] Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether three points lie on one line (coincident ones do).
[[nodiscard]] bool are_collinear(const Point& a, const Point& b, const Point& c);

/// For four coplanar points where a, b, c are not collinear: on which side of the line ab the point
/// d lies, seen so that c is on the positive side.
[[nodiscard]] Sign coplanar_side(const Point& a, const Point& b, const Point& c, const Point& d);

/// The sign of det(b - a, c - a) in the plane of the first two coordinates: positive where a, b, c
/// turn counter-clockwise seen from above.
[[nodiscard]] Sign orientation_in_plane(const Point& a, const Point& b, const Point& c);

/// In the plane of the first two coordinates, with a, b, c counter-clockwise: positive where d lies
/// inside their circle.
[[nodiscard]] Sign in_circle_in_plane(const Point& a, const Point& b, const Point& c,
                                      const Point& d);

}  // namespace tightflip::geometry
