/// \file
/// Doubles as whole numbers, in units of a power of two that divides them all: for signs that must
/// be exact where the doubles are of any size. Without the common divisors that fractions look for.
#pragma once

#include <tightflip/geometry/exact_predicates.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <boost/multiprecision/cpp_int.hpp>

namespace tightflip::geometry {

using Integer = boost::multiprecision::cpp_int;

/// The exponent of the last bit of a double that may be set; of zero, the largest int.
[[nodiscard]] inline int last_bit(double value) {
    return value == 0 ? std::numeric_limits<int>::max()
                      : std::ilogb(value) - (std::numeric_limits<double>::digits - 1);
}

/// The exponent of the largest unit in which all coordinates are whole.
[[nodiscard]] inline int common_unit(std::span<const Point* const> points) {
    int unit = std::numeric_limits<int>::max();
    for (const Point* p : points) {
        for (const double coordinate : *p)
            unit = std::min(unit, last_bit(coordinate));
    }
    return unit;
}

/// value / 2^exponent, which is whole.
[[nodiscard]] inline Integer in_units(double value, int exponent) {
    if (value == 0) return 0;
    const int last = last_bit(value);
    Integer digits = static_cast<std::int64_t>(std::ldexp(value, -last));
    digits <<= last - exponent;
    return digits;
}

using IntegerVector = std::array<Integer, 3>;

/// (to - from) / 2^exponent.
[[nodiscard]] inline IntegerVector difference_in_units(const Point& from, const Point& to,
                                                       int exponent) {
    IntegerVector difference;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        difference[axis] = in_units(to[k], exponent) - in_units(from[k], exponent);
    }
    return difference;
}

/// `orientation`, without a filter: where doubles leave no room for one far quicker than CGAL's
/// numbers, and slower elsewhere.
[[nodiscard]] Sign orientation_by_whole_numbers(const Point& a, const Point& b, const Point& c,
                                                const Point& d);

}  // namespace tightflip::geometry
