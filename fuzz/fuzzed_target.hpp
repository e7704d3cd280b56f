/// \file
/// The target of a program that has one: a fuzzer, or `tightflip_fuzz` for a kernel of your own.
/// Whoever links `tightflip_fuzzer` or `tightflip_fuzz_tool` defines it.
#pragma once

#include "target.hpp"

namespace tightflip::fuzz {

extern const Target fuzzed_target;

}  // namespace tightflip::fuzz
