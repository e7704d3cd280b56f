/// \file
/// A script run where a crash or an endless loop of the kernel does no harm.
#pragma once

#include <tightflip/properties/conformance.hpp>

namespace tightflip::properties {

/// As `run_script`; in a child process of its own where the options say so, and then a crash or a
/// run out of time is a finding beside those made before it.
[[nodiscard]] ScriptRun run_isolated(const KernelDescription& kernel, const Triangulation& start,
                                     std::span<const Edge> script, bool laws,
                                     const ConformanceOptions& options);

}  // namespace tightflip::properties
