#include "directions.hpp"
#include <tightflip/geometry/curvature.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/kernel/circulation.hpp>

#include <algorithm>
#include <cmath>

namespace tightflip::geometry {
namespace {

constexpr double pi = std::numbers::pi;

/// Whether the shortest way on the sphere of directions from `before` to `after` goes through `x`.
bool lies_between(const Point& apex, const Point& before, const Point& x, const Point& after) {
    // What needs no arithmetic first: equal points are usual among parallel edges.
    if (x == before || x == after) return true;
    if (before == after) return same_direction(apex, before, x);
    if (orientation(apex, before, x, after) != Sign::zero) return false;
    if (same_direction(apex, before, x) || same_direction(apex, x, after)) return true;
    if (are_collinear(apex, before, after)) return false;
    return coplanar_side(apex, before, after, x) == Sign::positive &&
           coplanar_side(apex, after, before, x) == Sign::positive;
}

/// Of the edge's two ends.
const Point& nearer_end(const Hinge& hinge, const Point& x) {
    const auto distance = [&](const Point& end) {
        return (end * 0.5 - x * 0.5).cwiseAbs().maxCoeff();  // halves, lest it overflow
    };
    return distance(hinge.a) <= distance(hinge.b) ? hinge.a : hinge.b;
}

double signed_angle(EdgeShape shape, double angle) {
    switch (shape) {
        case EdgeShape::convex:
            return angle;
        case EdgeShape::concave:
            return -angle;
        case EdgeShape::folded:
            return pi;
        case EdgeShape::flat:
        case EdgeShape::degenerate:
            break;
    }
    return 0;
}

}  // namespace

VertexCurvature StarMeter::measure(const SurfaceView& surface, Halfedge h) {
    read_star(surface, h);
    cone_.span(apex_, rays_);
    VertexCurvature result;
    result.total_angle = total_angle();
    const bool is_tight = star_is_tight();
    if (!cone_.is_pointed()) {
        result.type = is_tight ? VertexType::flat : VertexType::saddle;
        result.negative = is_tight ? 0 : std::max(0.0, -result.deficit());
        return result;
    }
    if (is_tight) {
        result.type = VertexType::convex;
        result.positive = std::max(0.0, result.deficit());
        return result;
    }
    const double circumference = cone_circumference();
    result.type = VertexType::mixed;
    result.positive = std::max(0.0, 2 * pi - circumference);
    result.negative = std::max(0.0, result.total_angle - circumference);
    return result;
}

void StarMeter::read_star(const SurfaceView& surface, Halfedge h) {
    apex_ = surface.origin(h);
    star_.clear();
    directions_.clear();
    distinct_.clear();
    rays_.clear();
    for (const Vertex v : kernel::Neighbours(surface.table, h)) {
        star_.push_back(surface.point(v));
        directions_.push_back(direction(apex_, star_.back()));
        distinct_.push_back(v);
    }
    std::ranges::sort(distinct_);
    distinct_.erase(std::unique(distinct_.begin(), distinct_.end()), distinct_.end());
    for (const Vertex v : distinct_)
        rays_.push_back(surface.point(v));
}

double StarMeter::total_angle() const {
    double sum = 0;
    const Point* before = &directions_.back();
    for (const Point& current : directions_) {
        sum += face_angle(*before, current);
        before = &current;
    }
    return sum;
}

double StarMeter::cone_circumference() const {
    const auto extreme = cone_.extreme_rays();
    if (extreme.empty()) return 0;
    const auto towards = [&](Index ray) {
        return direction(apex_, rays_[static_cast<std::size_t>(ray)]);
    };
    double sum = 0;
    Point before = towards(extreme.back());
    for (const Index ray : extreme) {
        const Point current = towards(ray);
        sum += angle_between(before, current);
        before = current;
    }
    return sum;
}

/// Whether omega- is zero. On the sphere of directions about the vertex the star is a closed path
/// of length theta. In a pointed cone its length is at least the cone's circumference, with
/// equality where the path goes round the cone once. Otherwise it is not within an open hemisphere,
/// and then its length is at least 2 pi, with equality on a great circle and on two halves of great
/// circles with common ends. Without the corners where it goes straight on, such a path keeps three
/// corners or fewer, or four of which two are opposite.
bool StarMeter::star_is_tight() {
    if (std::ranges::find(star_, apex_) != star_.end()) return false;
    leave_out_flat_edges();
    if (cone_.is_pointed()) return path_follows_cone();
    if (path_.size() != 4) return path_.size() < 4;
    return opposite_direction(apex_, path_[0], path_[2]) ||
           opposite_direction(apex_, path_[1], path_[3]);
}

/// Each corner left out leaves the path between its neighbours as it was. What was seen to bend
/// still does after corners behind it are gone, so that only the ends of the list need another
/// pass.
void StarMeter::leave_out_flat_edges() {
    path_ = star_;
    std::size_t size = 0;
    do {
        size = path_.size();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const Point& before = kept > 0 ? path_[kept - 1] : path_.back();
            const Point& after = i + 1 < size ? path_[i + 1] : path_.front();
            const bool is_last = kept == 0 && i + 1 == size;
            if (!is_last && lies_between(apex_, before, path_[i], after)) continue;
            path_[kept++] = path_[i];
        }
        path_.resize(kept);
    } while (path_.size() < size);
}

bool StarMeter::path_follows_cone() const {
    const auto extreme = cone_.extreme_rays();
    const std::size_t n = extreme.size();
    if (path_.size() != n) return false;
    const auto agree = [&](std::size_t corner, std::size_t ray) {
        return same_direction(apex_, path_[corner % n],
                              rays_[static_cast<std::size_t>(extreme[ray % n])]);
    };
    std::size_t start = 0;
    while (start < n && !agree(start, 0))
        ++start;
    if (start == n) return false;
    const auto runs_along = [&](std::size_t step) {
        for (std::size_t i = 1; i < n; ++i) {
            if (!agree(start + i * step, i)) return false;
        }
        return true;
    };
    return runs_along(1) || runs_along(n - 1);
}

double exterior_angle(const Hinge& hinge, EdgeShape shape) {
    if (shape != EdgeShape::convex && shape != EdgeShape::concave) return signed_angle(shape, 0);
    const Point u = direction(hinge.a, hinge.b);
    // From the nearer end, where the angle is not sharp: two long sides would lose the short one.
    const Point p = direction(nearer_end(hinge, hinge.c), hinge.c);
    const Point q = direction(nearer_end(hinge, hinge.d), hinge.d);
    const Point first = u.cross(p);
    const Point second = q.cross(u);
    // The cross product of the two normals is u times the determinant of u, p and q.
    return signed_angle(shape, std::atan2(u.norm() * std::abs(first.dot(q)), first.dot(second)));
}

double length(const SurfaceView& surface, Edge e) {
    const Halfedge h = halfedge_of(e);
    return (surface.target(h) - surface.origin(h)).stableNorm();
}

}  // namespace tightflip::geometry
