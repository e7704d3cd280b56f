/// \file
/// Spheres all of whose faces contain one vertex, the hub, and the flips that move about in them.
///
/// On a sphere with V vertices the hub then has degree F = 2 V - 4, and the V - 2 edges that do not
/// end at it join the other V - 1 vertices: they are connected (the hub's link runs through them),
/// hence a plane tree. Every face is (hub, x, y) with one side on the tree, so about a vertex of
/// the tree edges of the tree and spokes (edges to the hub) take turns.
///
/// The tree is walked by its own halfedges. The face of a tree halfedge x -> y is (x, y, hub).
#pragma once

#include "flip_trail.hpp"

#include <algorithm>

namespace tightflip::kernel::hub_form {

/// The side before `h` in its face.
[[nodiscard]] constexpr Halfedge previous(HalfedgeTable table, Halfedge h) noexcept {
    return at(table, at(table, h).next).next;
}
[[nodiscard]] constexpr Vertex target(HalfedgeTable table, Halfedge h) noexcept {
    return at(table, twin(h)).origin;
}
/// The next edge of the tree about the origin of `h`, over the spoke between them.
[[nodiscard]] constexpr Halfedge counter_clockwise(HalfedgeTable table, Halfedge h) noexcept {
    return twin(previous(table, twin(previous(table, h))));
}
[[nodiscard]] constexpr Halfedge clockwise(HalfedgeTable table, Halfedge h) noexcept {
    return at(table, twin(at(table, twin(h)).next)).next;
}

/// Some halfedge that leaves a vertex; linear time.
[[nodiscard]] inline Halfedge leaving(HalfedgeTable table, Vertex v) {
    const auto found = std::ranges::find(table, v, &HalfedgeRecord::origin);
    return {static_cast<Index>(found - table.begin())};
}
/// A halfedge of the tree that leaves a vertex other than the hub. About it, edges of the tree and
/// spokes take turns.
[[nodiscard]] inline Halfedge tree_edge_from(HalfedgeTable table, Vertex v, Vertex hub) {
    const Halfedge h = leaving(table, v);
    return target(table, h) == hub ? twin(previous(table, h)) : h;
}

/// Flips until every face contains the origin of `spoke` (see gather.hpp). A flipped side leaves a
/// new side opposite the hub in the same face, which is looked at next.
inline void gather(FlipTrail& trail, Halfedge spoke) {
    const Vertex hub = at(trail.table(), spoke).origin;
    Halfedge current = spoke;
    do {
        for (;;) {
            const Halfedge side = at(trail.table(), current).next;
            if (at(trail.table(), previous(trail.table(), twin(side))).origin == hub) break;
            trail.flip(edge_of(side));
        }
        current = twin(previous(trail.table(), current));
    } while (current != spoke);
}

/// The slide: of two tree edges p -> u and p -> v, v next to u counter-clockwise, one is drawn
/// along the other and joins u and v after it. Two flips: the spoke between them becomes the edge
/// uv, then the edge that slides becomes a spoke. Both are defined, for u, v and the hub differ.
/// What hangs on the edge that slides goes with it.
struct Fork {
    Halfedge u, v;
};

/// Draws v along u. Returns u -> v; clockwise of it is what was last about u, before u -> p.
inline Halfedge slide_second(FlipTrail& trail, Fork fork) {
    const Halfedge spoke = previous(trail.table(), fork.u);
    trail.flip(edge_of(spoke));
    trail.flip(edge_of(fork.v));
    return twin(spoke);
}
/// Draws u along v. Returns v -> u; counter-clockwise of it is what was first about v, after
/// v -> p.
inline Halfedge slide_first(FlipTrail& trail, Fork fork) {
    const Halfedge spoke = previous(trail.table(), fork.u);
    trail.flip(edge_of(spoke));
    trail.flip(edge_of(fork.u));
    return spoke;
}

/// Slides until every edge of the tree ends at the origin b of `page`: the book of b and the hub.
/// One slide for each edge that does not end there yet; `page` itself stays.
inline void spread(FlipTrail& trail, Halfedge page) {
    Halfedge current = page;
    do {
        const Halfedge back = twin(current);
        for (Halfedge other = counter_clockwise(trail.table(), back); other != back;
             other = counter_clockwise(trail.table(), back)) {
            static_cast<void>(slide_second(trail, {back, other}));
        }
        current = clockwise(trail.table(), current);  // what came to b last stands next
    } while (current != page);
}

}  // namespace tightflip::kernel::hub_form
