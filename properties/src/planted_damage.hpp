/// \file
/// Damage done to a kernel on purpose: whether its validator sees it.
#pragma once

#include <tightflip/properties/conformance.hpp>

namespace tightflip::properties {

/// A kind of damage that a kernel may let itself be done.
struct Damage {
    PlantedFault fault;
    KernelCode code;  ///< where the validator passes it
    std::string_view words;
    /// What to put at a side instead of what is right.
    Index (*wrong)(const SideTables& tables, Index side);
};
/// All kinds.
[[nodiscard]] std::span<const Damage> damages() noexcept;

/// Plants one kind of damage at side after side of a start until the validator passes one or fails
/// itself: one of a kind is enough, and the next might hang too. Findings go to the report. True
/// where the validator hung.
bool plant_damage(const KernelDescription& kernel, const Damage& damage, const std::string& name,
                  const Triangulation& start, const ConformanceOptions& options,
                  KernelReport& report);

}  // namespace tightflip::properties
