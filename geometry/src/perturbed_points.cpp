#include "perturbed_points.hpp"

#include "whole_numbers.hpp"

#include <algorithm>

namespace tightflip::geometry {
namespace {

using Row = std::array<Integer, 4>;

Integer determinant(const std::array<Row, 4>& m) {
    const auto minor = [&](std::size_t i, std::size_t j) -> Integer {  // of the first two columns
        return m[i][0] * m[j][1] - m[j][0] * m[i][1];
    };
    const auto rest = [&](std::size_t i, std::size_t j) -> Integer {
        return m[i][2] * m[j][3] - m[j][2] * m[i][3];
    };
    // Laplace's expansion by pairs of rows.
    return minor(0, 1) * rest(2, 3) - minor(0, 2) * rest(1, 3) + minor(0, 3) * rest(1, 2) +
           minor(1, 2) * rest(0, 3) - minor(1, 3) * rest(0, 2) + minor(2, 3) * rest(0, 1);
}

}  // namespace

Sign PerturbedPoints::coefficient(const std::array<Vertex, 4>& corners, const Point* fixed) const {
    std::array<const Point*, 4> used{};
    std::ranges::transform(corners, used.begin(),
                           [&](Vertex v) { return v.is_valid() ? &point(v) : fixed; });
    std::array<const Point*, 4> inside{};
    std::ranges::transform(inside_, inside.begin(), [&](Index label) { return &point({label}); });

    const int unit = std::min(common_unit(used), common_unit(inside));
    std::array<Integer, 3> sum;
    for (const Point* p : inside) {
        for (int axis = 0; axis < 3; ++axis)
            sum[static_cast<std::size_t>(axis)] += in_units((*p)[axis], unit);
    }
    // Four times each point, from the sum of four: c is the origin, and all are whole numbers.
    std::array<Row, 4> rows;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Integer& x = rows[i][axis];
            x = 4 * in_units((*used[i])[static_cast<int>(axis)], unit) - sum[axis];
            if (used[i] != fixed) rows[i][3] += x * x;
        }
    }
    // Four points as rows with a last column of ones have minus the determinant of differences.
    return static_cast<Sign>(-determinant(rows).sign());
}

}  // namespace tightflip::geometry
