/// \file
/// Convex cones about the origin without order, bisection or library predicates: all triples of
/// rays. Exact for small integer coordinates, right in general position otherwise.
#pragma once

#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tightflip::geometry {

template <class Predicate>
bool any_triple(const std::vector<Point>& rays, Predicate holds) {
    for (const Point& a : rays) {
        for (const Point& b : rays) {
            if (std::ranges::any_of(rays, [&](const Point& c) { return holds(a, b, c); })) {
                return true;
            }
        }
    }
    return false;
}

/// Whether the rays do not all lie in one plane.
inline bool span_space(const std::vector<Point>& rays) {
    return any_triple(rays, [](const Point& a, const Point& b, const Point& c) {
        return a.dot(b.cross(c)) != 0;
    });
}

/// Whether the cone contains no line, for rays that span space: no ray's opposite is then in the
/// cone of three others (by Cramer's rule).
inline bool is_pointed_by_triples(const std::vector<Point>& rays) {
    return std::ranges::none_of(rays, [&](const Point& x) {
        return any_triple(rays, [&](const Point& a, const Point& b, const Point& c) {
            const double whole = a.dot(b.cross(c));
            return whole != 0 && x.dot(b.cross(c)) * whole <= 0 && a.dot(x.cross(c)) * whole <= 0 &&
                   a.dot(b.cross(x)) * whole <= 0;
        });
    });
}

/// Whether a side of the pointed cone runs from u to v, both among the rays: all are below the
/// plane through them, and those on it lie between.
inline bool is_side(const std::vector<Point>& rays, const Point& u, const Point& v) {
    const Point normal = u.cross(v);
    if (normal.isZero(0)) return false;
    return std::ranges::all_of(rays, [&](const Point& x) {
        if (x == u || x == v) return true;
        const double height = normal.dot(x);
        if (height != 0) return height < 0;
        return normal.dot(u.cross(x)) >= 0 && normal.dot(x.cross(v)) >= 0;
    });
}

/// The circumference of a pointed cone of rays that span space; 2 pi of one that is not pointed.
inline double circumference_by_triples(const std::vector<Point>& rays) {
    if (!is_pointed_by_triples(rays)) return 2 * std::numbers::pi;
    std::vector<Point> distinct;
    for (const Point& ray : rays) {
        if (std::ranges::none_of(distinct, [&](const Point& other) {
                return ray.cross(other).isZero(0) && ray.dot(other) > 0;
            })) {
            distinct.push_back(ray);
        }
    }
    double sum = 0;
    for (const Point& u : distinct) {
        for (const Point& v : distinct) {
            if (is_side(rays, u, v))
                sum += 2 * std::asin((u.normalized() - v.normalized()).norm() / 2);
        }
    }
    return sum;
}

}  // namespace tightflip::geometry
