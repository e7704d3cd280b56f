// What reading an OBJ file costs, per face, with building the surface's connectivity.
#include "peers.hpp"
#include "suites.hpp"
#include "workload.hpp"
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/kernel/build.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/IO/OBJ.h>
// OpenMesh's readers register themselves where this header is included.
#include <OpenMesh/Core/IO/MeshIO.hh>

namespace tightflip::geometry::bench {
namespace {

/// A file that is there as long as this is.
class ObjFile {
public:
    explicit ObjFile(const Surface& surface)
        : path_(std::filesystem::temp_directory_path() /
                ("tightflip-bench-" + std::to_string(::getpid()) + ".obj")) {
        std::ofstream out(path_);
        out.precision(17);
        for (const Point& p : surface.points())
            out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
        for (const auto& [a, b, c] : face_list(surface.triangulation()))
            out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    }
    ObjFile(const ObjFile&) = delete;
    ObjFile& operator=(const ObjFile&) = delete;
    ~ObjFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

template <class Read>
void add(Index side, const std::string& line, Read read) {
    const std::string group =
        "read OBJ/" + std::to_string(std::int64_t{side} * side) + " vertices/";
    benchmark::RegisterBenchmark((group + line).c_str(), [=](benchmark::State& state) {
        const Surface surface = bumpy_torus(side, side);
        const ObjFile file(surface);
        const auto faces = static_cast<std::size_t>(surface.triangulation().face_count());
        for (auto _ : state) {
            if (read(file.path()) != faces) state.SkipWithError("not all faces were read");
        }
        report_time_for(state, static_cast<double>(faces));
    });
}

}  // namespace

void register_file_benchmarks() {
    for (const Index side : {100, 708}) {
        add(side, "tightflip, points and triangles",
            [](const std::string& path) { return read_mesh_file(path).triangles.size(); });
        add(side, "tightflip, built and audited", [](const std::string& path) {
            const TriangleSoup soup = read_mesh_file(path);
            const auto built = kernel::build(soup.triangles, soup.vertex_count());
            return static_cast<std::size_t>(built.value().face_count());
        });
        add(side, "CGAL, Surface_mesh", [](const std::string& path) {
            CgalMesh mesh;
            CGAL::IO::read_OBJ(path, mesh);
            return static_cast<std::size_t>(mesh.number_of_faces());
        });
        add(side, "OpenMesh", [](const std::string& path) {
            OpenMeshMesh mesh;
            OpenMesh::IO::read_mesh(mesh, path);
            return mesh.n_faces();
        });
    }
}

}  // namespace tightflip::geometry::bench
