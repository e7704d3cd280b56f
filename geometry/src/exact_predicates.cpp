#include "whole_numbers.hpp"
#include <tightflip/geometry/exact_predicates.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tightflip::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 in_space(const Point& p) {
    return {p.x(), p.y(), p.z()};
}
Kernel::Point_2 in_plane(const Point& p) {
    return {p.x(), p.y()};
}
Sign sign(CGAL::Sign value) {
    return static_cast<Sign>(static_cast<int>(value));
}

/// The sign of det(b - a, c - a, d - a) where plain arithmetic is sure of it, else zero; some five
/// times as fast as the kernel's own filters. Shewchuk's bound for the error of this evaluation is
/// (7 + 56 u) u < 7.78e-16 times the permanent, u = 2^-53 (Discrete Comput. Geom. 18, 1997; it
/// holds without under- or overflow, also with fused operations). Products that underflow are wrong
/// by less than 2^-1074 times a coordinate z, which the other two conditions keep far below the
/// bound; what overflows fails the comparisons.
Sign filtered_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Point u = b - a;
    const Point v = c - a;
    const Point w = d - a;
    const double vx_wy = v.x() * w.y();
    const double vy_wx = v.y() * w.x();
    const double wx_uy = w.x() * u.y();
    const double wy_ux = w.y() * u.x();
    const double ux_vy = u.x() * v.y();
    const double uy_vx = u.y() * v.x();
    const double determinant =
        u.z() * (vx_wy - vy_wx) + v.z() * (wx_uy - wy_ux) + w.z() * (ux_vy - uy_vx);
    const double permanent = std::abs(u.z()) * (std::abs(vx_wy) + std::abs(vy_wx)) +
                             std::abs(v.z()) * (std::abs(wx_uy) + std::abs(wy_ux)) +
                             std::abs(w.z()) * (std::abs(ux_vy) + std::abs(uy_vx));
    const double heights = std::abs(u.z()) + std::abs(v.z()) + std::abs(w.z());
    const bool is_moderate = permanent > 1e-200 && heights < 1e100;
    const double bound = 8e-16 * permanent;
    if (!is_moderate || !(std::abs(determinant) > bound)) return Sign::zero;
    return determinant > 0 ? Sign::positive : Sign::negative;
}

/// Whether products of some differences may leave the range of doubles, so that no filter can tell
/// their signs.
bool leave_range(std::span<const Point* const> points) {
    return std::ranges::any_of(points, [](const Point* p) {
        return std::any_of(p->begin(), p->end(), [](double coordinate) {
            const double size = std::abs(coordinate);
            return size != 0 && !(size > 0x1p-300 && size < 0x1p300);
        });
    });
}

}  // namespace

Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Sign quick = filtered_orientation(a, b, c, d);
    if (quick != Sign::zero) return quick;
    // Usual, and what takes the kernel longest to see.
    if (a == b || a == c || a == d || b == c || b == d || c == d) return Sign::zero;
    const std::array points{&a, &b, &c, &d};
    if (leave_range(points)) return orientation_by_whole_numbers(a, b, c, d);
    return sign(CGAL::orientation(in_space(a), in_space(b), in_space(c), in_space(d)));
}

bool are_collinear(const Point& a, const Point& b, const Point& c) {
    if (a == b || a == c || b == c) return true;
    return CGAL::collinear(in_space(a), in_space(b), in_space(c));
}

Sign coplanar_side(const Point& a, const Point& b, const Point& c, const Point& d) {
    return sign(CGAL::coplanar_orientation(in_space(a), in_space(b), in_space(c), in_space(d)));
}

Sign orientation_in_plane(const Point& a, const Point& b, const Point& c) {
    return sign(CGAL::orientation(in_plane(a), in_plane(b), in_plane(c)));
}

Sign in_circle_in_plane(const Point& a, const Point& b, const Point& c, const Point& d) {
    return sign(CGAL::side_of_oriented_circle(in_plane(a), in_plane(b), in_plane(c), in_plane(d)));
}

}  // namespace tightflip::geometry
