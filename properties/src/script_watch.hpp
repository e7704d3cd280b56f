/// \file
/// A kernel under one script, every property watched.
#pragma once

#include <tightflip/properties/conformance.hpp>

#include <functional>

namespace tightflip::properties {

/// As `run_script`; `tell` hears how far it has come before every answer and flip of the kernel,
/// which may crash then, at every finding, and in the end.
[[nodiscard]] ScriptRun watch_script(const KernelDescription& kernel, const Triangulation& start,
                                     std::span<const Edge> script, bool laws,
                                     std::function<void(const ScriptRun&)> tell);

/// Something that shows where a run has come to.
[[nodiscard]] KernelFinding finding_at(KernelCode code, std::string words, const ScriptRun& run,
                                       const Triangulation& start, std::span<const Edge> script,
                                       bool laws);

}  // namespace tightflip::properties
