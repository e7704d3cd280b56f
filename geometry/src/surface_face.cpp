#include "surface_face.hpp"

namespace tightflip::geometry {

bool meet_beyond_shared(const SurfaceFace& f, const SurfaceFace& g, const CommonCorners& common) {
    if (common.count == 3) return true;
    const bool share_edge = std::ranges::any_of(f.sides, [&](Edge e) { return g.has_side(e); });
    // What is shared is an edge, or the common corners by themselves. Of two corners without an
    // edge between them it is enough to spare one: where their points differ, the faces meet in the
    // segment between them, and beyond either.
    const std::size_t spared = share_edge ? 2 : std::min<std::size_t>(common.count, 1);
    std::array<Point, 2> points;
    for (std::size_t i = 0; i < spared; ++i) {
        const auto corner = std::ranges::find(f.corners, common.vertices.at(i));
        points.at(i) = f.triangle.at(static_cast<std::size_t>(corner - f.corners.begin()));
    }
    return triangles_meet_beyond(f.triangle, g.triangle, std::span(points).first(spared));
}

}  // namespace tightflip::geometry
