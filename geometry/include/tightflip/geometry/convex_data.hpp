/// \file
/// Convex data (Alboul et al., Definition 5.1), and the certificate that a surface is convex.
#pragma once

#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/geometry/surface.hpp>

namespace tightflip::geometry {

/// Yes, or a point that lies inside the convex hull.
struct DataConvexity {
    Index interior_point = -1;

    [[nodiscard]] explicit operator bool() const noexcept { return interior_point < 0; }
};

/// Whether all points lie on the boundary of their convex hull, points on its faces and edges
/// included; exact. Data in one plane are convex: that plane supports them all. Where they are not,
/// the witness is the lowest label inside. Throws std::invalid_argument for a coordinate that is
/// not finite. Cost: that of `convex_hull`.
[[nodiscard]] DataConvexity is_convex_data(Points points);

/// What a convex surface may have.
enum class FlatEdges : std::uint8_t {
    refused,   ///< strictly convex: every edge is
    admitted,  ///< also flat edges that are not folded, as on facets with more than three points
};

/// Yes, or the edge or the vertex at which the surface is not convex.
struct SurfaceConvexity {
    Edge edge{};      ///< concave, folded or degenerate, or flat where that is refused
    Vertex vertex{};  ///< its edges are all as they should be, but the star is no convex cone

    [[nodiscard]] explicit operator bool() const noexcept {
        return !edge.is_valid() && !vertex.is_valid();
    }
};

/// Whether the surface is the boundary of a convex body, once covered, its faces counter-clockwise
/// seen from outside: decided exactly from its edges and stars. A closed connected surface that is
/// locally convex at every vertex bounds a convex body (van Heijenoort 1952), so no two parts far
/// from each other need to be compared, and with all edges convex it is the hull and unique. A star
/// that winds twice, which its edges do not show, is not locally convex. Surfaces with coincident
/// neighbours or faces of no area are not accepted. O(n log d); no tolerance.
[[nodiscard]] SurfaceConvexity is_convex_surface(const SurfaceView& surface,
                                                 FlatEdges flat = FlatEdges::refused);

}  // namespace tightflip::geometry
