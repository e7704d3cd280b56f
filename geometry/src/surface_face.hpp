/// \file
/// A face of a surface by itself: its labels, sides and points.
#pragma once

#include <tightflip/geometry/triangle_intersection.hpp>
#include <tightflip/kernel/circulation.hpp>

#include <algorithm>

namespace tightflip::geometry {

/// Side i goes from corner i to the next. Faces may be made up that the table does not have: those
/// after a flip.
struct SurfaceFace {
    std::array<Vertex, 3> corners;
    std::array<Edge, 3> sides;
    Triangle triangle;

    [[nodiscard]] static SurfaceFace at(const SurfaceView& surface, Halfedge h) {
        const Halfedge h1 = kernel::at(surface.table, h).next;
        const Halfedge h2 = kernel::at(surface.table, h1).next;
        return of(surface,
                  {kernel::at(surface.table, h).origin, kernel::at(surface.table, h1).origin,
                   kernel::at(surface.table, h2).origin},
                  {edge_of(h), edge_of(h1), edge_of(h2)});
    }
    [[nodiscard]] static SurfaceFace of(const SurfaceView& surface,
                                        const std::array<Vertex, 3>& corners,
                                        const std::array<Edge, 3>& sides) {
        return {corners,
                sides,
                {surface.point(corners[0]), surface.point(corners[1]), surface.point(corners[2])}};
    }
    [[nodiscard]] bool has_side(Edge e) const { return std::ranges::find(sides, e) != sides.end(); }
};

/// The smallest halfedge of the face of `h`, which names it.
[[nodiscard]] inline Halfedge name_of_face(kernel::HalfedgeTable table, Halfedge h) {
    const Halfedge h1 = at(table, h).next;
    return std::min({h, h1, at(table, h1).next});
}

/// The vertices that two faces have in common.
struct CommonCorners {
    std::array<Vertex, 3> vertices{};
    std::size_t count = 0;

    /// Precondition: there is one.
    [[nodiscard]] Vertex smallest() const {
        return *std::min_element(vertices.begin(), vertices.begin() + count);
    }
};

[[nodiscard]] inline CommonCorners common_corners(const SurfaceFace& f, const SurfaceFace& g) {
    CommonCorners common;
    for (const Vertex v : f.corners) {
        if (std::ranges::find(g.corners, v) != g.corners.end()) {
            common.vertices.at(common.count++) = v;
        }
    }
    return common;
}

/// Whether two different faces meet beyond what they share (see self_intersections.hpp), given
/// their common corners.
[[nodiscard]] bool meet_beyond_shared(const SurfaceFace& f, const SurfaceFace& g,
                                      const CommonCorners& common);

}  // namespace tightflip::geometry
