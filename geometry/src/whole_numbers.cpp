#include "whole_numbers.hpp"

namespace tightflip::geometry {

Sign orientation_by_whole_numbers(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int unit = common_unit(std::array{&a, &b, &c, &d});
    const IntegerVector u = difference_in_units(a, b, unit);
    const IntegerVector v = difference_in_units(a, c, unit);
    const IntegerVector w = difference_in_units(a, d, unit);
    const Integer determinant = u[2] * (v[0] * w[1] - v[1] * w[0]) +
                                v[2] * (w[0] * u[1] - w[1] * u[0]) +
                                w[2] * (u[0] * v[1] - u[1] * v[0]);
    return static_cast<Sign>(determinant.sign());
}

}  // namespace tightflip::geometry
