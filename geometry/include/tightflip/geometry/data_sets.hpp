/// \file
/// Named data, each as a surface: points and a natural start triangulation.
///
/// Labels are 0 .. V - 1, faces counter-clockwise seen from outside. Random points are the same on
/// every machine; curved shapes use the sine, cosine and exponential of the standard library, which
/// may differ in the last bit. A size outside a set's range throws std::invalid_argument, which
/// names the range.
#pragma once

#include <tightflip/geometry/functional_surface.hpp>
#include <tightflip/geometry/surface.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace tightflip::geometry {

namespace data_sets {

/// Schoenhardt's prism (Figure 2): a triangular prism with its top turned by 30 degrees and the
/// reflex diagonals in its sides. Six vertices, three concave edges, embedded, and not one
/// tetrahedron of its vertices lies inside it.
[[nodiscard]] Surface schoenhardt_prism();

/// The twisted double prism (Figure 14): three k-gons above each other, each turned against the one
/// below by 0.45 pi / k, the middle one wider, with the reflex diagonals in the sides.
/// The data are convex and the surface is not: 2 k edges are concave. V = 3 k, k >= 3; in general
/// position for k = 3.
[[nodiscard]] Surface twisted_prism(Index k);

/// The skewed cylinder (Figure 4): two parallel k-gons, the upper one moved sideways by more than
/// its width. Convex; least area is not here. V = 2 k, k >= 3.
[[nodiscard]] Surface skewed_cylinder(Index k);

/// The hull of evenly spread points on an ellipsoid with the half axes 3, 2 and 1. V >= 4.
[[nodiscard]] Surface ellipsoid(Index vertices);

/// The hull of random points on the unit sphere, or on that ellipsoid: convex data in general
/// position. V >= 4.
[[nodiscard]] Surface random_sphere(Index vertices, std::uint64_t seed);
[[nodiscard]] Surface random_ellipsoid(Index vertices, std::uint64_t seed);

/// Evenly spread points on a sphere with waves, radially triangulated: star-shaped and not convex.
/// The seed chooses the waves. V >= 20.
[[nodiscard]] Surface bumpy_sphere(Index vertices, std::uint64_t seed);

/// A torus with waves round its tube of 12 vertices; genus 1. V = 12 m, m >= 3.
[[nodiscard]] Surface bumpy_torus(Index vertices, std::uint64_t seed);

/// A scalp in horizontal slices of 16 vertices, closed below and above (for Figure 8), stitched by
/// `surface_from_cross_sections`. V = 16 m, m >= 2.
[[nodiscard]] Surface head_cap(Index vertices);

/// The points of the cube's surface in a grid of k^3 cells: convex data of which all but eight are
/// within facets and edges. V = 6 k^2 + 2, k >= 1.
[[nodiscard]] Surface cube_grid(Index vertices);

/// Random points over the unit square with the elevation of Franke's function (Franke, Math. Comp.
/// 38 (1982)), or random ones in 0 .. 1; Delaunay triangulated, the marked vertex last. V >= 4 with
/// it.
[[nodiscard]] FunctionalSurface franke(Index vertices, std::uint64_t seed);
[[nodiscard]] FunctionalSurface random_heights(Index vertices, std::uint64_t seed);

}  // namespace data_sets

struct DataRequest {
    Index vertices = 0;  ///< all of the surface, a marked one included
    std::uint64_t seed = 0;
};

/// A set by name, for programs that offer them all.
struct DataSet {
    std::string_view name;
    std::string_view description;
    Index default_vertices;
    bool has_marked_vertex;  ///< the last vertex closes a functional surface and is no datum
    /// The surface; throws std::invalid_argument naming the range for sizes it cannot have.
    Surface (*make)(const DataRequest& request);
};

/// All sets, in a fixed order.
[[nodiscard]] std::span<const DataSet> all_data_sets() noexcept;
/// The set of that name, or nullptr.
[[nodiscard]] const DataSet* find_data_set(std::string_view name) noexcept;

}  // namespace tightflip::geometry
