// clang-format off
/// \file
/// Named, seeded kinds of coordinates, from general position to what predicates and roundings fear.
///
/// | name           | points |
/// |----------------|--------|
/// | general        | uniform in the cube from -1 to 1: in general position as good as surely |
/// | grid           | integers from -k to k, k = 1 to 4 |
/// | coincident     | at most four places, at times one |
/// | collinear      | on one line, exactly |
/// | near-collinear | beside a line by an ulp or so |
/// | coplanar       | in one plane, exactly, on a small grid in it |
/// | near-coplanar  | beside a plane by an ulp or so |
/// | near-grid      | beside a grid by an ulp or so: nearly everything |
/// | sphere         | on the unit sphere, rounded |
/// | cospherical    | lattice points on a sphere of radius 3 or 9, exactly; many on common circles |
/// | far            | general points 2^20 to 2^50 from the origin: differences have few digits |
/// | needles        | general points stretched 2^10 to 2^60 times in one direction |
/// | huge           | general points times 2^500 (3e150) to 2^1023: products overflow |
/// | tiny           | general points times 2^-500 (3e-151) to 2^-1070: products vanish, or digits do |
/// | subnormal      | a grid in multiples of the least double |
/// | scales         | each point with a magnitude of its own, 2^-30 to 2^30 |
/// | wild           | each coordinate with a magnitude of its own, 2^-1074 to 2^1023, or zero |
///
/// The claims of geometry_claims.hpp hold of all; docs/properties.md says which of them cannot ask
/// everything of a kind.
// clang-format on
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tightflip::properties {

using kernel::Index;

struct PointKind {
    std::string_view name;
    std::string_view description;  ///< one line
    /// So many points, all finite; the same on every machine (on the sphere: with correctly rounded
    /// square roots). Linear time.
    std::vector<geometry::Point> (*make)(Index count, std::uint64_t seed);
};

/// All kinds, in a fixed order (byte strings of the fuzz targets refer to it; only append).
[[nodiscard]] std::span<const PointKind> point_kinds() noexcept;
/// The kind of that name, or nullptr.
[[nodiscard]] const PointKind* find_point_kind(std::string_view name) noexcept;

}  // namespace tightflip::properties
