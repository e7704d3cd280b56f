/// \file
/// A surface as a viewer sees it, in straight and bowed lines, before anything is painted.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>
#include <vector>

namespace tightflip::geometry {

/// The points turned so that x runs to the right, y up and z towards the viewer, and scaled by a
/// power of two so that the largest extent along an axis is 2 to 4, about the origin; all of them
/// the origin where all coincide. Angles in degrees, as in DrawingOptions.
[[nodiscard]] std::vector<Point> project(Points points, double azimuth, double elevation);

/// A triangle in these coordinates, whole or part of a face.
struct Piece {
    std::vector<Point> corners;  ///< three or, once cut, more
    Index face = 0;              ///< the smallest halfedge of the face
    bool is_front = true;        ///< the outside of the face is seen
};

/// The edges of a surface in its projection: straight, but parallel ones are bowed aside.
class EdgeLines {
public:
    explicit EdgeLines(const SurfaceView& projected);

    /// An edge from the origin of its even halfedge to the target: two points, or more on a bow, in
    /// the depth of the nearer of its faces. The list is replaced.
    void trace(Edge e, std::vector<Point>& line) const;
    /// The outline of the face of `h`, without repetition and in its plane. The list is replaced.
    void outline(Halfedge h, std::vector<Point>& corners) const;
    [[nodiscard]] bool is_bowed(Edge e) const noexcept {
        return bows_[static_cast<std::size_t>(e.id)] != 0;
    }

private:
    [[nodiscard]] Eigen::Vector2d bow_of(Halfedge h) const;
    [[nodiscard]] Eigen::Vector2d slope(Halfedge h) const;

    SurfaceView projected_;
    int inner_points_;
    // How far an edge's middle is moved to the left, by the length of its chord, seen from its
    // smaller end.
    std::vector<double> bows_;
};

/// All faces as triangles, those with bowed sides cut into several. Faces seen from the side are
/// among them.
[[nodiscard]] std::vector<Piece> face_pieces(const SurfaceView& projected, const EdgeLines& lines);

/// Twice the area of a triangle as it is seen, positive where its corners are counter-clockwise.
[[nodiscard]] inline double seen_area(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace tightflip::geometry
