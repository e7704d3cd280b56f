/// \file
/// Points in the order in which a half-plane that turns about an axis meets them.
#pragma once

#include "perturbed_points.hpp"

#include <optional>
#include <vector>

namespace tightflip::geometry {

/// The axis touches the hull in one of its corners, the hub, and nowhere else. Seen from the hub
/// the others lie in a plane, and are met there in the order in which a straight line sweeps over
/// it.
struct AxisSweep {
    Vertex hub;
    std::vector<Vertex> order;  ///< all but the hub
};

/// A sweep of perturbed points that are not coincident; the hub is a corner of the hull of the
/// points as they are. O(n log n) exact comparisons. Empty where no axis was found: the hull's
/// corners are closer to flat than coordinates can tell.
[[nodiscard]] std::optional<AxisSweep> axis_sweep(Points points, const PerturbedPoints& perturbed,
                                                  std::uint64_t seed);

}  // namespace tightflip::geometry
