#include "conformance.hpp"

#include "kernels.hpp"
#include "targets.hpp"

namespace tightflip::fuzz {

std::span<const JudgedKernel> judged_kernels() {
    using enum properties::KernelCode;
    using namespace properties;
    static const std::vector<JudgedKernel> kernels{
        {our_kernel(), {}},
        {boost_graph_kernel(), {}},
        {cgal_surface_mesh(KernelClass::simple), {invalid_flip_allowed, invalid_accepted}},
        {cgal_surface_mesh(KernelClass::loopless),
         {invalid_flip_allowed, invalid_accepted, answers_differ_from_ours}},
        {cgal_surface_mesh(KernelClass::delta_complex), {invalid_flip_allowed}},
        {open_mesh(KernelClass::simple), {}},
        {open_mesh(KernelClass::loopless), {valid_flip_refused, answers_differ_from_ours}},
        {open_mesh(KernelClass::delta_complex), {valid_flip_refused}},
    };
    return kernels;
}

const Target conformance_target{
    .name = "conformance",
    .description =
        "a flip script on this kernel, CGAL's and OpenMesh's: nothing breaks that "
        "docs/conformance.md does not list",
    .layout = kernel_script_layout,
    .objection =
        [](Input input) { return kernel_objection(decode_kernel_script(input), judged_kernels()); },
    .show = show_kernel_script,
    .seeds = kernel_script_seeds,
};

}  // namespace tightflip::fuzz
