#include "markdown_reporter.hpp"
#include "suites.hpp"

#include <iostream>

#include <benchmark/benchmark.h>

// The tables on standard output; Google Benchmark's own report goes to --benchmark_out=FILE.
int main(int argc, char** argv) {
    namespace bench = tightflip::kernel::bench;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    const auto differing = bench::disagreements();
    for (const auto& name : differing)
        std::cerr << "ends with other faces than its peers: " << name << '\n';
    if (!differing.empty()) return 1;

    bench::register_flip_benchmarks();
    bench::register_audit_benchmarks();
    bench::register_memory_benchmarks();
    bench::MarkdownReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
}
