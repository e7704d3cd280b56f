#include "star_pairs.hpp"
#include "surface_face.hpp"
#include <tightflip/geometry/pinch_points.hpp>
#include <tightflip/geometry/self_intersections.hpp>

namespace tightflip::geometry {
namespace {

bool is_pinched(const SurfaceView& surface, Halfedge h, StarPairs& star) {
    star.read(surface, h);
    return star.any([&](Halfedge f, Halfedge g) { return faces_meet(surface, f, g); });
}

}  // namespace

bool is_pinch_point(const SurfaceView& surface, Halfedge h) {
    StarPairs star;
    return is_pinched(surface, h, star);
}

std::vector<Vertex> pinch_points(const SurfaceView& surface) {
    std::vector<Vertex> result;
    StarPairs star;
    for (const Halfedge h : halfedge_of_each_vertex(surface)) {
        if (is_pinched(surface, h, star)) result.push_back(at(surface.table, h).origin);
    }
    return result;
}

}  // namespace tightflip::geometry
