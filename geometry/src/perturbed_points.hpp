/// \file
/// Points of convex data, moved outwards by an amount too small to be a number, so that every one
/// becomes a corner of the hull.
#pragma once

#include <tightflip/geometry/exact_predicates.hpp>

#include <array>

namespace tightflip::geometry {

/// With a point c strictly inside the hull as origin, p is thought to lie at p / (1 + t |p|^2) for
/// a t > 0 as small as one likes. As 1 / (1 + t |p|^2) is strictly concave along lines, to first
/// order in t, points within a facet or an edge of the hull come to lie outside of what joins their
/// neighbours: data that are convex become strictly convex, and no three of them are on one line.
/// In homogeneous coordinates the point is (p, 1 + t |p|^2), so that signs of determinants need the
/// next coefficient in t where the first is zero, and none beyond.
/// (Edelsbrunner and Muecke, ACM Trans. Graph. 9 (1990), for the idea of such perturbations.)
class PerturbedPoints {
public:
    /// `inside` are labels of four points not in one plane; c is their mean.
    PerturbedPoints(Points points, const std::array<Index, 4>& inside)
        : points_(points), inside_(inside) {}

    /// `orientation` of the points so moved. Zero for points on one circle, or on a curve like it,
    /// in one plane.
    [[nodiscard]] Sign side(Vertex a, Vertex b, Vertex c, Vertex d) const {
        const Sign sign = orientation(point(a), point(b), point(c), point(d));
        return sign != Sign::zero ? sign : coefficient({a, b, c, d}, nullptr);
    }
    /// The same with `o`, any point, which stays where it is, in the place of the second.
    [[nodiscard]] Sign side_about(Vertex a, const Point& o, Vertex c, Vertex d) const {
        const Sign sign = orientation(point(a), o, point(c), point(d));
        return sign != Sign::zero ? sign : coefficient({a, Vertex{}, c, d}, &o);
    }

private:
    [[nodiscard]] const Point& point(Vertex v) const noexcept {
        return points_[static_cast<std::size_t>(v.id)];
    }
    /// The sign of the coefficient of t. A corner that is no vertex is `fixed`.
    [[nodiscard]] Sign coefficient(const std::array<Vertex, 4>& corners, const Point* fixed) const;

    Points points_;
    std::array<Index, 4> inside_;
};

}  // namespace tightflip::geometry
