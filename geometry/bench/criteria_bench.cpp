// What one evaluated flip costs, edges in random order.
#include "suites.hpp"
#include "workload.hpp"
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/curvature.hpp>

#include <memory>
#include <string>

namespace tightflip::geometry::bench {
namespace {

void evaluate(benchmark::State& state, CriterionKind kind, Index side) {
    const Surface surface = bumpy_torus(side, side);
    const auto edges = random_edges(surface.triangulation());
    const auto criterion = make_criterion(kind, surface.view());
    for (auto _ : state) {
        double sum = 0;
        for (const Edge e : edges)
            sum += criterion->change(e).first();
        benchmark::DoNotOptimize(sum);
    }
    report_time_for(state, static_cast<double>(edges.size()));
}

/// The plain way to the change of Omega_abs: the four stars before and after.
void evaluate_tight_plainly(benchmark::State& state, Index side) {
    Surface surface = bumpy_torus(side, side);
    const auto edges = random_edges(surface.triangulation());
    StarMeter meter;
    const auto positive_about = [&](Edge e) {
        const auto q = kernel::Quadrilateral::around(surface.triangulation().table(), e);
        double sum = 0;
        for (const Halfedge h : {q.h, q.t, q.h2, q.t2})
            sum += meter.measure(surface.view(), h).positive;
        return sum;
    };
    for (auto _ : state) {
        double sum = 0;
        for (const Edge e : edges) {
            sum -= positive_about(e);
            surface.triangulation().flip(e);
            sum += positive_about(e);
            surface.triangulation().unflip(e);
        }
        benchmark::DoNotOptimize(sum);
    }
    report_time_for(state, static_cast<double>(edges.size()));
}

}  // namespace

void register_criteria_benchmarks() {
    const Index side = 100;
    const std::string group = "evaluate a flip/10000 vertices/";
    for (const CriterionInfo& info : all_criteria()) {
        if (info.needs_heights) continue;
        benchmark::RegisterBenchmark(
            (group + std::string(info.name)).c_str(),
            [kind = info.kind](benchmark::State& state) { evaluate(state, kind, side); });
    }
    benchmark::RegisterBenchmark(
        (group + "tight, four stars measured twice").c_str(),
        [](benchmark::State& state) { evaluate_tight_plainly(state, side); });
}

}  // namespace tightflip::geometry::bench
