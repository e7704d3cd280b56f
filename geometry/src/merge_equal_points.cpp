#include "merge_equal_points.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tightflip::geometry {

void merge_equal_points(TriangleSoup& soup) {
    auto& points = soup.points;
    const auto at = [&](Index i) -> Eigen::Vector3d& {
        return points[static_cast<std::size_t>(i)];
    };
    // -0 compares equal to 0 but prints and hashes otherwise: only 0 is kept.
    for (Eigen::Vector3d& point : points)
        point.array() += 0.0;

    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, [&](Index a, Index b) {
        const auto &p = at(a), &q = at(b);
        return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
    });

    std::vector<Index> merged(points.size());  // first the equal point that comes first
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && at(order[i]) == at(order[i - 1]);
        merged[static_cast<std::size_t>(order[i])] =
            same ? merged[static_cast<std::size_t>(order[i - 1])] : order[i];
    }

    std::size_t kept = 0;  // then, in the order of appearance, its new number
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto first = static_cast<std::size_t>(merged[i]);
        if (first < i) {
            merged[i] = merged[first];
            continue;
        }
        points[kept] = points[i];
        soup.point_positions[kept] = soup.point_positions[i];
        merged[i] = static_cast<Index>(kept++);
    }
    points.resize(kept);
    soup.point_positions.resize(kept);
    for (auto& triangle : soup.triangles) {
        for (Index& corner : triangle)
            corner = merged[static_cast<std::size_t>(corner)];
    }
}

}  // namespace tightflip::geometry
