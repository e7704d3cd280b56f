// A target of ours in a fuzzer; which one is given as the name of its constant,
// TIGHTFLIP_FUZZ_TARGET.

#include "fuzzed_target.hpp"

#include "targets.hpp"

namespace tightflip::fuzz {

const Target fuzzed_target = TIGHTFLIP_FUZZ_TARGET;

}  // namespace tightflip::fuzz
