/// \file
/// A flip case with a point at each vertex: a start, where its vertices are, and a script.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <cstdint>
#include <string>

namespace tightflip::properties {

/// Any values make a valid case.
struct SurfaceCase {
    FlipCase flips;
    /// 0: uniform in the cube from -1 to 1, so in general position as good as surely. Else integers
    /// of at most this size: few enough for coincident, collinear and coplanar points.
    std::uint32_t grid = 0;
    std::uint64_t point_seed = 0;

    /// The start, before the script.
    [[nodiscard]] geometry::Surface start() const;
    [[nodiscard]] FlipScript script() const { return flips.log().flips; }
};

/// One line: the flip case's, and how the points were drawn.
[[nodiscard]] std::string describe(const SurfaceCase& surface_case);

}  // namespace tightflip::properties
