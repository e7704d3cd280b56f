/// \file
/// Differences of points and angles that hold for all finite coordinates.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace tightflip::geometry {

/// A positive multiple of `to - from` whose products of four do not overflow, nor vanish; zero
/// where the points coincide.
[[nodiscard]] inline Point direction(const Point& from, const Point& to) {
    constexpr double largest = 0x1p200;
    constexpr double smallest = 0x1p-200;
    Point difference = to - from;
    double size = difference.cwiseAbs().maxCoeff();
    if (size == 0 || (size > smallest && size < largest)) return difference;
    if (!std::isfinite(size)) {  // halves of so large numbers are exact
        difference = to * 0.5 - from * 0.5;
        size = difference.cwiseAbs().maxCoeff();
    }
    const int exponent = std::ilogb(size);
    for (double& coordinate : difference)
        coordinate = std::ldexp(coordinate, -exponent);
    return difference;
}

/// The angle between two directions in 0 .. pi; 0 where one of them vanishes.
[[nodiscard]] inline double angle_between(const Point& u, const Point& v) {
    return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// Of a face with one corner at the apex and the others in two directions: its angle there, with
/// the conventions of StarMeter for directions that vanish.
[[nodiscard]] inline double face_angle(const Point& u, const Point& v) {
    const bool u_vanishes = u.isZero(0);
    const bool v_vanishes = v.isZero(0);
    if (u_vanishes && v_vanishes) return std::numbers::pi / 3;
    if (u_vanishes || v_vanishes) return std::numbers::pi / 2;
    return angle_between(u, v);
}

}  // namespace tightflip::geometry
