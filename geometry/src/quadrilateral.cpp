#include "whole_numbers.hpp"
#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/quadrilateral.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace tightflip::geometry {
namespace {

Integer dot(const IntegerVector& u, const IntegerVector& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/// x |x|, which is ordered as x is.
Integer signed_square(const Integer& x) {
    return x * abs(x);
}

Sign exact_sign_of_cosines(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int unit = common_unit(std::array{&a, &b, &c, &d});
    const IntegerVector u = difference_in_units(a, b, unit);
    const IntegerVector p = difference_in_units(a, c, unit);
    const IntegerVector q = difference_in_units(a, d, unit);
    const Integer sum = signed_square(dot(u, p)) * dot(q, q) + signed_square(dot(u, q)) * dot(p, p);
    return static_cast<Sign>(sum.sign());
}

bool is_moderate(const Point& vector) {
    const double largest = vector.cwiseAbs().maxCoeff();
    return largest > 1e-60 && largest < 1e60;
}

/// The sign of cos bac + cos bad, which is that of (u.p) |q| + (u.q) |p| for the vectors u, p, q
/// from a to b, c, d: positive where the two angles add up to less than pi.
Sign sign_of_cosines(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Point u = b - a;
    const Point p = c - a;
    const Point q = d - a;
    if (is_moderate(u) && is_moderate(p) && is_moderate(q)) {
        const double value = u.dot(p) * q.norm() + u.dot(q) * p.norm();
        const double size =
            u.cwiseAbs().dot(p.cwiseAbs()) * q.norm() + u.cwiseAbs().dot(q.cwiseAbs()) * p.norm();
        // The relative errors of the differences (1), products (1), sums (2), lengths (3.5) and the
        // last operations (2) add up to less than eleven roundings of `size`; what underflows in
        // moderate vectors stays below the constant.
        const double bound = 16 * std::numeric_limits<double>::epsilon() * size + 1e-200;
        if (value > bound) return Sign::positive;
        if (value < -bound) return Sign::negative;
    }
    return exact_sign_of_cosines(a, b, c, d);
}

}  // namespace

Development development(const Hinge& hinge) {
    const auto& [a, b, c, d] = hinge;
    if (are_collinear(a, b, c) || are_collinear(a, b, d)) return Development::degenerate;
    switch (std::min(sign_of_cosines(a, b, c, d), sign_of_cosines(b, a, c, d))) {
        case Sign::negative:
            return Development::reflex;
        case Sign::zero:
            return Development::straight;
        case Sign::positive:
            break;
    }
    return Development::convex;
}

QuadrilateralType quadrilateral_type(const Hinge& hinge) {
    const EdgeShape edge = edge_shape(hinge);
    if (edge != EdgeShape::convex && edge != EdgeShape::concave) return QuadrilateralType::none;
    const bool is_convex = edge == EdgeShape::convex;
    switch (development(hinge)) {
        case Development::convex:
            return is_convex ? QuadrilateralType::cc : QuadrilateralType::cr;
        case Development::reflex:
            return is_convex ? QuadrilateralType::rc : QuadrilateralType::rr;
        case Development::straight:
        case Development::degenerate:
            break;
    }
    return QuadrilateralType::none;
}

}  // namespace tightflip::geometry
