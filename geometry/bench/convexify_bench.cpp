// What it costs to come to the convex hull by flips alone, per vertex, beside hulls built from
// points.
#include "peers.hpp"
#include "suites.hpp"
#include "workload.hpp"
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/convexify.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/kernel/random_flips.hpp>

#include <string>

#include <CGAL/convex_hull_3.h>

namespace tightflip::geometry::bench {
namespace {

using Start = Triangulation (*)(const Surface& hull);

Triangulation random_surface(const Surface& hull) {
    return kernel::families::random(hull.triangulation().vertex_count(), 0, 1);
}

Triangulation ten_flips_a_vertex(const Surface& hull) {
    Triangulation surface = hull.triangulation();
    static_cast<void>(kernel::flip_at_random(
        surface, {.count = 10 * std::int64_t{surface.vertex_count()}, .seed = 1, .simple = true}));
    return surface;
}

void by_flips(benchmark::State& state, Index vertices, Start start) {
    const Surface hull = data_sets::random_sphere(vertices, 1);
    const Triangulation begin = start(hull);
    std::size_t flips = 0;
    for (auto _ : state) {
        Triangulation surface = begin;
        const ConvexifyResult result = convexify(surface, hull.points());
        if (!result) state.SkipWithError("should be convex");
        flips = result.flips.size();
    }
    report_time_for(state, vertices);
    state.counters["flips"] = static_cast<double>(flips) / vertices;
}

}  // namespace

void register_convexify_benchmarks() {
    for (const Index vertices : {10'000, 100'000}) {
        const std::string group = "convex hull/" + std::to_string(vertices) + " vertices/";
        benchmark::RegisterBenchmark(
            (group + "tightflip, by flips, from a random surface").c_str(),
            [vertices](benchmark::State& state) { by_flips(state, vertices, random_surface); });
        benchmark::RegisterBenchmark(
            (group + "tightflip, by flips, from 10 V flips of the hull").c_str(),
            [vertices](benchmark::State& state) { by_flips(state, vertices, ten_flips_a_vertex); });
        benchmark::RegisterBenchmark((group + "tightflip, from points").c_str(),
                                     [vertices](benchmark::State& state) {
                                         const Surface hull = data_sets::random_sphere(vertices, 1);
                                         for (auto _ : state) {
                                             if (!convex_hull(hull.points()))
                                                 state.SkipWithError("should have a hull");
                                         }
                                         report_time_for(state, vertices);
                                     });
        benchmark::RegisterBenchmark(
            (group + "CGAL, from points").c_str(), [vertices](benchmark::State& state) {
                const Surface hull = data_sets::random_sphere(vertices, 1);
                std::vector<CgalKernel::Point_3> points;
                for (const Point& p : hull.points())
                    points.emplace_back(p.x(), p.y(), p.z());
                for (auto _ : state) {
                    CgalMesh mesh;
                    CGAL::convex_hull_3(points.begin(), points.end(), mesh);
                    benchmark::DoNotOptimize(mesh);
                }
                report_time_for(state, vertices);
            });
    }
}

}  // namespace tightflip::geometry::bench
