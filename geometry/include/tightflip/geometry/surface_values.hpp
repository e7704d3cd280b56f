/// \file
/// What is measured at each vertex and each edge, as arrays and as tables for other programs.
///
/// Tables are text with one row a vertex or edge, in the order of their numbers. Numbers are the
/// shortest that read back the same, whatever the locale; a length beyond the range of a double is
/// `inf`. A stream that fails is for the caller to see.
#pragma once

#include <tightflip/geometry/curvature.hpp>
#include <tightflip/geometry/quadrilateral.hpp>

#include <iosfwd>
#include <vector>

namespace tightflip::geometry {

/// The curvatures of every vertex, in the order of labels. O(n log d) for degrees up to d.
/// Precondition, here and below: the table is that of a triangulation with as many vertices as
/// there are points.
[[nodiscard]] std::vector<VertexCurvature> vertex_curvatures(const SurfaceView& surface);

struct EdgeValues {
    double length = 0;          ///< infinite where it exceeds the range of a double
    double exterior_angle = 0;  ///< radians; see curvature.hpp
    EdgeShape shape = EdgeShape::flat;
    QuadrilateralType quadrilateral = QuadrilateralType::none;

    /// H(e).
    [[nodiscard]] double mean_curvature() const noexcept { return exterior_angle / 2; }
};

/// Of one edge; constant time.
[[nodiscard]] EdgeValues edge_values(const SurfaceView& surface, Edge e);

/// CSV with the header
/// `vertex,degree,x,y,z,theta,omega,omega_positive,omega_negative,omega_absolute,type`.
void write_vertices_csv(std::ostream& out, const SurfaceView& surface);

/// CSV with the header
/// `edge,origin,target,length,exterior_angle,mean_curvature,shape,quadrilateral`; the two ends are
/// those of halfedge 2e.
void write_edges_csv(std::ostream& out, const SurfaceView& surface);

/// ASCII PLY of points, faces, and at each vertex the properties `theta`, `omega`,
/// `omega_positive`, `omega_negative`, `omega_absolute` (double) and `vertex_type` (uchar, in the
/// order of VertexType); at each face also `glued_sides` (see mesh_writer.hpp), so that this file
/// is read back as the same surface.
void write_ply_with_values(std::ostream& out, const SurfaceView& surface);

}  // namespace tightflip::geometry
