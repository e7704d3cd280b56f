/// \file
/// A flip script on mesh kernels: the inputs that say one, and what a kernel breaks on it. This
/// needs no kernel but the one that is judged: the target conformance brings those of CGAL and
/// OpenMesh, `kernel_target` is a target for any that has an adaptor.
#pragma once

#include "target.hpp"
#include <tightflip/properties/conformance.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <span>
#include <vector>

namespace tightflip::fuzz {

/// A kernel, and the codes of docs/conformance.md that are known of it and passed over.
struct JudgedKernel {
    properties::KernelDescription kernel;
    std::vector<properties::KernelCode> known;
};

struct KernelScript {
    properties::FlipCase flips;
    bool laws = false;  ///< every flip is taken back and repeated too
};

/// As fuzz/README.md gives it under conformance.
inline constexpr Layout kernel_script_layout{.head = 6, .record = 2, .most_records = 24};

/// The script that the bytes say.
[[nodiscard]] KernelScript decode_kernel_script(Input input);

/// What one of these kernels breaks that is not known of it. Kernels that cannot start where the
/// script does are not asked.
[[nodiscard]] std::string kernel_objection(const KernelScript& script,
                                           std::span<const JudgedKernel> kernels);

void show_kernel_script(std::ostream& out, Input input);

/// Every kind of start, every script of two flips of the tetrahedron, every small class; each with
/// laws and without.
[[nodiscard]] std::vector<Seed> kernel_script_seeds();

/// A target for a kernel with an adaptor, and the codes that are known of it.
template <properties::MeshKernel K, properties::KernelCode... known>
[[nodiscard]] constexpr Target kernel_target(std::string_view name) {
    return {
        .name = name,
        .description = "a flip script on a mesh kernel: nothing breaks that is not known",
        .layout = kernel_script_layout,
        .objection =
            [](Input input) {
                static const JudgedKernel judged{properties::kernel_description<K>(), {known...}};
                return kernel_objection(decode_kernel_script(input), {&judged, 1});
            },
        .show = show_kernel_script,
        .seeds = kernel_script_seeds};
}

}  // namespace tightflip::fuzz
