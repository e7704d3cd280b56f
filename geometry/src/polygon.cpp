#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/polygon.hpp>

#include <algorithm>
#include <numeric>

namespace tightflip::geometry {
namespace {

bool is_before(const Point& a, const Point& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

/// Whether x, on the line of ab, lies between a and b or at one of them.
bool is_between(const Point& a, const Point& b, const Point& x) {
    return is_before(a, b) ? !is_before(x, a) && !is_before(b, x)
                           : !is_before(x, b) && !is_before(a, x);
}

/// Whether two closed segments have a point in common.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Sign abc = orientation_in_plane(a, b, c);
    const Sign abd = orientation_in_plane(a, b, d);
    const Sign cda = orientation_in_plane(c, d, a);
    const Sign cdb = orientation_in_plane(c, d, b);
    if (abc == Sign::zero && is_between(a, b, c)) return true;
    if (abd == Sign::zero && is_between(a, b, d)) return true;
    if (cda == Sign::zero && is_between(c, d, a)) return true;
    if (cdb == Sign::zero && is_between(c, d, b)) return true;
    return abc != Sign::zero && abc == -abd && cda != Sign::zero && cda == -cdb;
}

bool boxes_are_apart(const Point& a, const Point& b, const Point& c, const Point& d) {
    for (Eigen::Index i = 0; i < 2; ++i) {
        if (std::max(a[i], b[i]) < std::min(c[i], d[i])) return true;
        if (std::max(c[i], d[i]) < std::min(a[i], b[i])) return true;
    }
    return false;
}

/// Whether the way from a by way of b to c folds back upon itself, or stands still.
bool folds_back(const Point& a, const Point& b, const Point& c) {
    if (orientation_in_plane(a, b, c) != Sign::zero) return false;
    const auto at_b = [&](const Point& x) { return !is_before(x, b) && !is_before(b, x); };
    return at_b(a) || at_b(c) || is_before(a, b) == is_before(c, b);
}

/// A polygon from which corners are taken away.
class EarCutter {
public:
    explicit EarCutter(Points polygon) : points_(polygon), ring_(polygon.size()) {
        std::iota(ring_.begin(), ring_.end(), Index{0});
    }

    std::vector<Face> run() {
        std::vector<Face> triangles;
        std::size_t i = 0;
        while (ring_.size() > 3) {
            // A simple polygon has an ear, so that this ends.
            while (!is_ear(i))
                i = (i + 1) % ring_.size();
            triangles.push_back(triangle(i));
            ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
            i = (i + 1) % ring_.size();  // beside an ear its neighbours wait, for rounder triangles
        }
        triangles.push_back(triangle(1));
        return triangles;
    }

private:
    [[nodiscard]] const Point& point(Index i) const { return points_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] Face triangle(std::size_t i) const {
        const std::size_t n = ring_.size();
        return {ring_[(i + n - 1) % n], ring_[i], ring_[(i + 1) % n]};
    }
    [[nodiscard]] bool is_ear(std::size_t i) const {
        const auto [a, b, c] = triangle(i);
        if (orientation_in_plane(point(a), point(b), point(c)) != Sign::positive) return false;
        return std::ranges::none_of(ring_, [&, a = a, b = b, c = c](Index x) {
            if (x == a || x == b || x == c) return false;
            return orientation_in_plane(point(a), point(b), point(x)) != Sign::negative &&
                   orientation_in_plane(point(b), point(c), point(x)) != Sign::negative &&
                   orientation_in_plane(point(c), point(a), point(x)) != Sign::negative;
        });
    }

    Points points_;
    std::vector<Index> ring_;
};

}  // namespace

std::optional<std::array<Index, 2>> find_crossing_sides(Points polygon) {
    const std::size_t n = polygon.size();
    const auto corner = [&](std::size_t i) -> const Point& { return polygon[i % n]; };
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            const std::array sides{static_cast<Index>(i), static_cast<Index>(j)};
            if (j == i + 1 && folds_back(corner(i), corner(j), corner(j + 1))) return sides;
            if (i == 0 && j == n - 1 && folds_back(corner(j), corner(0), corner(1))) return sides;
            if (j == i + 1 || (i == 0 && j == n - 1)) continue;
            if (boxes_are_apart(corner(i), corner(i + 1), corner(j), corner(j + 1))) continue;
            if (segments_meet(corner(i), corner(i + 1), corner(j), corner(j + 1))) return sides;
        }
    }
    return std::nullopt;
}

bool is_counter_clockwise(Points polygon) {
    const std::size_t n = polygon.size();
    const auto least = std::ranges::min_element(polygon, is_before);
    const auto i = static_cast<std::size_t>(least - polygon.begin());
    return orientation_in_plane(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]) ==
           Sign::positive;
}

std::vector<Face> triangulate_polygon(Points polygon) {
    return EarCutter(polygon).run();
}

}  // namespace tightflip::geometry
