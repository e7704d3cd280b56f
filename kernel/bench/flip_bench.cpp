// Flips of random edges. Every run starts from the same surface and flips the same list.
//   flip/same      the same flips by every kernel: only edges that are legal at their turn
//   flip/any       edges as they come, from a multigraph; the EDF refuses some
//   flip/simple    edges as they come, from a simple graph; kernels that keep it simple refuse more
#include "bare_kernels.hpp"
#include "own_kernels.hpp"
#include "peer_kernels.hpp"
#include "suites.hpp"

#include <benchmark/benchmark.h>

namespace tightflip::kernel::bench {
namespace {

using Surfaces = const Triangulation& (*)(Index vertices);
using Edges = const std::vector<Edge>& (*)(Index vertices);

template <class Kernel>
void flip_edges(benchmark::State& state, Surfaces surfaces, Edges edges, Index vertices) {
    const Kernel start(surfaces(vertices));
    std::vector<Edge> script = edges(vertices);
    if constexpr (requires { start.translated(script); }) script = start.translated(script);
    std::size_t done = 0;
    std::size_t attempts = 0;
    for (auto _ : state) {
        state.PauseTiming();
        Kernel kernel = start;
        benchmark::ClobberMemory();
        state.ResumeTiming();
        std::size_t flips = kernel.flip_each(script);
        benchmark::DoNotOptimize(flips);
        benchmark::ClobberMemory();
        state.PauseTiming();  // not the destructor
        done += flips;
        attempts += script.size();
        state.ResumeTiming();
    }
    state.counters["time"] = benchmark::Counter(
        static_cast<double>(done), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["done"] = static_cast<double>(done) / static_cast<double>(attempts);
}

template <class... Kernels>
void add(const std::string& group, Surfaces surfaces, Edges edges) {
    for (const Index vertices : sizes) {
        const auto add_one = [&]<class Kernel>(Kernel*) {
            const std::string name =
                group + "/" + std::to_string(vertices) + " vertices/" + Kernel::name;
            benchmark::RegisterBenchmark(name.c_str(), flip_edges<Kernel>, surfaces, edges,
                                         vertices)
                ->Unit(benchmark::kMillisecond);
        };
        (add_one(static_cast<Kernels*>(nullptr)), ...);
    }
}

const std::vector<Edge>& any_edges(Index vertices) {
    return random_edges(multigraph_sphere(vertices));
}
const std::vector<Edge>& any_edges_of_simple(Index vertices) {
    return random_edges(simple_sphere(vertices));
}

}  // namespace

void register_flip_benchmarks() {
    add<OneByOne, Batched, WithVertexMap, BareRecords, BareArrays, BareFaceRecords, BareSideArrays,
        CgalUnchecked, OpenMeshUnchecked>("flip/same", multigraph_sphere, flippable_edges);
    add<OneByOne, Batched, CgalDistinctCorners>("flip/any", multigraph_sphere, any_edges);
    add<OneByOne, CgalSimple, OpenMeshSimple, OpenMeshSimpleInline>("flip/simple", simple_sphere,
                                                                    any_edges_of_simple);
}

}  // namespace tightflip::kernel::bench
