#include "directions.hpp"
#include "face_mesh.hpp"
#include <tightflip/geometry/convex_cone.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/star_shaped.hpp>

#include <algorithm>
#include <numeric>

namespace tightflip::geometry {
namespace {

bool is_strictly_inside(const Point& centre, Points points, const std::vector<Face>& faces) {
    const auto at = [&](Index i) -> const Point& { return points[static_cast<std::size_t>(i)]; };
    return std::ranges::all_of(faces, [&](const Face& face) {
        return orientation(at(face[0]), at(face[1]), at(face[2]), centre) == Sign::negative;
    });
}

/// Two points in one direction. Their projections differ by rounding alone, and so do the heights
/// of these over a plane in no special position, along which candidates are sorted.
std::optional<std::array<Index, 2>> find_shared_direction(Points points, const Point& centre,
                                                          Points projections) {
    const Point slope(0.5772156649, 0.6931471806, 0.4342944819);
    constexpr double rounding = 0x1p-48;
    std::vector<std::pair<double, Index>> heights;
    for (std::size_t i = 0; i < projections.size(); ++i)
        heights.emplace_back(slope.dot(projections[i]), static_cast<Index>(i));
    std::ranges::sort(heights);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        for (std::size_t j = i + 1; j < heights.size(); ++j) {
            if (heights[j].first - heights[i].first > rounding) break;
            const auto [a, b] = std::minmax(heights[i].second, heights[j].second);
            const auto first = static_cast<std::size_t>(a);
            const auto second = static_cast<std::size_t>(b);
            if (same_direction(centre, points[first], points[second])) return std::array{a, b};
        }
    }
    return std::nullopt;
}

/// The face that the ray from the origin through x meets.
Index face_in_front(const FaceMesh& mesh, Points projections, const Point& x) {
    const Point origin = Point::Zero();
    const auto at = [&](Index i) -> const Point& {
        return projections[static_cast<std::size_t>(i)];
    };
    const auto found = std::ranges::find_if(mesh.faces(), [&](const Face& face) {
        const auto& [a, b, c] = face;
        return orientation(origin, at(a), at(b), x) != Sign::negative &&
               orientation(origin, at(b), at(c), x) != Sign::negative &&
               orientation(origin, at(c), at(a), x) != Sign::negative;
    });
    return static_cast<Index>(found - mesh.faces().begin());
}

}  // namespace

Outcome<StarShapedSurface> star_shaped_surface(std::vector<Point> points, const Point& centre) {
    if (!centre.allFinite()) return DataRefusal{DataFault::centre_outside};
    const Outcome<ConvexHull> data_hull = convex_hull(points);
    if (!data_hull) return data_hull.refusal();
    if (!is_strictly_inside(centre, points, data_hull.value().faces)) {
        return DataRefusal{DataFault::centre_outside};
    }
    const auto at_centre = std::ranges::find(points, centre);
    if (at_centre != points.end()) {
        const auto label = static_cast<Index>(at_centre - points.begin());
        return DataRefusal{DataFault::shared_direction, {label, label}};
    }
    std::vector<Point> projections;
    projections.reserve(points.size());
    for (const Point& point : points)
        projections.push_back(direction(centre, point).normalized());
    if (const auto pair = find_shared_direction(points, centre, projections)) {
        return DataRefusal{DataFault::shared_direction, *pair};
    }
    const Outcome<ConvexHull> hull = convex_hull(projections);
    if (!hull || !is_strictly_inside(Point::Zero(), projections, hull.value().faces)) {
        return DataRefusal{DataFault::centre_outside};
    }
    FaceMesh mesh(hull.value().faces, static_cast<Index>(points.size()));
    std::vector<bool> is_corner(points.size(), false);
    for (const Face& face : hull.value().faces) {
        for (const Index v : face)
            is_corner[static_cast<std::size_t>(v)] = true;
    }
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (is_corner[v]) continue;
        mesh.split_face(face_in_front(mesh, projections, projections[v]), static_cast<Index>(v));
    }
    Index turned_away = 0;
    for (const auto& [a, b, c] : mesh.faces()) {
        const auto at = [&](Index i) -> const Point& {
            return points[static_cast<std::size_t>(i)];
        };
        turned_away += orientation(at(a), at(b), at(c), centre) == Sign::negative ? 0 : 1;
    }
    return StarShapedSurface{surface_of_faces(mesh.faces(), std::move(points)), turned_away};
}

}  // namespace tightflip::geometry
