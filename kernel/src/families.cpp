#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <array>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace tightflip::kernel::families {
namespace {

using FaceList = std::vector<std::array<Index, 3>>;

void require(bool holds, const char* family, const char* range) {
    if (!holds) throw std::invalid_argument(std::string(family) + " needs " + range);
}

void require_faces(std::int64_t faces, const char* family) {
    require(faces <= max_faces, family, "fewer vertices: the tables address at most 2^30 sides");
}

Gluing glue(const FaceList& faces, Index vertices) {
    return glue_faces(faces, vertices).gluing;
}

Triangulation from_faces(const FaceList& faces, Index vertices) {
    return build(glue(faces, vertices)).value();
}

/// Fan triangles over the corners first .. first + k - 1 of a k-gon.
void add_fan(FaceList& faces, Index first, Index k) {
    for (Index i = 1; i + 1 < k; ++i)
        faces.push_back({first, first + i, first + i + 1});
}

/// The k-gons 0 .. k - 1 and k .. 2k - 1, and between them 2k triangles: quadrilateral i has the
/// corners i, k + i, k + i + 1, i + 1 (mod k) and the diagonal from i where `rising(i)`, else to
/// it.
template <class Rising>
FaceList banded_polygons(Index k, Rising&& rising) {
    FaceList faces;
    for (Index i = 0; i < k; ++i) {
        const Index j = (i + 1) % k;
        if (rising(i)) {
            faces.insert(faces.end(), {{i, k + i, k + j}, {i, k + j, j}});
        } else {
            faces.insert(faces.end(), {{i, k + i, j}, {k + i, k + j, j}});
        }
    }
    add_fan(faces, 0, k);
    add_fan(faces, k, k);
    return faces;
}

Triangulation subdivided(const Triangulation& surface) {
    FaceList faces;
    const auto middle = [&](Halfedge h) { return surface.vertex_count() + edge_of(h).id; };
    for (const Halfedge h : surface.faces()) {
        const std::array<Index, 3> middles{middle(h), middle(surface.next(h)),
                                           middle(surface.previous(h))};
        faces.push_back(middles);
        std::size_t i = 0;
        for (const Vertex corner : surface.face_corners(h)) {
            faces.push_back({corner.id, middles[i], middles[(i + 2) % 3]});
            ++i;
        }
    }
    return from_faces(faces, surface.vertex_count() + surface.edge_count());
}

Triangulation subdivided(Triangulation surface, int level, const char* family) {
    require(level >= 0 && level <= 12, family, "0 <= level <= 12");
    for (; level > 0; --level)
        surface = subdivided(surface);
    return surface;
}

FaceList grid_faces(Index m, Index n) {
    FaceList faces;
    const auto at = [&](Index i, Index j) { return (i % m) * n + j % n; };
    for (Index i = 0; i < m; ++i) {
        for (Index j = 0; j < n; ++j) {
            faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return faces;
}

/// The torus of three vertices and six faces: the plane's triangular grid, in which corner (i, j)
/// carries the label i + j mod 3, folded by all translations that keep the labels. Faces 2j and
/// 2j + 1 are the lower and upper triangle of the square at (0, j).
Gluing three_vertex_torus() {
    Gluing gluing{.vertex_count = 3, .faces = std::vector<GluedFace>(6)};
    const auto lower = [](Index j) { return 2 * (j % 3); };
    const auto upper = [](Index j) { return 2 * (j % 3) + 1; };
    for (Index j = 0; j < 3; ++j) {
        gluing.faces[static_cast<std::size_t>(lower(j))] = {
            .corners = {j, (j + 1) % 3, (j + 2) % 3},
            .sides = {SideGluing::coherent(side_of(upper(j + 2), 1)),
                      SideGluing::coherent(side_of(upper(j + 1), 2)),
                      SideGluing::coherent(side_of(upper(j), 0))}};
        gluing.faces[static_cast<std::size_t>(upper(j))] = {
            .corners = {j, (j + 2) % 3, (j + 1) % 3},
            .sides = {SideGluing::coherent(side_of(lower(j), 2)),
                      SideGluing::coherent(side_of(lower(j + 1), 0)),
                      SideGluing::coherent(side_of(lower(j + 2), 1))}};
    }
    return gluing;
}

/// The connected sum: the last face of each is taken away and the two holes are sewn together, so
/// that corners 0, 1, 2 of the first meet corners 0, 2, 1 of the second.
Gluing connected_sum(Gluing a, const Gluing& b) {
    const GluedFace hole_a = a.faces.back();
    const GluedFace hole_b = b.faces.back();
    a.faces.pop_back();
    const auto kept_a = static_cast<Index>(a.faces.size());
    const auto kept_b = static_cast<Index>(b.faces.size()) - 1;

    std::vector<Index> label(static_cast<std::size_t>(b.vertex_count), -1);
    for (std::size_t i = 0; i < 3; ++i) {
        label[static_cast<std::size_t>(hole_b.corners[i])] = hole_a.corners[(3 - i) % 3];
    }
    for (Index& l : label) {
        if (l < 0) l = a.vertex_count++;
    }
    for (Index f = 0; f < kept_b; ++f) {
        GluedFace face = b.faces[static_cast<std::size_t>(f)];
        for (Index& corner : face.corners)
            corner = label[static_cast<std::size_t>(corner)];
        for (SideGluing& side : face.sides) {
            side = SideGluing::coherent(side.side() + side_of(kept_a, 0));
        }
        a.faces.push_back(face);
    }
    const auto sew = [&](Index s, Index t) {
        a.faces[static_cast<std::size_t>(s / 3)].sides[static_cast<std::size_t>(s % 3)] =
            SideGluing::coherent(t);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Index s = hole_a.sides[i].side();
        const Index t = hole_b.sides[2 - i].side() + side_of(kept_a, 0);
        sew(s, t);
        sew(t, s);
    }
    return a;
}

Gluing sum_of_tori(Index genus, const Gluing& torus) {
    Gluing sum = torus;
    for (Index g = 1; g < genus; ++g)
        sum = connected_sum(std::move(sum), torus);
    return sum;
}

/// Puts vertices into faces chosen uniformly at random until there are `vertices`, then renames all
/// of them at random.
Triangulation stacked_up(const Triangulation& start, Index vertices, RandomStream random) {
    std::vector<HalfedgeRecord> records(start.table().begin(), start.table().end());
    records.reserve(records.size() + 6 * static_cast<std::size_t>(vertices - start.vertex_count()));
    const auto record = [&](Halfedge h) -> HalfedgeRecord& {
        return records[static_cast<std::size_t>(h.id)];
    };
    for (Index v = start.vertex_count(); v < vertices; ++v) {
        const auto count = static_cast<Index>(records.size());
        Halfedge side{static_cast<Index>(random.below(static_cast<std::uint32_t>(count)))};
        records.resize(records.size() + 6);
        for (Index i = 0; i < 3; ++i) {  // the side, then out of its end to v and back to its start
            const Halfedge to_v{count + 2 * ((i + 1) % 3)};
            const Halfedge from_v{count + 2 * i + 1};
            const Halfedge following = record(side).next;
            record(to_v) = {from_v, record(following).origin};
            record(from_v) = {side, {v}};
            record(side).next = to_v;
            side = following;
        }
    }
    std::vector<Index> names(static_cast<std::size_t>(vertices));
    std::iota(names.begin(), names.end(), 0);
    random.shuffle(std::span(names));
    for (HalfedgeRecord& r : records)
        r.origin = {names[static_cast<std::size_t>(r.origin.id)]};
    return build(std::move(records), vertices).value();
}

}  // namespace

Triangulation tetrahedron() {
    return from_faces({{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}, 4);
}

Triangulation book(Index vertices) {
    require(vertices >= 3, "a book", "at least 3 vertices");
    require_faces(2 * std::int64_t{vertices} - 4, "a book");
    const Index pages = vertices - 2;
    Gluing gluing{.vertex_count = vertices,
                  .faces = std::vector<GluedFace>(2 * static_cast<std::size_t>(pages))};
    for (Index page = 0; page < pages; ++page) {
        const Index front = 2 * page;
        const Index back = front + 1;
        const Index back_of_previous = (front + 2 * pages - 1) % (2 * pages);
        const Index front_of_following = (back + 1) % (2 * pages);
        gluing.faces[static_cast<std::size_t>(front)] = {
            .corners = {0, 1, 2 + page},
            .sides = {SideGluing::coherent(side_of(back_of_previous, 0)),
                      SideGluing::coherent(side_of(back, 2)),
                      SideGluing::coherent(side_of(back, 1))}};
        gluing.faces[static_cast<std::size_t>(back)] = {
            .corners = {1, 0, 2 + page},
            .sides = {SideGluing::coherent(side_of(front_of_following, 0)),
                      SideGluing::coherent(side_of(front, 2)),
                      SideGluing::coherent(side_of(front, 1))}};
    }
    return build(gluing).value();
}

Triangulation double_wheel(Index vertices) {
    require(vertices >= 5, "a double wheel", "at least 5 vertices");
    require_faces(2 * std::int64_t{vertices} - 4, "a double wheel");
    const Index rim = vertices - 2;
    FaceList faces;
    for (Index i = 0; i < rim; ++i) {
        const Index j = (i + 1) % rim;
        faces.push_back({0, 2 + i, 2 + j});
        faces.push_back({1, 2 + j, 2 + i});
    }
    return from_faces(faces, vertices);
}

Triangulation stacked(Index vertices, std::uint64_t seed) {
    require(vertices >= 4, "a stacked sphere", "at least 4 vertices");
    require_faces(2 * std::int64_t{vertices} - 4, "a stacked sphere");
    return stacked_up(tetrahedron(), vertices, RandomStream(seed));
}

Triangulation prism(Index k) {
    require(k >= 3 && k <= max_faces / 4, "a prism", "k >= 3 (and not beyond the tables)");
    return from_faces(banded_polygons(k, [](Index i) { return i % 2 == 0; }), 2 * k);
}

Triangulation antiprism(Index k) {
    require(k >= 3 && k <= max_faces / 4, "an antiprism", "k >= 3 (and not beyond the tables)");
    return from_faces(banded_polygons(k, [](Index) { return false; }), 2 * k);
}

Triangulation octasphere(int level) {
    return subdivided(double_wheel(6), level, "an octasphere");
}

Triangulation icosphere(int level) {
    FaceList faces;
    for (Index i = 0; i < 5; ++i) {  // apex 0, upper ring 1 .. 5, lower ring 6 .. 10, apex 11
        const Index j = (i + 1) % 5;
        faces.insert(
            faces.end(),
            {{0, 1 + i, 1 + j}, {1 + i, 6 + i, 1 + j}, {6 + i, 6 + j, 1 + j}, {11, 6 + j, 6 + i}});
    }
    return subdivided(from_faces(faces, 12), level, "an icosphere");
}

Triangulation torus_grid(Index m, Index n) {
    require(m >= 3 && n >= 3, "a torus grid", "at least 3 by 3 vertices");
    require_faces(2 * std::int64_t{m} * n, "a torus grid");
    return from_faces(grid_faces(m, n), m * n);
}

Triangulation surface_of_genus(Index genus, Index vertices, std::uint64_t seed) {
    require(genus >= 0, "a surface", "genus 0 or more");
    if (genus == 0) return stacked(vertices, seed);
    require(vertices >= 3, "a surface of positive genus", "at least 3 vertices");
    require_faces(2 * std::int64_t{vertices} + 4 * std::int64_t{genus}, "a surface of this genus");
    const bool room_for_simple = vertices >= 6 * std::int64_t{genus} + 3;
    const Gluing torus = room_for_simple ? glue(grid_faces(3, 3), 9) : three_vertex_torus();
    return stacked_up(build(sum_of_tori(genus, torus)).value(), vertices, RandomStream(seed));
}

Triangulation random(Index vertices, Index genus, std::uint64_t seed) {
    Triangulation surface = surface_of_genus(genus, vertices, seed);
    RandomStream stream(mix(seed));
    const auto edges = static_cast<std::uint32_t>(surface.edge_count());
    for (std::int64_t k = 0; k < 20 * std::int64_t{edges}; ++k) {
        static_cast<void>(surface.flip({static_cast<Index>(stream.below(edges))}));
    }
    return surface;
}

}  // namespace tightflip::kernel::families
