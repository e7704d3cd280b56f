/// \file
/// A flip case with a point at each vertex: a start, where its vertices are, and a script.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/properties/flip_case.hpp>
#include <tightflip/properties/point_kinds.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace tightflip::properties {

/// Any finite values make a valid case.
struct SurfaceCase {
    FlipCase flips;
    const PointKind* point_kind = point_kinds().data();  ///< never null
    std::uint64_t point_seed = 0;
    /// Where there are any, these and not the kind's: as many as needed, missing ones at the
    /// origin. Shrinking puts simpler points here.
    std::vector<geometry::Point> points{};

    /// The start, before the script.
    [[nodiscard]] geometry::Surface start() const;
    [[nodiscard]] FlipScript script() const { return flips.script(); }
};

/// One line: the flip case's, and the points' kind and seed or, where they are given, all of them.
[[nodiscard]] std::string describe(const SurfaceCase& surface_case);

}  // namespace tightflip::properties
