/// \file
/// The parts of the benchmark binary, called by main.
#pragma once

#include <string>
#include <vector>

namespace tightflip::kernel::bench {

/// Runs every kernel over the same edges on a small surface and compares the faces they end with
/// (and, for the kernels that keep graphs simple, the flips they refuse). Returns what differs.
std::vector<std::string> disagreements();

void register_flip_benchmarks();
void register_audit_benchmarks();
void register_memory_benchmarks();

}  // namespace tightflip::kernel::bench
