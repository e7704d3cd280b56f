/// \file
/// A kernel under one script, every property watched.
#pragma once

#include <tightflip/properties/conformance.hpp>

#include <functional>

namespace tightflip::properties {

/// As `run_script`; `tell` hears of findings as they are made, for the kernel may crash later.
[[nodiscard]] ScriptRun watch_script(const KernelDescription& kernel, const Triangulation& start,
                                     std::span<const Edge> script, bool laws,
                                     std::function<void(const KernelFinding&)> tell);

}  // namespace tightflip::properties
