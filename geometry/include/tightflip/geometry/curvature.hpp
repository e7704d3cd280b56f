/// \file
/// The curvatures of a triangulated surface at its vertices and edges (Alboul et al., section
/// 4.1.1).
///
/// Types and shapes are exact. Measures are floating point, in radians, with an error of a few
/// roundings for each face; none is NaN for finite coordinates of any size.
#pragma once

#include <tightflip/geometry/convex_cone.hpp>
#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/geometry/surface.hpp>

#include <cstdint>
#include <numbers>
#include <vector>

namespace tightflip::geometry {

/// What the surface does at a vertex. The four types exclude each other and leave nothing out: the
/// paper's three, its second kind of mixed vertices with deficit zero admitted, and flat.
enum class VertexType : std::uint8_t {
    convex,  ///< positive > 0, negative = 0: the star is the boundary of a convex cone
    saddle,  ///< positive = 0, negative > 0: no supporting plane touches the star in a point
    mixed,   ///< both > 0
    flat,    ///< both 0: the star lies in a plane or two half-planes and turns once
};

struct VertexCurvature {
    double total_angle = 0;  ///< theta, the sum of the angles of the faces
    double positive = 0;     ///< omega+, 2 pi less the circumference of the cone
    double negative = 0;     ///< omega-, theta less that circumference
    VertexType type = VertexType::flat;

    /// omega, the angle deficit 2 pi - theta.
    [[nodiscard]] double deficit() const noexcept { return 2 * std::numbers::pi - total_angle; }
    /// The paper's omega with a hat.
    [[nodiscard]] double absolute() const noexcept { return positive + negative; }
};

/// Measures stars, one after the other, in memory of its own.
///
/// The convex cone of a star is that of its edges; where it contains a line there is no supporting
/// plane, or it touches along a line, and omega+ is 0. A neighbour at the very point of the vertex
/// adds no ray. The angles of a face two of whose corners coincide are taken as pi/2, pi/2 and 0,
/// and as three times pi/3 where all do, so that each face has angles of pi together; a vertex with
/// such a neighbour is mixed or saddle.
class StarMeter {
public:
    /// The curvatures at the origin of `h`. O(d log d) for degree d; allocates only at a degree
    /// higher than ever before.
    [[nodiscard]] VertexCurvature measure(const SurfaceView& surface, Halfedge h);

private:
    void read_star(const SurfaceView& surface, Halfedge h);
    [[nodiscard]] double total_angle() const;
    [[nodiscard]] double cone_circumference() const;
    [[nodiscard]] bool star_is_tight();
    void leave_out_flat_edges();
    [[nodiscard]] bool path_follows_cone() const;

    Point apex_;
    std::vector<Point> star_;        // the neighbours in order about the vertex
    std::vector<Point> directions_;  // to each of them
    std::vector<Vertex> distinct_;   // the neighbours without repetition
    std::vector<Point> rays_;        // the points of these
    std::vector<Point> path_;        // the neighbours where the star bends
    ConvexCone cone_;
};

/// As below, for an edge whose shape is known to be `shape`.
[[nodiscard]] double exterior_angle(const Hinge& hinge, EdgeShape shape);

/// The angle between the normals of the two faces at an edge: positive at a convex edge, negative
/// at a concave one, 0 at a flat one, pi at a folded one (which has no sign); 0 at a degenerate one
/// (which has no normals). The sign and the last three are exact.
[[nodiscard]] inline double exterior_angle(const Hinge& hinge) {
    return exterior_angle(hinge, edge_shape(hinge));
}
[[nodiscard]] inline double exterior_angle(const SurfaceView& surface, Edge e) {
    return exterior_angle(Hinge::at(surface, e));
}

/// H(e), half the exterior angle.
[[nodiscard]] inline double mean_curvature(const SurfaceView& surface, Edge e) {
    return exterior_angle(surface, e) / 2;
}

/// The length of an edge; infinite where it exceeds the range of a double.
[[nodiscard]] double length(const SurfaceView& surface, Edge e);

}  // namespace tightflip::geometry
