// What each kernel's connectivity occupies: bytes on the heap a vertex, without the coordinates
// that two of them must carry.
#include "own_kernels.hpp"
#include "peer_kernels.hpp"
#include "suites.hpp"

#include <malloc.h>

#include <benchmark/benchmark.h>

namespace tightflip::kernel::bench {
namespace {

std::size_t heap_in_use() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

template <class Kernel>
void occupy(benchmark::State& state, Index vertices, std::size_t coordinate_bytes) {
    double bytes = 0;
    const Triangulation& start = multigraph_sphere(vertices);
    for (auto _ : state) {
        const std::size_t before = heap_in_use();
        const Kernel kernel(start);
        bytes = static_cast<double>(heap_in_use() - before);
        benchmark::DoNotOptimize(&kernel);
    }
    state.counters["bytes"] = bytes / vertices - static_cast<double>(coordinate_bytes);
}

template <class Kernel>
void add(const char* kernel, std::size_t coordinate_bytes) {
    const Index vertices = sizes.back();
    const std::string name = "memory/" + std::to_string(vertices) + " vertices/" + kernel;
    benchmark::RegisterBenchmark(name.c_str(), occupy<Kernel>, vertices, coordinate_bytes)
        ->Iterations(1);
}

}  // namespace

void register_memory_benchmarks() {
    add<OneByOne>("tightflip", 0);
    add<WithVertexMap>("tightflip and a vertex map", 0);
    add<Cgal>("CGAL Surface_mesh", sizeof(Cgal::Mesh::Point));
    add<OpenMeshKernel>("OpenMesh", sizeof(OpenMeshKernel::Mesh::Point));
}

}  // namespace tightflip::kernel::bench
