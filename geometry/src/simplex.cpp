#include "simplex.hpp"

#include <tightflip/geometry/exact_predicates.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

/// Of the items, the one with the largest value, where it `holds`; or else the first that does.
template <class Value, class Holds>
std::optional<Index> best_or_any(const std::vector<Index>& items, Value&& value, Holds&& holds) {
    const auto best = std::ranges::max_element(items, {}, value);
    if (holds(*best)) return *best;
    const auto any = std::ranges::find_if(items, holds);
    return any == items.end() ? std::nullopt : std::optional(*any);
}

/// A number that orders, whatever the arithmetic made of it.
double ordered(double value) {
    return std::isnan(value) ? 0 : value;
}

}  // namespace

DataFault choose_simplex(Points points, const std::vector<Index>& labels,
                         std::array<Index, 4>& corners) {
    const auto point = [&](Index i) -> const Point& { return points[static_cast<std::size_t>(i)]; };
    const Point& a = point(labels.front());
    const Point& b = point(labels.back());
    const auto third = best_or_any(
        labels, [&](Index i) { return ordered((b - a).cross(point(i) - a).squaredNorm()); },
        [&](Index i) { return !are_collinear(a, b, point(i)); });
    if (!third) return DataFault::collinear_points;
    const Point& c = point(*third);
    const Point normal = (b - a).cross(c - a);
    const auto fourth = best_or_any(
        labels, [&](Index i) { return ordered(std::abs(normal.dot(point(i) - a))); },
        [&](Index i) { return orientation(a, b, c, point(i)) != Sign::zero; });
    if (!fourth) return DataFault::coplanar_points;
    corners = {labels.front(), labels.back(), *third, *fourth};
    // The fourth lies below the first face.
    if (orientation(a, b, c, point(*fourth)) == Sign::positive) std::swap(corners[0], corners[1]);
    return DataFault::none;
}

}  // namespace tightflip::geometry
