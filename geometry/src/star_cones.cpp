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
        update(h);
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

void StarCones::update(Halfedge h) {
    const Point& apex = surface_.origin(h);
    read_star(h, {});
    for (const Halfedge spoke : halfedges_)
        ray(spoke) = {};
    cone_.span(apex, targets_);
    Star& star = stars_[static_cast<std::size_t>(kernel::at(surface_.table, h).origin.id)];
    star = {};
    star.is_pointed = cone_.is_pointed();
    const auto halfedge = [&](Index target) {
        return halfedges_[static_cast<std::size_t>(target)];
    };
    if (!star.is_pointed) {
        std::ranges::transform(cone_.line(), star.line.begin(), halfedge);
        return;
    }
    const auto extreme = cone_.extreme_rays();
    star.ray_count = static_cast<Index>(extreme.size());
    double circumference = 0;
    for (std::size_t i = 0; i < extreme.size(); ++i) {
        const Halfedge current = halfedge(extreme[i]);
        const Halfedge after = halfedge(extreme[i + 1 < extreme.size() ? i + 1 : 0]);
        ray(current).next = after;
        ray(after).previous = current;
        ray(current).angle = angle_at(apex, surface_.target(current), surface_.target(after));
        circumference += ray(current).angle;
        star.first = current;
    }
    star.positive = deficit(circumference);
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
double StarCones::change_without(Halfedge h) {
    const Star& star = this->star(h);
    if (!star.is_pointed) {
        if (std::ranges::find(star.line, h) == star.line.end()) return 0;
        return from_scratch(h, h, nullptr);
    }
    const Ray& gone = ray(h);
    if (!gone.next.is_valid()) return 0;
    if (star.ray_count < 3) return from_scratch(h, h, nullptr);
    const Point& apex = surface_.origin(h);
    const Point& last = surface_.target(gone.next);
    const Point* current = &surface_.target(gone.previous);
    double chain = 0;
    while (current != &last) {
        const Point* next = &last;
        for (const Halfedge spoke : kernel::Star(surface_.table, h)) {
            if (ray(spoke).next.is_valid()) continue;
            const Point& x = surface_.target(spoke);
            if (&x == current) continue;
            if (orientation(apex, *current, *next, x) == Sign::positive) next = &x;
        }
        chain += angle_at(apex, *current, *next);
        current = next;
    }
    return ray(gone.previous).angle + gone.angle - chain;
}

double StarCones::change_with(Halfedge h, const Point& target) {
    const Star& star = this->star(h);
    const Point& apex = surface_.origin(h);
    if (!star.is_pointed || target == apex) return 0;
    if (star.ray_count < 3) return from_scratch(h, {}, &target);
    const auto sees = [&](Halfedge side) {
        return orientation(apex, surface_.target(side), surface_.target(ray(side).next), target);
    };
    // A side seen from strictly beyond, if there is one.
    Halfedge seen = star.first;
    while (sees(seen) != Sign::positive) {
        seen = ray(seen).next;
        if (seen == star.first) return 0;
    }
    // Those seen, and those in whose planes the new ray lies, are consecutive.
    Halfedge first = seen;
    Halfedge last = ray(seen).next;
    double hidden = ray(seen).angle;
    while (last != first && sees(last) != Sign::negative) {
        hidden += ray(last).angle;
        last = ray(last).next;
    }
    while (first != last && sees(ray(first).previous) != Sign::negative) {
        first = ray(first).previous;
        hidden += ray(first).angle;
    }
    if (first == last) return -star.positive;  // all are: the cone contains a line
    return hidden - angle_at(apex, surface_.target(first), target) -
           angle_at(apex, target, surface_.target(last));
}

}  // namespace tightflip::geometry
