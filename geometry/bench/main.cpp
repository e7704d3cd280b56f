#include "suites.hpp"

#include <markdown_reporter.hpp>

#include <benchmark/benchmark.h>

// The tables on standard output; Google Benchmark's own report goes to --benchmark_out=FILE.
int main(int argc, char** argv) {
    namespace bench = tightflip::geometry::bench;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    bench::register_criteria_benchmarks();
    bench::register_measure_benchmarks();
    bench::register_intersection_benchmarks();
    bench::register_file_benchmarks();
    bench::register_optimise_benchmarks();
    bench::register_convexify_benchmarks();
    tightflip::kernel::bench::MarkdownReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
}
