#include "face_mesh.hpp"
#include "lexicographic.hpp"
#include <tightflip/geometry/cross_sections.hpp>
#include <tightflip/geometry/polygon.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

using Faces = std::vector<Face>;

double area(const Point& a, const Point& b, const Point& c) {
    return (b - a).cross(c - a).stableNorm() / 2;
}

/// What is wrong with section `s`, whose corners have labels from `first` on.
DataRefusal refusal_of(std::span<const Contour> sections, std::size_t s, Index first) {
    const Contour& contour = sections[s];
    const auto section = static_cast<Index>(s);
    if (contour.size() < 3) return {DataFault::contour_too_short, {section, -1}};
    if (const auto bad = point_not_finite(contour)) {
        return {DataFault::not_finite, {first + *bad, -1}};
    }
    const double height = contour.front().z();
    const auto other =
        std::ranges::find_if(contour, [&](const Point& p) { return p.z() != height; });
    if (other != contour.end()) {
        return {DataFault::contour_not_horizontal,
                {section, first + static_cast<Index>(other - contour.begin())}};
    }
    if (s > 0 && !(sections[s - 1].front().z() < height)) {
        return {DataFault::contours_not_ascending, {section, -1}};
    }
    if (const auto sides = find_crossing_sides(contour)) {
        return {DataFault::contour_not_simple, {first + (*sides)[0], first + (*sides)[1]}};
    }
    return {};
}

/// A band between two rings of labels, both counter-clockwise seen from above, the first the lower.
class Band {
public:
    Band(Points points, std::vector<Index> lower, std::vector<Index> upper)
        : points_(points), lower_(std::move(lower)), upper_(std::move(upper)) {
        turn_to_shortest_segment();
    }

    void add_to(Faces& faces) const {
        const Tiling rising = best_tiling(true);
        const Tiling falling = best_tiling(false);
        const Tiling& best = falling.area < rising.area ? falling : rising;
        std::size_t i = 0;
        std::size_t j = 0;
        for (const bool along_lower : best.steps) {
            faces.push_back(triangle(i, j, along_lower));
            ++(along_lower ? i : j);
        }
    }

private:
    struct Tiling {
        double area = 0;
        std::vector<bool> steps;  ///< whether the next triangle has a side of the lower ring
    };

    [[nodiscard]] const Point& point(Index i) const { return points_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] Index lower(std::size_t i) const { return lower_[i % lower_.size()]; }
    [[nodiscard]] Index upper(std::size_t j) const { return upper_[j % upper_.size()]; }
    [[nodiscard]] Face triangle(std::size_t i, std::size_t j, bool along_lower) const {
        return {lower(i), along_lower ? lower(i + 1) : upper(j + 1), upper(j)};
    }

    void turn_to_shortest_segment() {
        std::size_t from = 0;
        std::size_t to = 0;
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < lower_.size(); ++i) {
            for (std::size_t j = 0; j < upper_.size(); ++j) {
                const double length = (point(lower_[i]) - point(upper_[j])).stableNorm();
                if (length < shortest) {
                    shortest = length;
                    from = i;
                    to = j;
                }
            }
        }
        std::rotate(lower_.begin(), lower_.begin() + static_cast<std::ptrdiff_t>(from),
                    lower_.end());
        std::rotate(upper_.begin(), upper_.begin() + static_cast<std::ptrdiff_t>(to), upper_.end());
    }

    /// The least area of a way over the grid of pairs (i, j) from the first pair, all round, to
    /// itself. The first step goes along one ring and the last along the other, which keeps the way
    /// off two borders but for their ends, and the corner between the other two is left out: so no
    /// pair comes twice.
    [[nodiscard]] Tiling best_tiling(bool first_along_lower) const {
        const std::size_t m = lower_.size();
        const std::size_t n = upper_.size();
        constexpr double never = std::numeric_limits<double>::infinity();
        const auto is_admitted = [&](std::size_t i, std::size_t j) {
            if ((i == 0 && j == 0) || (i == m && j == n)) return true;
            return first_along_lower ? i > 0 && j < n && (i < m || j > 0)
                                     : j > 0 && i < m && (j < n || i > 0);
        };
        const auto at = [&](std::size_t i, std::size_t j) { return i * (n + 1) + j; };
        std::vector<double> least((m + 1) * (n + 1), never);
        std::vector<bool> came_along_lower(least.size(), false);
        least[0] = 0;
        const auto reach = [&](std::size_t i, std::size_t j, bool along_lower) {
            const std::size_t k = along_lower ? i - 1 : i;
            const std::size_t l = along_lower ? j : j - 1;
            const auto [a, b, c] = triangle(k, l, along_lower);
            if (!is_admitted(k, l)) return;
            // Not never, even where areas exceed the range: there is a way to every pair admitted.
            constexpr double most = std::numeric_limits<double>::max();
            double sum = least[at(k, l)] + area(point(a), point(b), point(c));
            if (!(sum < most)) sum = most;
            if (!(sum < least[at(i, j)])) return;
            least[at(i, j)] = sum;
            came_along_lower[at(i, j)] = along_lower;
        };
        for (std::size_t i = 0; i <= m; ++i) {
            for (std::size_t j = 0; j <= n; ++j) {
                if (!is_admitted(i, j)) continue;
                if (i > 0) reach(i, j, true);
                if (j > 0) reach(i, j, false);
            }
        }
        Tiling tiling{.area = least[at(m, n)], .steps = {}};
        for (std::size_t i = m, j = n; i + j > 0;) {
            tiling.steps.push_back(came_along_lower[at(i, j)]);
            --(tiling.steps.back() ? i : j);
        }
        std::reverse(tiling.steps.begin(), tiling.steps.end());
        return tiling;
    }

    Points points_;
    std::vector<Index> lower_;
    std::vector<Index> upper_;
};

/// Adds the triangles of a ring's polygon, facing up or down.
void add_cap(Faces& faces, Points points, const std::vector<Index>& ring, bool faces_up) {
    std::vector<Point> polygon;
    polygon.reserve(ring.size());
    for (const Index v : ring)
        polygon.push_back(points[static_cast<std::size_t>(v)]);
    for (const auto& [a, b, c] : triangulate_polygon(polygon)) {
        const std::array labels{ring[static_cast<std::size_t>(a)],
                                ring[static_cast<std::size_t>(b)],
                                ring[static_cast<std::size_t>(c)]};
        faces.push_back(faces_up ? labels : std::array{labels[1], labels[0], labels[2]});
    }
}

}  // namespace

Outcome<Surface> surface_from_cross_sections(std::span<const Contour> sections) {
    if (sections.size() < 2) return DataRefusal{DataFault::too_few_sections};
    std::vector<Point> points;
    std::vector<std::vector<Index>> rings;  // counter-clockwise seen from above
    for (std::size_t s = 0; s < sections.size(); ++s) {
        const auto first = static_cast<Index>(points.size());
        const DataRefusal refusal = refusal_of(sections, s, first);
        if (refusal.fault != DataFault::none) return refusal;
        std::vector<Index>& ring = rings.emplace_back(sections[s].size());
        std::iota(ring.begin(), ring.end(), first);
        if (!is_counter_clockwise(sections[s])) std::ranges::reverse(ring);
        points.insert(points.end(), sections[s].begin(), sections[s].end());
    }
    Faces faces;
    add_cap(faces, points, rings.front(), false);
    for (std::size_t s = 0; s + 1 < rings.size(); ++s)
        Band(points, rings[s], rings[s + 1]).add_to(faces);
    add_cap(faces, points, rings.back(), true);
    return surface_of_faces(faces, std::move(points));
}

}  // namespace tightflip::geometry
