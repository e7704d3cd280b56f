/// \file
/// Small surfaces made by hand for the kernel's tests, usable in constant expressions. They are
/// glued here, side by side, so that the tests of the library's own gluer and builder have
/// something independent to stand on.
#pragma once

#include <tightflip/kernel/gluing.hpp>

#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tightflip::kernel::testing {

using FaceList = std::vector<std::array<Index, 3>>;

template <class Items>
[[nodiscard]] constexpr auto& nth(Items& items, Index i) {
    return items[static_cast<std::size_t>(i)];
}

// ---- single sides ----

[[nodiscard]] constexpr Index face_count(const Gluing& gluing) {
    return static_cast<Index>(gluing.faces.size());
}
[[nodiscard]] constexpr Index side_count(const Gluing& gluing) {
    return 3 * face_count(gluing);
}
[[nodiscard]] constexpr SideGluing& side(Gluing& gluing, Index s) {
    return nth(nth(gluing.faces, s / 3).sides, s % 3);
}
[[nodiscard]] constexpr SideGluing side(const Gluing& gluing, Index s) {
    return nth(nth(gluing.faces, s / 3).sides, s % 3);
}
[[nodiscard]] constexpr Index start_of(const Gluing& gluing, Index s) {
    return nth(nth(gluing.faces, s / 3).corners, s % 3);
}
[[nodiscard]] constexpr Index end_of(const Gluing& gluing, Index s) {
    return nth(nth(gluing.faces, s / 3).corners, (s + 1) % 3);
}

/// Glues two sides that join the same two vertices, with an honest coherence bit.
constexpr void join(Gluing& gluing, Index s, Index t) {
    const bool reversed = start_of(gluing, s) == start_of(gluing, t);
    side(gluing, s) = reversed ? SideGluing::reversed(t) : SideGluing::coherent(t);
    side(gluing, t) = reversed ? SideGluing::reversed(s) : SideGluing::coherent(s);
}

/// The same gluing with what it claims about the direction of one side inverted.
constexpr void invert_bit(Gluing& gluing, Index s) {
    const SideGluing old = side(gluing, s);
    side(gluing, s) =
        old.is_reversed() ? SideGluing::coherent(old.side()) : SideGluing::reversed(old.side());
}

// ---- whole gluings ----

[[nodiscard]] constexpr Gluing unglued(Index vertex_count, const FaceList& faces) {
    Gluing gluing{.vertex_count = vertex_count, .faces = {}};
    for (const auto& corners : faces)
        gluing.faces.push_back({.corners = corners, .sides = {}});
    return gluing;
}

/// Glues the sides of a list in which at most two join the same two vertices; quadratic time.
[[nodiscard]] constexpr Gluing glued(Index vertex_count, const FaceList& faces) {
    Gluing gluing = unglued(vertex_count, faces);
    for (Index s = 0; s < side_count(gluing); ++s) {
        for (Index t = s + 1; t < side_count(gluing); ++t) {
            const bool same = start_of(gluing, s) == start_of(gluing, t) &&
                              end_of(gluing, s) == end_of(gluing, t);
            const bool opposite = start_of(gluing, s) == end_of(gluing, t) &&
                                  end_of(gluing, s) == start_of(gluing, t);
            if (!same && !opposite) continue;
            if (side(gluing, s).is_glued() || side(gluing, t).is_glued()) {
                throw std::logic_error("the face list is ambiguous");
            }
            join(gluing, s, t);
        }
    }
    return gluing;
}

/// Every vertex v becomes labels[v].
[[nodiscard]] constexpr Gluing relabelled(Gluing gluing, const std::vector<Index>& labels,
                                          Index vertex_count) {
    gluing.vertex_count = vertex_count;
    for (GluedFace& face : gluing.faces) {
        for (Index& corner : face.corners)
            corner = nth(labels, corner);
    }
    return gluing;
}

/// Both gluings as one, their labels untouched: equal labels become one vertex.
[[nodiscard]] constexpr Gluing beside(Gluing first, const Gluing& second) {
    const Index offset = side_count(first);
    first.vertex_count = std::max(first.vertex_count, second.vertex_count);
    for (GluedFace face : second.faces) {
        for (SideGluing& s : face.sides) {
            if (!s.is_glued()) continue;
            s = s.is_reversed() ? SideGluing::reversed(s.side() + offset)
                                : SideGluing::coherent(s.side() + offset);
        }
        first.faces.push_back(face);
    }
    return first;
}

/// The same surface with one face listed in the other orientation.
[[nodiscard]] constexpr Gluing with_face_turned_over(Gluing gluing, Index face) {
    const auto moved = [face](Index s) { return s / 3 == face ? 3 * face + 2 - s % 3 : s; };
    Gluing turned = gluing;
    std::swap(nth(turned.faces, face).corners[1], nth(turned.faces, face).corners[2]);
    for (Index s = 0; s < side_count(gluing); ++s) {
        const SideGluing old = side(gluing, s);
        if (!old.is_glued()) {
            side(turned, moved(s)) = old;
            continue;
        }
        const bool reversed = old.is_reversed() != ((s / 3 == face) != (old.side() / 3 == face));
        side(turned, moved(s)) = reversed ? SideGluing::reversed(moved(old.side()))
                                          : SideGluing::coherent(moved(old.side()));
    }
    return turned;
}

// ---- spheres ----

[[nodiscard]] constexpr FaceList tetrahedron_faces() {
    return {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
}
[[nodiscard]] constexpr Gluing tetrahedron() {
    return glued(4, tetrahedron_faces());
}

[[nodiscard]] constexpr FaceList octahedron_faces() {
    return {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
}
[[nodiscard]] constexpr Gluing octahedron() {
    return glued(6, octahedron_faces());
}

/// Two triangles glued along all three sides: the smallest surface of the allowed class.
[[nodiscard]] constexpr Gluing two_face_sphere() {
    return glued(3, {{0, 1, 2}, {0, 2, 1}});
}

/// `pages` parallel edges between the poles 0 and 1, a vertex of degree 2 in every digon.
[[nodiscard]] constexpr Gluing book(Index pages) {
    FaceList faces;
    for (Index page = 0; page < pages; ++page) {
        faces.push_back({0, page + 2, 1});
        faces.push_back({1, page + 2, 0});
    }
    Gluing gluing = unglued(pages + 2, faces);
    for (Index page = 0; page < pages; ++page) {
        const Index front = 6 * page;
        join(gluing, front, front + 4);
        join(gluing, front + 1, front + 3);
        join(gluing, front + 2, 6 * ((page + 1) % pages) + 5);
    }
    return gluing;
}

// ---- other closed surfaces ----

/// A grid of columns x rows vertices, two triangles a cell; its top row is sewn to the bottom one,
/// mirrored for the Klein bottle.
[[nodiscard]] constexpr FaceList sewn_grid_faces(Index columns, Index rows, bool mirrored) {
    const auto vertex = [&](Index x, Index y) {
        x %= columns;
        if (y == rows) {
            y = 0;
            if (mirrored) x = (columns - x) % columns;
        }
        return columns * y + x;
    };
    FaceList faces;
    for (Index y = 0; y < rows; ++y) {
        for (Index x = 0; x < columns; ++x) {
            faces.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
            faces.push_back({vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
        }
    }
    return faces;
}
[[nodiscard]] constexpr Gluing torus_grid() {
    return glued(9, sewn_grid_faces(3, 3, false));
}
[[nodiscard]] constexpr Gluing klein_bottle() {
    return glued(16, sewn_grid_faces(4, 4, true));
}

/// The torus with the fewest vertices a simple graph allows (Möbius).
[[nodiscard]] constexpr FaceList seven_vertex_torus_faces() {
    FaceList faces;
    for (Index i = 0; i < 7; ++i) {
        faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
        faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
    }
    return faces;
}
[[nodiscard]] constexpr Gluing seven_vertex_torus() {
    return glued(7, seven_vertex_torus_faces());
}

/// Half an icosahedron.
[[nodiscard]] constexpr Gluing projective_plane() {
    FaceList faces;
    for (Index i = 0; i < 5; ++i) {
        const auto rim = [i](Index k) { return 1 + (i + k) % 5; };
        faces.push_back({0, rim(0), rim(1)});
        faces.push_back({rim(0), rim(1), rim(3)});
    }
    return glued(6, faces);
}

// ---- what is no closed connected surface ----

[[nodiscard]] constexpr Gluing lone_triangle() {
    return unglued(3, {{0, 1, 2}});
}

/// Four triangles about the inner vertex 0.
[[nodiscard]] constexpr Gluing disc() {
    return glued(5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
}

[[nodiscard]] constexpr Gluing moebius_strip() {
    return glued(5, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
}

/// Two tetrahedra that share vertex 3.
[[nodiscard]] constexpr Gluing pinched_tetrahedra() {
    return beside(tetrahedron(), relabelled(tetrahedron(), {3, 4, 5, 6}, 7));
}

/// Two tetrahedra that share the vertices 0 and 1: the edge between them is two edges.
[[nodiscard]] constexpr Gluing tetrahedra_sharing_an_edge() {
    return beside(tetrahedron(), relabelled(tetrahedron(), {0, 1, 4, 5}, 6));
}
[[nodiscard]] constexpr FaceList faces_of_tetrahedra_sharing_an_edge() {
    FaceList faces;
    for (const GluedFace& face : tetrahedra_sharing_an_edge().faces)
        faces.push_back(face.corners);
    return faces;
}

[[nodiscard]] constexpr Gluing disjoint_tetrahedra() {
    return beside(tetrahedron(), relabelled(tetrahedron(), {4, 5, 6, 7}, 8));
}

[[nodiscard]] constexpr Gluing disjoint_two_face_spheres() {
    return beside(two_face_sphere(), relabelled(two_face_sphere(), {3, 4, 5}, 6));
}

/// A tetrahedron whose vertices 0 and 1 are one: its faces 0 and 1 have a loop.
[[nodiscard]] constexpr Gluing looped_tetrahedron() {
    return relabelled(tetrahedron(), {0, 0, 1, 2}, 3);
}

}  // namespace tightflip::kernel::testing
