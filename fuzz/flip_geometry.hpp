/// \file
/// The target flip_geometry: a start with small integer coordinates and a script, under every claim
/// about curvatures and criteria.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/properties/finding.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace tightflip::fuzz {

inline constexpr std::size_t most_geometry_flips = 12;
inline constexpr std::uint32_t most_coordinate = 4;

struct GeometryCase {
    geometry::Surface start;
    properties::FlipScript script;
};

/// The case that the bytes say (fuzz/README.md gives the layout).
[[nodiscard]] GeometryCase decode_geometry_case(std::span<const std::uint8_t> data);

/// The first claim that does not hold, in words; empty where all do.
[[nodiscard]] std::string geometry_objection(const GeometryCase& geometry_case);

}  // namespace tightflip::fuzz
