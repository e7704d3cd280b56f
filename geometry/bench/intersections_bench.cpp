// What looking for self-intersections of an embedded surface costs, per face.
#include "peers.hpp"
#include "suites.hpp"
#include "workload.hpp"
#include <tightflip/geometry/self_intersections.hpp>

#include <string>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace tightflip::geometry::bench {

void register_intersection_benchmarks() {
    for (const Index side : {100, 708}) {  // 10^4 vertices; 10^6 faces
        const std::string group =
            "self-intersections/" + std::to_string(std::int64_t{side} * side) + " vertices/";
        benchmark::RegisterBenchmark(
            (group + "tightflip").c_str(), [side](benchmark::State& state) {
                const Surface surface = bumpy_torus(side, side);
                for (auto _ : state) {
                    const auto found = find_self_intersections(surface.view());
                    if (!found.is_embedded()) state.SkipWithError("should be embedded");
                }
                report_time_for(state, static_cast<double>(surface.triangulation().face_count()));
            });
        benchmark::RegisterBenchmark((group + "CGAL").c_str(), [side](benchmark::State& state) {
            const Surface surface = bumpy_torus(side, side);
            const CgalMesh mesh = cgal_mesh(surface);
            for (auto _ : state) {
                if (CGAL::Polygon_mesh_processing::does_self_intersect(mesh)) {
                    state.SkipWithError("should be embedded");
                }
            }
            report_time_for(state, static_cast<double>(surface.triangulation().face_count()));
        });
    }
}

}  // namespace tightflip::geometry::bench
