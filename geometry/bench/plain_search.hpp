/// \file
/// Local search as one would write it down: a queue of edges, angles in doubles, nothing kept.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/kernel/simple_flip.hpp>

#include <cmath>
#include <deque>

#include <Eigen/Geometry>

namespace tightflip::geometry::bench {

/// Lowers the sum of lengths times angles between normals by flips that keep the graph simple;
/// returns how many.
inline std::size_t search_plainly(Surface& surface) {
    Triangulation& t = surface.triangulation();
    const auto weight = [](const Point& a, const Point& b, const Point& c, const Point& d) {
        const Point u = b - a;
        const Point m = u.cross(c - a);
        const Point n = (d - a).cross(u);
        return u.norm() * std::atan2(m.cross(n).norm(), m.dot(n));
    };
    const auto apex = [&](Halfedge h) -> const Point& { return surface.point(t.opposite(h)); };
    const auto change = [&](Edge e) {
        const Halfedge h = halfedge_of(e);
        const Halfedge g = twin(h);
        const Point& a = surface.point(t.origin(h));
        const Point& b = surface.point(t.target(h));
        const Point& c = apex(h);
        const Point& d = apex(g);
        const Point& bc = apex(twin(t.next(h)));
        const Point& ca = apex(twin(t.previous(h)));
        const Point& ad = apex(twin(t.next(g)));
        const Point& db = apex(twin(t.previous(g)));
        const double before = weight(a, b, c, d) + weight(b, c, a, bc) + weight(c, a, b, ca) +
                              weight(a, d, b, ad) + weight(d, b, a, db);
        const double after = weight(d, c, a, b) + weight(b, c, d, bc) + weight(c, a, d, ca) +
                             weight(a, d, c, ad) + weight(d, b, c, db);
        return after - before;
    };
    const auto count = static_cast<std::size_t>(t.edge_count());
    std::deque<Edge> queue;
    std::vector<char> waits(count, 0);
    const auto push = [&](Halfedge h) {
        char& is_waiting = waits[static_cast<std::size_t>(edge_of(h).id)];
        if (is_waiting == 0) queue.push_back(edge_of(h));
        is_waiting = 1;
    };
    for (Index e = 0; e < t.edge_count(); ++e)
        push(halfedge_of(Edge{e}));
    std::size_t flips = 0;
    while (!queue.empty()) {
        const Edge e = queue.front();
        queue.pop_front();
        waits[static_cast<std::size_t>(e.id)] = 0;
        if (!can_flip_simply(t.table(), e) || change(e) > -1e-10) continue;
        t.flip(e);
        ++flips;
        const Halfedge h = halfedge_of(e);
        for (const Halfedge side :
             {t.next(h), t.previous(h), t.next(twin(h)), t.previous(twin(h))}) {
            for (const Halfedge beside : t.face_sides(twin(side)))
                push(beside);
        }
    }
    return flips;
}

}  // namespace tightflip::geometry::bench
