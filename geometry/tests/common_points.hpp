/// \file
/// What two triangles with small integer corners have in common, by another way than predicates:
/// weights of the corners of both that give the same point are the solutions of a linear programme,
/// and the extreme ones are found by trying every set of corners.
#pragma once

#include <tightflip/geometry/triangle_intersection.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <boost/rational.hpp>

namespace tightflip::geometry {

/// Compare with other fractions only: in C++20 its equality with an integer calls itself for ever.
using Fraction = boost::rational<std::int64_t>;
using FractionPoint = std::array<Fraction, 3>;

inline FractionPoint as_fractions(const Point& p) {
    return {Fraction(static_cast<std::int64_t>(p.x())), Fraction(static_cast<std::int64_t>(p.y())),
            Fraction(static_cast<std::int64_t>(p.z()))};
}

/// The only solution of a system of equations, each a row with its right side last; none where
/// there is no solution or more than one.
inline std::optional<std::vector<Fraction>> only_solution(std::vector<std::vector<Fraction>> rows) {
    const std::size_t unknowns = rows.front().size() - 1;
    for (std::size_t k = 0; k < unknowns; ++k) {
        std::size_t pivot = k;
        while (pivot < rows.size() && rows[pivot][k].numerator() == 0)
            ++pivot;
        if (pivot == rows.size()) return std::nullopt;
        std::swap(rows[k], rows[pivot]);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i == k || rows[i][k].numerator() == 0) continue;
            const Fraction factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j <= unknowns; ++j)
                rows[i][j] -= factor * rows[k][j];
        }
    }
    for (std::size_t i = unknowns; i < rows.size(); ++i) {
        if (rows[i][unknowns].numerator() != 0) return std::nullopt;
    }
    std::vector<Fraction> solution;
    for (std::size_t k = 0; k < unknowns; ++k)
        solution.push_back(rows[k][unknowns] / rows[k][k]);
    return solution;
}

/// Points whose hull is what the triangles have in common.
inline std::vector<FractionPoint> common_points(const Triangle& f, const Triangle& g) {
    std::vector<FractionPoint> result;
    for (unsigned set = 1; set < 64; ++set) {
        std::vector<unsigned> columns;
        for (unsigned i = 0; i < 6; ++i) {
            if ((set >> i & 1) != 0) columns.push_back(i);
        }
        std::vector<std::vector<Fraction>> rows(5);
        for (const unsigned i : columns) {
            const bool is_first = i < 3;
            const FractionPoint corner = as_fractions(is_first ? f[i] : g[i - 3]);
            for (std::size_t axis = 0; axis < 3; ++axis)
                rows[axis].push_back(is_first ? corner[axis] : -corner[axis]);
            rows[3].emplace_back(is_first ? 1 : 0);
            rows[4].emplace_back(is_first ? 0 : 1);
        }
        for (std::size_t i = 0; i < 5; ++i)
            rows[i].emplace_back(i < 3 ? 0 : 1);
        if (columns.size() > rows.size()) continue;
        const auto weights = only_solution(rows);
        if (!weights ||
            std::ranges::any_of(*weights, [](const Fraction& w) { return w.numerator() < 0; })) {
            continue;
        }
        FractionPoint point{};
        for (std::size_t k = 0; k < columns.size() && columns[k] < 3; ++k) {
            const FractionPoint corner = as_fractions(f[columns[k]]);
            for (std::size_t axis = 0; axis < 3; ++axis)
                point[axis] += (*weights)[k] * corner[axis];
        }
        result.push_back(point);
    }
    return result;
}

inline FractionPoint cross_of_differences(const FractionPoint& a, const FractionPoint& b,
                                          const FractionPoint& c) {
    FractionPoint u;
    FractionPoint v;
    for (std::size_t i = 0; i < 3; ++i) {
        u[i] = b[i] - a[i];
        v[i] = c[i] - a[i];
    }
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// The dimension of the hull of points, as long as it is no more than two.
inline Contact dimension(const std::vector<FractionPoint>& points) {
    if (points.empty()) return Contact::none;
    Contact result = Contact::point;
    for (const FractionPoint& b : points) {
        if (b == points[0]) continue;
        if (result == Contact::point) result = Contact::segment;
        for (const FractionPoint& c : points) {
            if (cross_of_differences(points[0], b, c) != FractionPoint{}) return Contact::area;
        }
    }
    return result;
}

/// Whether x lies in the hull of one or two points.
inline bool lies_in_hull(const FractionPoint& x, const FractionPoint& a, const FractionPoint& b) {
    if (cross_of_differences(a, b, x) != FractionPoint{}) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (x[i] < std::min(a[i], b[i]) || x[i] > std::max(a[i], b[i])) return false;
    }
    return true;
}

}  // namespace tightflip::geometry
