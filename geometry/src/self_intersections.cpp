#include "box_tree.hpp"
#include "star_pairs.hpp"
#include "surface_face.hpp"
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/kernel/flip.hpp>

#include <tuple>

namespace tightflip::geometry {
namespace {

Box box_of(const Triangle& triangle) {
    Box box(triangle[0]);
    return box.extend(triangle[1]).extend(triangle[2]);
}

bool is_name_of_face(kernel::HalfedgeTable table, Halfedge h) {
    return name_of_face(table, h) == h;
}

bool is_collapsed(const SurfaceFace& face) {
    const auto& [a, b, c] = face.triangle;
    return are_collinear(a, b, c);
}

std::int64_t count_collapsed(const SurfaceView& surface) {
    std::int64_t count = 0;
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        const Halfedge h{id};
        if (!is_name_of_face(surface.table, h)) continue;
        count += is_collapsed(SurfaceFace::at(surface, h)) ? 1 : 0;
    }
    return count;
}

/// Shows each pair of faces that meets beyond what it shares and has a common vertex once, at the
/// smallest one, until `is_enough`.
template <class IsEnough>
bool any_local_pair(const SurfaceView& surface, const IsEnough& is_enough) {
    StarPairs star;
    for (const Halfedge h : halfedge_of_each_vertex(surface)) {
        const Vertex apex = at(surface.table, h).origin;
        star.read(surface, h);
        const bool was_enough = star.any([&](Halfedge f, Halfedge g) {
            const SurfaceFace first = SurfaceFace::at(surface, f);
            const SurfaceFace second = SurfaceFace::at(surface, g);
            const CommonCorners common = common_corners(first, second);
            return apex == common.smallest() && meet_beyond_shared(first, second, common) &&
                   is_enough(f, g);
        });
        if (was_enough) return true;
    }
    return false;
}

/// Likewise for the pairs without a common vertex.
template <class IsEnough>
bool any_global_pair(const SurfaceView& surface, const IsEnough& is_enough) {
    BoxTree tree;
    tree.items().reserve(surface.table.size() / 3);
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        if (!is_name_of_face(surface.table, Halfedge{id})) continue;
        const SurfaceFace face = SurfaceFace::at(surface, Halfedge{id});
        const auto& [a, b, c] = face.corners;
        tree.items().push_back({box_of(face.triangle), {a.id, b.id, c.id}, id});
    }
    tree.build(surface.points);
    return tree.any_pair([&](Index f, Index g) {
        return triangles_meet(SurfaceFace::at(surface, Halfedge{f}).triangle,
                              SurfaceFace::at(surface, Halfedge{g}).triangle) &&
               is_enough(Halfedge{f}, Halfedge{g});
    });
}

/// Keeps the first so many of a stream of pairs in any order, in memory for twice as many.
class FirstPairs {
public:
    explicit FirstPairs(std::size_t kept) : kept_(kept) {}

    void add(const FacePair& pair) {
        pairs_.push_back(pair);
        if (pairs_.size() / 2 > kept_) cut();
    }
    [[nodiscard]] std::vector<FacePair> take() {
        cut();
        return std::move(pairs_);
    }

private:
    void cut() {
        std::ranges::sort(pairs_, {},
                          [](const FacePair& pair) { return std::tuple(pair.first, pair.second); });
        if (pairs_.size() > kept_) pairs_.resize(kept_);
    }

    std::size_t kept_;
    std::vector<FacePair> pairs_;
};

/// Whether a made-up face meets a face of the surface beyond what they share.
bool meets(const SurfaceFace& made_up, const Box& box, const SurfaceFace& face) {
    return box.intersects(box_of(face.triangle)) &&
           meet_beyond_shared(made_up, face, common_corners(made_up, face));
}

}  // namespace

bool faces_meet(const SurfaceView& surface, Halfedge f, Halfedge g) {
    const SurfaceFace first = SurfaceFace::at(surface, f);
    const SurfaceFace second = SurfaceFace::at(surface, g);
    return meet_beyond_shared(first, second, common_corners(first, second));
}

SelfIntersections find_self_intersections(const SurfaceView& surface, std::size_t kept,
                                          std::int64_t most_counted) {
    SelfIntersections result;
    FirstPairs first_pairs(kept);
    const auto add = [&](Halfedge f, Halfedge g, bool is_local) {
        if (result.local_count + result.global_count >= most_counted) return true;
        ++(is_local ? result.local_count : result.global_count);
        const auto [first, second] =
            std::minmax({name_of_face(surface.table, f), name_of_face(surface.table, g)});
        first_pairs.add({first, second, is_local});
        return false;
    };
    result.is_complete = !any_local_pair(surface, [&](Halfedge f, Halfedge g) {
        return add(f, g, true);
    }) && !any_global_pair(surface, [&](Halfedge f, Halfedge g) { return add(f, g, false); });
    result.collapsed_count = count_collapsed(surface);
    result.pairs = first_pairs.take();
    return result;
}

bool is_embedded(const SurfaceView& surface) {
    const auto first = [](Halfedge, Halfedge) { return true; };
    return count_collapsed(surface) == 0 && !any_local_pair(surface, first) &&
           !any_global_pair(surface, first);
}

bool flip_keeps_embedded(const SurfaceView& surface, Edge e) {
    if (!kernel::can_flip(surface.table, e)) return false;
    const auto q = kernel::Quadrilateral::around(surface.table, e);
    const auto origin = [&](Halfedge h) { return at(surface.table, h).origin; };
    const Vertex a = origin(q.h);
    const Vertex b = origin(q.t);
    const Vertex c = origin(q.h2);
    const Vertex d = origin(q.t2);
    const SurfaceFace dca = SurfaceFace::of(surface, {d, c, a}, {e, edge_of(q.h2), edge_of(q.t1)});
    const SurfaceFace cdb = SurfaceFace::of(surface, {c, d, b}, {e, edge_of(q.t2), edge_of(q.h1)});
    const Box box_a = box_of(dca.triangle);
    const Box box_b = box_of(cdb.triangle);
    if (is_collapsed(dca) || is_collapsed(cdb) || meets(dca, box_a, cdb)) return false;
    const Halfedge old_first = name_of_face(surface.table, q.h);
    const Halfedge old_second = name_of_face(surface.table, q.t);
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        const Halfedge h{id};
        if (!is_name_of_face(surface.table, h) || h == old_first || h == old_second) continue;
        const SurfaceFace face = SurfaceFace::at(surface, h);
        if (meets(dca, box_a, face) || meets(cdb, box_b, face)) return false;
    }
    return true;
}

}  // namespace tightflip::geometry
