#include "star_cones.hpp"

#include "directions.hpp"
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/kernel/circulation.hpp>

#include <algorithm>
#include <numbers>

namespace tightflip::geometry {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// omega+ of a pointed cone of that circumference. One of a full turn is flat up to roundings.
double deficit(double circumference) {
    return std::max(0.0, full_turn - circumference);
}

Halfedge previous(kernel::HalfedgeTable table, Halfedge h) {
    return kernel::at(table, kernel::at(table, h).next).next;
}

double angle_at(const Point& apex, const Point& p, const Point& q) {
    return angle_between(direction(apex, p), direction(apex, q));
}

}  // namespace

StarCones::StarCones(const SurfaceView& surface)
    : surface_(surface), stars_(surface.points.size()), rays_(surface.table.size()) {
    std::vector<Halfedge> outgoing(stars_.size());
    for (Index h = 0; h < static_cast<Index>(rays_.size()); ++h) {
        outgoing[static_cast<std::size_t>(kernel::at(surface.table, Halfedge{h}).origin.id)] =
            Halfedge{h};
    }
    for (const Halfedge h : outgoing)
        update(h, {surface.target(h), false});
    affected_.clear();
}

void StarCones::read_star(Halfedge h, Halfedge left_out) {
    targets_.clear();
    halfedges_.clear();
    for (const Halfedge spoke : kernel::Star(surface_.table, h)) {
        if (spoke == left_out) continue;
        targets_.push_back(surface_.target(spoke));
        halfedges_.push_back(spoke);
    }
}

double StarCones::positive_curvature_of_cone(const Point& apex) const {
    if (!cone_.is_pointed()) return 0;
    const auto extreme = cone_.extreme_rays();
    double circumference = 0;
    for (std::size_t i = 0; i < extreme.size(); ++i) {
        const Index after = extreme[i + 1 < extreme.size() ? i + 1 : 0];
        circumference += angle_at(apex, targets_[static_cast<std::size_t>(extreme[i])],
                                  targets_[static_cast<std::size_t>(after)]);
    }
    return deficit(circumference);
}

/// Looks at the star of the origin of `h` again: it is new, or has lost or gained one edge.
void StarCones::update(Halfedge h, const Change& change) {
    const Point& apex = surface_.origin(h);
    Star& star = stars_[static_cast<std::size_t>(kernel::at(surface_.table, h).origin.id)];
    read_star(h, {});
    before_.clear();
    for (const Halfedge spoke : halfedges_) {
        before_.push_back(ray(spoke));
        ray(spoke).next = {};
    }
    cone_.span(apex, targets_);
    const Star was = star;
    star = {};
    star.is_pointed = cone_.is_pointed();
    const auto halfedge = [&](Index target) {
        return halfedges_[static_cast<std::size_t>(target)];
    };
    if (star.is_pointed) {
        const auto extreme = cone_.extreme_rays();
        star.ray_count = static_cast<Index>(extreme.size());
        double circumference = 0;
        for (std::size_t i = 0; i < extreme.size(); ++i) {
            const Halfedge current = halfedge(extreme[i]);
            const Halfedge after = halfedge(extreme[i + 1 < extreme.size() ? i + 1 : 0]);
            ray(current).next = after;
            ray(after).previous = current;
            if (before_[static_cast<std::size_t>(extreme[i])].next != after) {
                ray(current).angle =
                    angle_at(apex, surface_.target(current), surface_.target(after));
            }
            circumference += ray(current).angle;
            star.first = current;
        }
        star.positive = deficit(circumference);
    } else {
        std::ranges::transform(cone_.line(), star.line.begin(), halfedge);
        forget_line(star);
    }
    for (std::size_t i = 0; i < halfedges_.size(); ++i) {
        const Halfedge spoke = halfedges_[i];
        const Ray& before = before_[i];
        const Ray& now = ray(spoke);
        const bool is_same = before.next == now.next && before.previous == now.previous;
        const bool bears = before.is_extreme() || now.is_extreme();
        if (bears && (!is_same || star.ray_count < 3 || has_behind(spoke, apex, change.target))) {
            forget_without(spoke);
        }
        const Halfedge side = kernel::at(surface_.table, spoke).next;
        // What was within a cone is within a larger one. (Of a flat one zero does not say within.)
        const bool stays = change.is_gain && was.ray_count >= 3 && ray(side).change_across == 0;
        if (!stays && (was.is_pointed || star.is_pointed)) forget_across(side);
    }
}

double StarCones::from_scratch(Halfedge h, Halfedge left_out, const Point* added) {
    const Point& apex = surface_.origin(h);
    read_star(h, left_out);
    if (added != nullptr) targets_.push_back(*added);
    cone_.span(apex, targets_);
    return positive_curvature_of_cone(apex) - star(h).positive;
}

/// Where an extreme ray goes, its two sides give way to a chain over the rays behind it: those
/// beyond the plane of its neighbours, wrapped from the one to the other.
double StarCones::find_change_without(Halfedge h) {
    const Star& star = this->star(h);
    if (!star.is_pointed) {
        if (std::ranges::find(star.line, h) == star.line.end()) return 0;
        return from_scratch(h, h, nullptr);
    }
    const Ray& gone = ray(h);
    if (!gone.is_extreme()) return 0;
    if (star.ray_count < 3) return from_scratch(h, h, nullptr);
    const Point& apex = surface_.origin(h);
    const Point& last = surface_.target(gone.next);
    const Point* current = &surface_.target(gone.previous);
    double chain = 0;
    while (current != &last) {
        const Point* next = &last;
        for (const Halfedge spoke : kernel::Star(surface_.table, h)) {
            if (ray(spoke).is_extreme()) continue;
            const Point& x = surface_.target(spoke);
            if (&x == current) continue;
            if (orientation(apex, *current, *next, x) == Sign::positive) next = &x;
        }
        chain += angle_at(apex, *current, *next);
        current = next;
    }
    return ray(gone.previous).angle + gone.angle - chain;
}

double StarCones::find_change_across(Halfedge side) {
    const Halfedge h = previous(surface_.table, side);
    const Star& star = this->star(h);
    const Point& apex = surface_.origin(h);
    const Point& target = surface_.opposite(twin(side));
    if (!star.is_pointed || target == apex) return 0;
    if (star.ray_count < 3) return from_scratch(h, {}, &target);
    const Halfedge seen = side_seen_from(star, apex, target);
    if (!seen.is_valid()) return 0;
    // The sides seen, and those in whose planes the new ray lies, are consecutive.
    Halfedge first = seen;
    Halfedge last = ray(seen).next;
    double hidden = ray(seen).angle;
    while (last != first && beyond(last, apex, target) != Sign::negative) {
        hidden += ray(last).angle;
        last = ray(last).next;
    }
    while (first != last && beyond(ray(first).previous, apex, target) != Sign::negative) {
        first = ray(first).previous;
        hidden += ray(first).angle;
    }
    if (first == last) return -star.positive;  // all are: the cone contains a line
    return hidden - angle_at(apex, surface_.target(first), target) -
           angle_at(apex, target, surface_.target(last));
}

Sign StarCones::beyond(Halfedge side, const Point& apex, const Point& x) const {
    return orientation(apex, surface_.target(side), surface_.target(ray(side).next), x);
}

Halfedge StarCones::side_seen_from(const Star& star, const Point& apex, const Point& x) const {
    Halfedge side = star.first;
    const Point* current = &surface_.target(side);
    do {
        const Halfedge next = ray(side).next;
        const Point* after = &surface_.target(next);
        if (orientation(apex, *current, *after, x) == Sign::positive) return side;
        side = next;
        current = after;
    } while (side != star.first);
    return {};
}

/// Whether the cone at the origin of `at` may be another one without the edge that left it.
bool StarCones::may_lose(Halfedge at, Edge lost) const {
    const Star& star = this->star(at);
    const Vertex v = kernel::at(surface_.table, at).origin;
    const auto may_lose = [&](Halfedge h) {
        if (!star.is_pointed) return std::ranges::find(star.line, h) != star.line.end();
        if (star.ray_count < 3) return true;
        // Which of the two halfedges left this vertex, another one in the ring knows.
        return ray(h).is_extreme() && kernel::at(surface_.table, ray(h).next).origin == v;
    };
    return may_lose(halfedge_of(lost)) || may_lose(twin(halfedge_of(lost)));
}

/// Whether the cone at the origin of `gained` may be another one with this edge.
bool StarCones::may_gain(Halfedge gained) const {
    const Star& star = this->star(gained);
    const Point& apex = surface_.origin(gained);
    const Point& target = surface_.target(gained);
    if (!star.is_pointed || target == apex) return false;
    return star.ray_count < 3 || side_seen_from(star, apex, target).is_valid();
}

void StarCones::flipped(Edge e) {
    affected_.clear();
    affected_.push_back(e);
    const auto q = kernel::Quadrilateral::around(surface_.table, e);
    for (const Halfedge side : {q.h1, q.h2, q.t1, q.t2}) {
        forget_across(side);
        forget_across(twin(side));
    }
    const std::array corners{q.h, q.t, q.h2, q.t2};
    const std::array is_another{may_gain(q.h), may_gain(q.t), may_lose(q.h2, e), may_lose(q.t2, e)};
    ray(q.h) = {};
    ray(q.t) = {};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // The other end of the edge gained or lost is the corner on the other side.
        const Point& target = surface_.origin(corners[i ^ 1]);
        forget_line(star(corners[i]));
        if (is_another[i]) {
            update(corners[i], {target, i < 2});
        } else {
            forget_in_front_of(corners[i], target);
        }
    }
}

void StarCones::forget_across(Halfedge h) {
    ray(h).change_across = unknown;
    affected_.push_back(edge_of(h));
}

void StarCones::forget_without(Halfedge h) {
    ray(h).change_without = unknown;
    affected_.push_back(edge_of(h));
}

void StarCones::forget_line(const Star& star) {
    for (const Halfedge spoke : star.line) {
        if (spoke.is_valid()) forget_without(spoke);
    }
}

/// Of the rays that bear the cone, those with a change in what is behind them.
void StarCones::forget_in_front_of(Halfedge h, const Point& target) {
    const Star& star = this->star(h);
    if (!star.first.is_valid()) return;
    const Point& apex = surface_.origin(h);
    Halfedge spoke = star.first;
    do {
        if (star.ray_count < 3 || has_behind(spoke, apex, target)) forget_without(spoke);
        spoke = ray(spoke).next;
    } while (spoke != star.first);
}

/// Whether a ray is beyond the plane of an extreme ray's neighbours, so that it comes into sight
/// where that one goes.
bool StarCones::has_behind(Halfedge extreme, const Point& apex, const Point& target) const {
    return orientation(apex, surface_.target(ray(extreme).previous),
                       surface_.target(ray(extreme).next), target) == Sign::positive;
}

}  // namespace tightflip::geometry
