/// \file
/// The command `tightflip_fuzz`: fuzz targets for people and for tests, without a fuzzer.
#pragma once

#include "target.hpp"

namespace tightflip::fuzz {

/// Does what the arguments say with these targets. Returns 0: every claim held; 1: one did not; 2:
/// wrong usage, or an argument that could not be read or written.
int run_tool(std::span<const Target> targets, int argc, char** argv);

}  // namespace tightflip::fuzz
