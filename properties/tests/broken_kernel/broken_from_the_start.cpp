// Linked into a program, this breaks its flip before anything runs.

#include "broken_flips.hpp"

namespace {
const tightflip::broken::BrokenKernel broken_from_the_start(
    {.flip = tightflip::broken::wrong_origin});
}  // namespace
