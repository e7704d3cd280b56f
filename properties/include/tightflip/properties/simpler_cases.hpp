/// \file
/// What to try in place of a failing case to make it small, whatever library does the trying.
#pragma once

#include <tightflip/properties/flip_case.hpp>
#include <tightflip/properties/surface_case.hpp>

#include <vector>

namespace tightflip::properties {

/// Simpler cases, those that are much simpler first: an earlier kind; less genus, fewer vertices, a
/// smaller seed; a script without a block of its flips, then without one of them; a lower edge.
/// Each is less in one of these and the same in the others, so there is no endless descent.
[[nodiscard]] std::vector<FlipCase> simpler_cases(const FlipCase& flip_case);

/// The same with points; then points that are simpler, as `simpler_points` says.
[[nodiscard]] std::vector<SurfaceCase> simpler_cases(const SurfaceCase& surface_case);

}  // namespace tightflip::properties
