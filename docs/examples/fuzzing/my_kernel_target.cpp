// The fuzz target of docs/fuzzing.md: the mesh of ../conformance.
#include "fuzzed_target.hpp"
#include "kernel_script.hpp"
#include "my_kernel.hpp"  // the adaptor, as in docs/conformance.md

namespace tightflip::fuzz {

const Target fuzzed_target = kernel_target<properties::MyKernel>("my_kernel");

}  // namespace tightflip::fuzz
