#include <tightflip/geometry/convex_cone.hpp>
#include <tightflip/geometry/exact_predicates.hpp>

#include <array>
#include <utility>

namespace tightflip::geometry {
namespace {

/// Of three collinear points: whether b and c lie on the same side of the apex, on other sides, or
/// one of them on it (zero).
Sign side_on_line(const Point& apex, const Point& b, const Point& c) {
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (b[i] == apex[i] || c[i] == apex[i]) continue;
        return (b[i] > apex[i]) == (c[i] > apex[i]) ? Sign::positive : Sign::negative;
    }
    return Sign::zero;
}

}  // namespace

bool same_direction(const Point& apex, const Point& b, const Point& c) {
    if (side_on_line(apex, b, c) != Sign::positive) return false;
    return b == c || are_collinear(apex, b, c);
}

bool opposite_direction(const Point& apex, const Point& b, const Point& c) {
    return side_on_line(apex, b, c) == Sign::negative && are_collinear(apex, b, c);
}

/// One ray more. Rays are directions, that is points of a sphere, and a pointed cone of three rays
/// or more is a convex polygon on it; side i runs from corner i to the one after it. A ray sees a
/// side from beyond where the orientation is positive.
struct ConvexCone::Insertion {
    const Point& apex;
    Points targets;
    std::vector<Index>& rays;

    [[nodiscard]] const Point& target(Index i) const {
        return targets[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const Point& corner(std::size_t i) const {
        return target(rays[i < rays.size() ? i : i - rays.size()]);
    }
    [[nodiscard]] Sign beyond(std::size_t side, const Point& x) const {
        return orientation(apex, corner(side), corner(side + 1), x);
    }

    /// Inserts a ray; false where the cone then contains a line.
    [[nodiscard]] bool insert(Index ray) const {
        switch (rays.size()) {
            case 0:
                rays.push_back(ray);
                return true;
            case 1:
                return beside_a_ray(ray);
            case 2:
                return beside_a_wedge(ray);
            default:
                return beside_a_polygon(ray);
        }
    }

    [[nodiscard]] bool beside_a_ray(Index ray) const {
        if (are_collinear(apex, corner(0), target(ray))) {
            return same_direction(apex, corner(0), target(ray));
        }
        rays.push_back(ray);
        return true;
    }

    [[nodiscard]] bool beside_a_wedge(Index ray) const {
        const Point& x = target(ray);
        const Sign above = orientation(apex, corner(0), corner(1), x);
        if (above != Sign::zero) {
            if (above == Sign::positive) std::swap(rays[0], rays[1]);
            rays.push_back(ray);
            return true;
        }
        const Sign inside0 = coplanar_side(apex, corner(0), corner(1), x);
        const Sign inside1 = coplanar_side(apex, corner(1), corner(0), x);
        if (inside0 != Sign::negative && inside1 != Sign::negative) return true;
        if (inside0 != Sign::positive && inside1 != Sign::positive) return false;
        rays[inside0 == Sign::negative ? 0 : 1] = ray;
        return true;
    }

    [[nodiscard]] bool beside_a_polygon(Index ray) const {
        const Point& x = target(ray);
        const std::size_t n = rays.size();
        const std::size_t seen = side_seen_from(x);
        if (seen == n) return true;
        // The sides seen, and those in whose planes x lies, are consecutive: first ..
        // first+count-1.
        std::size_t first = seen;
        std::size_t count = 1;
        while (count < n && beyond((first + n - 1) % n, x) != Sign::negative) {
            first = (first + n - 1) % n;
            ++count;
        }
        while (count < n && beyond((first + count) % n, x) != Sign::negative) {
            ++count;
        }
        if (count == n) return false;  // no side turns its inner face to x: -x lies in the cone
        replace(first + 1, count - 1, ray);
        return true;
    }

    /// A side that x lies strictly beyond, or n where x lies in the cone. The planes through corner
    /// 0 and another corner are in angular order about the ray of corner 0, which serves for
    /// bisection.
    [[nodiscard]] std::size_t side_seen_from(const Point& x) const {
        const std::size_t n = rays.size();
        if (beyond(0, x) == Sign::positive) return 0;
        if (beyond(n - 1, x) == Sign::positive) return n - 1;
        std::size_t low = 1;
        std::size_t high = n - 1;
        while (high - low > 1) {
            const std::size_t middle = low + (high - low) / 2;
            const bool is_after = orientation(apex, corner(0), corner(middle), x) != Sign::positive;
            (is_after ? low : high) = middle;
        }
        return beyond(low, x) == Sign::positive ? low : n;
    }

    /// Of the rays before one that was refused, three or fewer that contain a line together with
    /// it: its opposite lies in the cone of these.
    [[nodiscard]] std::array<std::size_t, 3> line_with(const Point& x) const {
        const std::size_t n = rays.size();
        for (std::size_t i = 1; i + 2 < n; ++i) {
            const bool contains_opposite =
                orientation(apex, corner(0), corner(i), x) != Sign::negative &&
                orientation(apex, corner(i), corner(i + 1), x) != Sign::negative &&
                orientation(apex, corner(i + 1), corner(0), x) != Sign::negative;
            if (contains_opposite) return {0, i, i + 1};
        }
        return {0, n - 2, n - 1};  // the last of the fan, as the others were not
    }

    /// Puts a ray in place of `count` consecutive corners from `first` on (cyclically), or between
    /// the corners before and at `first` where there are none to replace.
    void replace(std::size_t first, std::size_t count, Index ray) const {
        const auto begin = rays.begin();
        const std::size_t n = rays.size();
        if (first + count > n) {  // also at the front
            rays.erase(begin + static_cast<std::ptrdiff_t>(first), rays.end());
            rays.erase(begin, begin + static_cast<std::ptrdiff_t>(first + count - n));
            rays.push_back(ray);
            return;
        }
        const auto place = begin + static_cast<std::ptrdiff_t>(first);
        if (count == 0) {
            rays.insert(place, ray);
            return;
        }
        *place = ray;
        rays.erase(place + 1, place + static_cast<std::ptrdiff_t>(count));
    }
};

void ConvexCone::span(const Point& apex, Points targets) {
    rays_.clear();
    rays_.reserve(targets.size());
    pointed_ = true;
    line_size_ = 0;
    const Insertion insertion{apex, targets, rays_};
    for (std::size_t i = 0; i < targets.size() && pointed_; ++i) {
        if (targets[i] == apex) continue;
        pointed_ = insertion.insert(static_cast<Index>(i));
        if (pointed_) continue;
        line_[line_size_++] = static_cast<Index>(i);
        if (rays_.size() <= 3) {
            for (const Index ray : rays_)
                line_[line_size_++] = ray;
        } else {
            for (const std::size_t ray : insertion.line_with(targets[i]))
                line_[line_size_++] = rays_[ray];
        }
    }
}

}  // namespace tightflip::geometry
