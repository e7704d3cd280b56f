// What local search costs, making the criterion and measuring both ends included, and where it
// ends. Starts: the hull of points on a sphere after random flips that keep the graph simple.
#include "plain_search.hpp"
#include "suites.hpp"
#include "workload.hpp"
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/optimise.hpp>
#include <tightflip/kernel/random_flips.hpp>

#include <array>
#include <string>

namespace tightflip::geometry::bench {
namespace {

Surface start_of(Index vertices, double flips_a_vertex) {
    Surface surface = data_sets::random_sphere(vertices, 1);
    kernel::flip_at_random(
        surface.triangulation(),
        {.count = static_cast<std::int64_t>(flips_a_vertex * vertices), .seed = 1, .simple = true});
    return surface;
}

double length_weighted(const Surface& surface) {
    return 2 * make_criterion(CriterionKind::mean_weighted, surface.view())->value().first();
}

/// Time a vertex; `flip` is the time a flip done, `end` the sum of lengths times angles.
template <class Search>
void measure(benchmark::State& state, const Surface& start, const Search& search) {
    Surface surface = start;
    double flips = 0;
    for (auto _ : state) {
        state.PauseTiming();
        surface = start;
        state.ResumeTiming();
        flips += static_cast<double>(search(surface));
    }
    report_time_for(state, start.triangulation().vertex_count());
    state.counters["flip"] =
        benchmark::Counter(flips, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["flips"] = flips / static_cast<double>(state.iterations());
    state.counters["end"] = length_weighted(surface);
}

struct Line {
    CriterionKind criterion;
    FlipOrder order;
    AllowedFlips allowed;
};

constexpr std::array lines{
    Line{CriterionKind::mean_weighted, FlipOrder::first, AllowedFlips::simple},
    Line{CriterionKind::mean_weighted, FlipOrder::best, AllowedFlips::simple},
    Line{CriterionKind::mean_weighted, FlipOrder::best, AllowedFlips::all},
    Line{CriterionKind::tight, FlipOrder::first, AllowedFlips::all},
    Line{CriterionKind::tight, FlipOrder::best, AllowedFlips::all},
    Line{CriterionKind::volume, FlipOrder::first, AllowedFlips::all},
    Line{CriterionKind::volume, FlipOrder::best, AllowedFlips::all},
};

std::string name_of(const Line& line) {
    return std::string(info(line.criterion).name) +
           (line.order == FlipOrder::first ? ", first" : ", best") +
           (line.allowed == AllowedFlips::simple ? ", simple" : "");
}

}  // namespace

void register_optimise_benchmarks() {
    constexpr std::array<std::pair<const char*, double>, 3> starts{
        {{"10 V", 10}, {"V", 1}, {"0.2 V", 0.2}}};
    for (const Index vertices : {10'000, 100'000}) {
        for (const auto& [name, flips] : starts) {
            const std::string group = std::string("local search after ") + name + " random flips/" +
                                      std::to_string(vertices) + " vertices/";
            const auto add = [&, flips = flips](const std::string& label, const auto& search) {
                benchmark::RegisterBenchmark((group + label).c_str(), [=](benchmark::State& state) {
                    measure(state, start_of(vertices, flips), search);
                })->Unit(benchmark::kMillisecond);
            };
            add("mean_weighted in plain doubles, first, simple",
                [](Surface& surface) { return search_plainly(surface); });
            for (const Line& line : lines) {
                add(name_of(line), [line](Surface& surface) {
                    const auto criterion = make_criterion(line.criterion, surface.view());
                    return optimise(surface.triangulation(), surface.points(), *criterion,
                                    {.order = line.order, .allowed = line.allowed})
                        .flips.size();
                });
            }
        }
    }
}

}  // namespace tightflip::geometry::bench
