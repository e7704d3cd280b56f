/// \file
/// The target conformance: one flip script on this library's kernel and on those of CGAL and
/// OpenMesh, each judged in the classes it may be used for.
#pragma once

#include "target.hpp"
#include <tightflip/properties/conformance.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <span>
#include <vector>

namespace tightflip::fuzz {

/// A kernel, and the codes that docs/conformance.md lists for it and scripts can show.
struct JudgedKernel {
    properties::KernelDescription kernel;
    std::vector<properties::KernelCode> known;
};
[[nodiscard]] std::span<const JudgedKernel> judged_kernels();

struct ConformanceCase {
    properties::FlipCase flips;
    bool laws = false;  ///< every flip is taken back and repeated too
};

/// The case that the bytes say: fuzz/README.md gives the layout.
[[nodiscard]] ConformanceCase decode_conformance(Input input);

/// What one of these kernels breaks that is not known of it.
[[nodiscard]] std::string conformance_objection(const ConformanceCase& script,
                                                std::span<const JudgedKernel> kernels);

}  // namespace tightflip::fuzz
