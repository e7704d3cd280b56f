/// \file
/// Damage done to a kernel on purpose: whether its validator sees it.
#pragma once

#include <tightflip/properties/conformance.hpp>

namespace tightflip::properties {

/// A kind of damage that a kernel may let itself be done.
struct Damage {
    KernelCode code;  ///< where the validator passes it
    std::string_view words;
    /// What the tables are to become, at a side; unchanged where the class forbids nothing such.
    SideTables (*planned)(const SideTables& tables, Index side, KernelClass allowed);
    bool from_gluing = false;  ///< the kernel is made so, and not changed afterwards
};
/// All kinds. Some differ only in how they are done, and have one code.
[[nodiscard]] std::span<const Damage> damages() noexcept;

/// Plants one kind of damage at side after side of a start until the validator passes one or fails
/// itself: one of a kind is enough, and the next might hang too. Findings go to the report. True
/// where the kernel hung.
bool plant_damage(const KernelDescription& kernel, const Damage& damage, const std::string& name,
                  const Triangulation& start, const ConformanceOptions& options,
                  KernelReport& report);

}  // namespace tightflip::properties
