/// \file
/// What a whole surface measures: curvatures, area and volume, and how many vertices and edges are
/// of which kind.
#pragma once

#include <tightflip/geometry/curvature.hpp>

#include <array>

namespace tightflip::geometry {

/// Angles in radians; lengths, areas and volumes in the units of the coordinates, infinite where
/// they exceed the range of a double. Nothing is NaN.
struct SurfaceMeasures {
    double total_curvature = 0;                   ///< sum of omega, 2 pi chi by Gauss and Bonnet
    double total_positive_curvature = 0;          ///< sum of omega+
    double total_absolute_curvature = 0;          ///< Omega_abs, the sum of omega+ and omega-
    double mean_absolute_curvature = 0;           ///< H_abs, the sum of |H(e)|
    double mean_absolute_curvature_weighted = 0;  ///< the sum of |H(e)| times the length of e
    /// The sum of H(e) times the length of e; folded edges, which have no sign, are left out.
    double integral_mean_curvature = 0;
    double area = 0;
    /// Positive where the faces are counter-clockwise seen from outside; up to roundings of the
    /// cube of the extent, beside which a small volume may have any sign.
    double volume = 0;
    Index euler_characteristic = 0;

    std::array<Index, 4> vertex_types{};  ///< how many vertices are of each VertexType
    std::array<Index, 5> edge_shapes{};   ///< how many edges are of each EdgeShape

    [[nodiscard]] Index count(VertexType type) const {
        return vertex_types.at(static_cast<std::size_t>(type));
    }
    [[nodiscard]] Index count(EdgeShape shape) const {
        return edge_shapes.at(static_cast<std::size_t>(shape));
    }
    /// Omega_abs once more: 2 sum(omega+) - 2 pi chi, which needs no angles of faces.
    [[nodiscard]] double absolute_curvature_by_cones() const noexcept {
        return 2 * total_positive_curvature - 2 * std::numbers::pi * euler_characteristic;
    }
};

/// O(n log d) for n faces and degrees up to d; memory for one halfedge a vertex. Precondition: the
/// table is that of a triangulation with as many vertices as there are points.
[[nodiscard]] SurfaceMeasures measure(const SurfaceView& surface);

}  // namespace tightflip::geometry
