// The judge and what stands on it. Times are per vertex, but per attempted flip in `campaign`.
#include "suites.hpp"
#include "workload.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <functional>

#include <benchmark/benchmark.h>

namespace tightflip::kernel::bench {
namespace {

/// A campaign's steps between two full audits.
std::int64_t steps_between_audits(Index vertices) {
    return 10 * std::int64_t{vertices};
}

void report_time_for(benchmark::State& state, double items) {
    state.counters["time"] =
        benchmark::Counter(items * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The unit that audits are compared with: one pass over the table that reads each halfedge's
/// record and the one it names.
std::int64_t pass(const Triangulation& surface) {
    const HalfedgeTable table = surface.table();
    std::int64_t sum = 0;
    for (Index h = 0; h < surface.halfedge_count(); ++h)
        sum += at(table, at(table, {h}).next).origin.id;
    return sum;
}

/// The gluing that a surface's tables say.
Gluing gluing_of(const Triangulation& surface) {
    return read_table(surface.table(), surface.vertex_count()).gluing;
}

/// Random flips, each seen by the constant-time audit, and the full audit at the end.
std::int64_t campaign(Triangulation& surface, RandomStream& random) {
    const auto edges = static_cast<std::uint32_t>(surface.edge_count());
    std::int64_t violations = 0;
    for (std::int64_t k = 0; k < steps_between_audits(surface.vertex_count()); ++k) {
        const Edge e{static_cast<Index>(random.below(edges))};
        if (!surface.flip(e)) continue;
        violations += audit_at_edge(surface.table(), surface.vertex_count(), e) ? 1 : 0;
    }
    return violations + audit(surface, {.statistics = false}).violation_count;
}

void measure_campaign(benchmark::State& state, Index vertices) {
    Triangulation surface = multigraph_sphere(vertices);
    RandomStream random(1);
    for (auto _ : state)
        benchmark::DoNotOptimize(campaign(surface, random));
    report_time_for(state, static_cast<double>(steps_between_audits(vertices)));
}

/// Measures work on the long-flipped sphere; `prepare` makes its input.
template <class Prepare, class Work>
void add(const char* label, Index vertices, Prepare prepare, Work work) {
    const std::string name = "whole surface/" + std::to_string(vertices) + " vertices/" + label;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        const auto input = prepare(multigraph_sphere(vertices));
        for (auto _ : state)
            benchmark::DoNotOptimize(work(input));
        report_time_for(state, static_cast<double>(vertices));
    })->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_audit_benchmarks() {
    for (const Index vertices : sizes) {
        const auto itself = [](const Triangulation& surface) { return std::cref(surface); };
        add("one pass that follows next", vertices, itself, pass);
        add("audit", vertices, itself, [](const Triangulation& surface) {
            return audit(surface, {.statistics = false}).violation_count;
        });
        add("audit with statistics", vertices, itself,
            [](const Triangulation& surface) { return audit(surface).violation_count; });
        add("build from a gluing", vertices, gluing_of,
            [](const Gluing& gluing) { return build(gluing).value().halfedge_count(); });
        add("same_labelled_surface", vertices, itself,
            [](const Triangulation& surface) { return same_labelled_surface(surface, surface); });
        const std::string name = "campaign/" + std::to_string(vertices) +
                                 " vertices/flip, local audit, random; audit every " +
                                 std::to_string(steps_between_audits(vertices));
        benchmark::RegisterBenchmark(name.c_str(), measure_campaign, vertices)
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace tightflip::kernel::bench
