/// \file
/// What the paper says of curvatures, criteria and flips of surfaces in space (Alboul et al.,
/// sections 4.1 and 4.2), as callable checks.
///
/// All hold for any points, degenerate ones included, with the library's conventions for these.
/// Signs are compared exactly, measures up to 1e-9 of their size: angles of 1 or of their sums,
/// lengths, areas and volumes of the power of the surface's extent. Not compared are powers of the
/// extent beyond 2^900 and 2^-900, nor what thin faces leave no digits of: changes of cotangents
/// and of angles between normals (docs/properties.md says on which kinds of points).
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tightflip::properties {

/// The claims by their stable codes.
enum class GeometryClaim : std::uint16_t {
    gauss_bonnet = 1001,           ///< the deficits add up to 2 pi chi
    curvature_signs = 1002,        ///< omega+ >= 0, omega- >= 0, absolute >= |omega|
    curvature_sum = 1003,          ///< omega = omega+ - omega-
    vertex_types = 1004,           ///< types say which of omega+ and omega- vanish, and add up
    cones_and_angles = 1005,       ///< Omega_abs = 2 sum(omega+) - 2 pi chi
    least_total_curvature = 1006,  ///< genus 0: Omega_abs >= 4 pi
    local_change = 1007,           ///< a criterion's change is the difference of its values
    sign_of_change = 1008,         ///< criteria with exact signs change 0 exactly where they say so
    exchange_of_shapes = 1009,     ///< a flip makes convex edges concave and concave ones convex
    change_of_volume = 1010,       ///< a flip changes the volume by its tetrahedron
    quadrilaterals_and_edges = 1011  ///< CC and RC have convex edges, CR and RR concave ones
};

[[nodiscard]] std::string_view name(GeometryClaim claim);

struct GeometryFinding {
    GeometryClaim claim{};
    std::size_t step = 0;  ///< flips of the script attempted before it showed
    std::string detail;    ///< where, and the numbers that do not agree
};

/// One line: the step, the code, the claim and the detail.
[[nodiscard]] std::string describe(const GeometryFinding& finding);

/// The claims about curvatures (1001 to 1006) of one surface. O(n log d) time.
[[nodiscard]] std::optional<GeometryFinding> curvature_claims_hold(
    const geometry::SurfaceView& surface);

/// All claims along a script: curvatures after every flip, and at every flip the change of every
/// criterion for closed surfaces, whose caches live through the whole script. Linear time a flip.
[[nodiscard]] std::optional<GeometryFinding> geometry_claims_hold(
    geometry::Surface surface, std::span<const kernel::Edge> script);

/// The same, several times as fast on long scripts: of every flip what is local (the edge, the
/// volume, the four stars), but the whole surface's curvatures, and values of criteria, at the ends
/// alone. The changes announced are held to these values: in sum, the last flip's by itself.
[[nodiscard]] std::optional<GeometryFinding> geometry_claims_hold_at_ends(
    geometry::Surface surface, std::span<const kernel::Edge> script);

}  // namespace tightflip::properties
