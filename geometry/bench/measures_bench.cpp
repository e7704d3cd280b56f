// What measuring a whole surface costs, per vertex.
#include "peers.hpp"
#include "suites.hpp"
#include "workload.hpp"
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/surface_measures.hpp>

#include <cmath>
#include <string>

#include <CGAL/Polygon_mesh_processing/measure.h>

namespace tightflip::geometry::bench {
namespace {

/// Runs `measure_it` on what `make` makes of the surface.
template <class Make, class Measure>
void add(Index side, const std::string& line, Make make, Measure measure_it) {
    const std::string group = "measure/" + std::to_string(std::int64_t{side} * side) + " vertices/";
    benchmark::RegisterBenchmark((group + line).c_str(), [=](benchmark::State& state) {
        const Surface surface = bumpy_torus(side, side);
        const auto mesh = make(surface);
        for (auto _ : state)
            benchmark::DoNotOptimize(measure_it(mesh));
        report_time_for(state, static_cast<double>(surface.points().size()));
    });
}

double criterion_value(const Surface& surface, CriterionKind kind) {
    return make_criterion(kind, surface.view())->value().first();
}

}  // namespace

void register_measure_benchmarks() {
    const auto itself = [](const Surface& surface) { return surface; };
    for (const Index side : {100, 1000}) {
        add(side, "tightflip, all measures and types", itself,
            [](const Surface& surface) { return measure(surface.view()).area; });
        add(side, "tightflip, area", itself,
            [](const Surface& s) { return criterion_value(s, CriterionKind::area); });
        add(side, "CGAL, area", cgal_mesh, [](const CgalMesh& mesh) {
            return CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh));
        });
        add(side, "tightflip, volume", itself,
            [](const Surface& s) { return criterion_value(s, CriterionKind::volume); });
        add(side, "CGAL, volume", cgal_mesh, [](const CgalMesh& mesh) {
            return CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh));
        });
        add(side, "tightflip, angles between normals", itself,
            [](const Surface& s) { return criterion_value(s, CriterionKind::abn); });
        add(side, "OpenMesh, dihedral angles", openmesh_mesh, [](const OpenMeshMesh& mesh) {
            double sum = 0;
            for (const auto e : mesh.edges())
                sum += std::abs(mesh.calc_dihedral_angle(e));
            return sum;
        });
        add(side, "tightflip, Omega_abs", itself,
            [](const Surface& s) { return criterion_value(s, CriterionKind::tight); });
    }
}

}  // namespace tightflip::geometry::bench
