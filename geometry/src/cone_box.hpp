/// \file
/// Bounds of thin faces about one vertex, which boxes hold badly.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <algorithm>

#include <Eigen/Geometry>

namespace tightflip::geometry {

using Box = Eigen::AlignedBox3d;

/// The convex hull of an apex and a box; with the apex in the middle of the box, the box.
struct ConeBox {
    Point apex{0, 0, 0};
    Box far;

    [[nodiscard]] static ConeBox of(const Box& box) { return {middle(box), box}; }
    [[nodiscard]] Point middle_of_far() const { return middle(far); }
    [[nodiscard]] static Point middle(const Box& box) { return box.min() * 0.5 + box.max() * 0.5; }
};

/// Where the hull lies along a direction, rounded outwards: the margin is thousands of times what
/// the roundings of these sums of three products can do.
struct Shadow {
    double low;
    double high;

    Shadow(const ConeBox& cone, const Point& axis) {
        const Point middle = cone.middle_of_far();
        const Point half = cone.far.max() * 0.5 - cone.far.min() * 0.5;
        const Point size = middle.cwiseAbs() + half + cone.apex.cwiseAbs();
        const double margin = 1e-12 * axis.cwiseAbs().dot(size) + 1e-300;
        const double centre = axis.dot(middle);
        const double reach = axis.cwiseAbs().dot(half);
        const double apex = axis.dot(cone.apex);
        low = std::min(centre - reach, apex) - margin;
        high = std::max(centre + reach, apex) + margin;
    }
};

/// Whether a plane is seen to separate the two. A yes is certain: what lies apart along any
/// direction is apart, and what is not a number compares as not. A no says nothing.
[[nodiscard]] inline bool are_separated(const ConeBox& p, const ConeBox& q) {
    const Point u = p.middle_of_far() - p.apex;
    const Point v = q.middle_of_far() - q.apex;
    Point axis = u.cross(v);
    if (axis.isZero(0)) {  // one of them is a box, or both: from the nearest point of the other
        const bool is_first = v.isZero(0);
        const Point& from = is_first ? p.apex : q.apex;
        const Point& along = is_first ? u : v;
        const Point way = (is_first ? q.apex : p.apex) - from;
        const double length = along.squaredNorm();
        axis = way;
        if (length > 0) axis -= along * std::clamp(way.dot(along) / length, 0.0, 1.0);
    }
    if (!(axis.squaredNorm() > 1e-200)) return false;  // products might vanish beside the margin
    const Shadow a(p, axis);
    const Shadow b(q, axis);
    return a.high < b.low || b.high < a.low;
}

}  // namespace tightflip::geometry
