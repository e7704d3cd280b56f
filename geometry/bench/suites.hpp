/// \file
/// The parts of the benchmark binary, called by main.
#pragma once

namespace tightflip::geometry::bench {

void register_criteria_benchmarks();
void register_measure_benchmarks();
void register_intersection_benchmarks();
void register_file_benchmarks();
void register_optimise_benchmarks();
void register_convexify_benchmarks();

}  // namespace tightflip::geometry::bench
