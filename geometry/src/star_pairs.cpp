#include "star_pairs.hpp"

#include "directions.hpp"
#include <tightflip/kernel/circulation.hpp>

#include <cmath>

namespace tightflip::geometry {
namespace {

/// A unit vector, but for rounding; zero where the points coincide.
Point unit_direction(const Point& apex, const Point& target) {
    return direction(apex, target).stableNormalized();
}

/// A box about the shortest arc between two directions, where one may be missing; all directions
/// where both are.
Box box_of_arc(const Point& u, const Point& v) {
    constexpr double rounding = 1e-12;
    const bool has_u = !u.isZero(0);
    const bool has_v = !v.isZero(0);
    if (!has_u && !has_v) return {Point::Constant(-2), Point::Constant(2)};
    Box box(has_u ? u : v);
    box.extend(has_v ? v : u);
    // The arc is at no point farther from its chord than in the middle.
    const double half_chord = std::min(1.0, box.diagonal().norm() / 2);
    const double height = 1 - std::sqrt(1 - half_chord * half_chord);
    const Point margin = Point::Constant(height + rounding);
    return {box.min() - margin, box.max() + margin};
}

}  // namespace

std::vector<Halfedge> halfedge_of_each_vertex(const SurfaceView& surface) {
    std::vector<Halfedge> outgoing(surface.points.size());
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        const Halfedge h{id};
        outgoing[static_cast<std::size_t>(at(surface.table, h).origin.id)] = h;
    }
    return outgoing;
}

void StarPairs::read(const SurfaceView& surface, Halfedge h) {
    const Point& apex = surface.origin(h);
    auto& items = tree_.items();
    items.clear();
    Point before = unit_direction(apex, surface.target(h));
    for (const Halfedge side : kernel::Star(surface.table, h)) {
        const Point after = unit_direction(apex, surface.opposite(side));
        items.push_back({box_of_arc(before, after),
                         {BoxTree::no_tag, BoxTree::no_tag, BoxTree::no_tag},
                         side.id});
        before = after;
    }
    tree_.build();
}

}  // namespace tightflip::geometry
