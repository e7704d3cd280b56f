/// \file
/// The target optimise: a surface with points of any kind, a criterion and a strategy.
#pragma once

#include "target.hpp"
#include <tightflip/geometry/strategy.hpp>
#include <tightflip/properties/surface_case.hpp>

#include <string>
#include <vector>

namespace tightflip::fuzz {

inline constexpr std::size_t most_locked_edges = 8;

struct OptimiseCase {
    properties::SurfaceCase surface;
    std::string criterion;
    geometry::Strategy strategy{};
    geometry::OptimiseOptions options;  ///< its locked edges are those below
    std::vector<kernel::Edge> locked;
};

/// The case that the bytes say: fuzz/README.md gives the layout.
[[nodiscard]] OptimiseCase decode_optimise(Input input);

/// What does not hold of the run: topology, limits, energies, the log, the certificate.
[[nodiscard]] std::string optimise_objection(const OptimiseCase& run);

}  // namespace tightflip::fuzz
