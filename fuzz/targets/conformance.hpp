/// \file
/// The target conformance: one flip script on this library's kernel and on those of CGAL and
/// OpenMesh, each judged in the classes it may be used for.
#pragma once

#include "kernel_script.hpp"

namespace tightflip::fuzz {

/// These kernels, with the codes that docs/conformance.md lists for them and scripts can show.
[[nodiscard]] std::span<const JudgedKernel> judged_kernels();

}  // namespace tightflip::fuzz
