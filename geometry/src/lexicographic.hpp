/// \file
/// Points in lexicographic order, and what is found on the way: those that coincide.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

namespace tightflip::geometry {

/// The lowest label of a point with a coordinate that is not finite.
[[nodiscard]] inline std::optional<Index> point_not_finite(Points points) {
    const auto bad =
        std::ranges::find_if(points, [](const Point& point) { return !point.allFinite(); });
    if (bad == points.end()) return std::nullopt;
    return static_cast<Index>(bad - points.begin());
}

/// The labels of the distinct points in lexicographic order of their first `dimension` coordinates;
/// of those that coincide only the lowest, the others going to `coincident` with the lowest. O(n
/// log n).
template <int dimension>
[[nodiscard]] std::vector<Index> distinct_labels(Points points,
                                                 std::vector<std::array<Index, 2>>& coincident) {
    const auto at = [&](Index i) { return points[static_cast<std::size_t>(i)].head<dimension>(); };
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, [&](Index a, Index b) {
        const auto p = at(a);
        const auto q = at(b);
        for (Eigen::Index k = 0; k < dimension; ++k) {
            if (p[k] != q[k]) return p[k] < q[k];
        }
        return a < b;
    });
    std::size_t kept = 0;
    for (const Index i : order) {
        if (kept > 0 && at(order[kept - 1]) == at(i)) {
            coincident.push_back({i, order[kept - 1]});
        } else {
            order[kept++] = i;
        }
    }
    order.resize(kept);
    return order;
}

[[nodiscard]] inline std::vector<Index> distinct_in_space(
    Points points, std::vector<std::array<Index, 2>>& coincident) {
    return distinct_labels<3>(points, coincident);
}
[[nodiscard]] inline std::vector<Index> distinct_in_plane(
    Points points, std::vector<std::array<Index, 2>>& coincident) {
    return distinct_labels<2>(points, coincident);
}

}  // namespace tightflip::geometry
