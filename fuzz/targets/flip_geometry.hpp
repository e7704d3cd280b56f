/// \file
/// The target flip_geometry: a start with points and a script, under every claim about curvatures
/// and criteria.
#pragma once

#include "script_input.hpp"
#include <tightflip/geometry/surface.hpp>

namespace tightflip::fuzz {

inline constexpr std::size_t most_geometry_flips = 8;
inline constexpr std::uint32_t most_coordinate = 4;
/// No kind has more vertices with `most_spare_vertices` to spare.
inline constexpr std::size_t most_geometry_vertices = 32;

/// The start, how the points lie, their seed, three bytes a vertex; then two bytes a flip.
inline constexpr Layout geometry_layout{.head = script_layout.head + 2 + 3 * most_geometry_vertices,
                                        .record = 2,
                                        .most_records = most_geometry_flips};

struct GeometryCase {
    geometry::Surface start;
    properties::FlipScript script;
};

/// The case that an input says (fuzz/README.md gives the layout).
[[nodiscard]] GeometryCase decode_geometry_case(Input input);

/// The first claim that does not hold, in words; empty where all do.
[[nodiscard]] std::string geometry_objection(const GeometryCase& geometry_case);

}  // namespace tightflip::fuzz
