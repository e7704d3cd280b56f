#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/curvature.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace tightflip::geometry {

DataConvexity is_convex_data(Points points) {
    const Outcome<ConvexHull> hull = convex_hull(points);
    if (!hull) {
        if (hull.refusal().fault == DataFault::not_finite) {
            throw std::invalid_argument(message(hull.refusal()));
        }
        return {};  // within one plane
    }
    const std::vector<HullPosition>& positions = hull.value().positions;
    const auto inside = std::ranges::find(positions, HullPosition::inside);
    if (inside == positions.end()) return {};
    return {static_cast<Index>(inside - positions.begin())};
}

SurfaceConvexity is_convex_surface(const SurfaceView& surface, FlatEdges flat) {
    const auto is_admitted = [&](EdgeShape shape) {
        return shape == EdgeShape::convex ||
               (shape == EdgeShape::flat && flat == FlatEdges::admitted);
    };
    for (Index e = 0; e < surface.edge_count(); ++e) {
        if (!is_admitted(edge_shape(surface, {e}))) return {.edge = {e}};
    }
    // With these edges a star whose absolute curvature is its deficit goes once round a convex
    // cone, a dihedral angle or a plane.
    StarMeter meter;
    std::vector<bool> is_done(surface.points.size(), false);
    for (Index h = 0; h < 2 * surface.edge_count(); ++h) {
        const Vertex v = at(surface.table, Halfedge{h}).origin;
        if (is_done[static_cast<std::size_t>(v.id)]) continue;
        is_done[static_cast<std::size_t>(v.id)] = true;
        const VertexType type = meter.measure(surface, {h}).type;
        if (type != VertexType::convex && type != VertexType::flat) return {.vertex = v};
    }
    return {};
}

}  // namespace tightflip::geometry
