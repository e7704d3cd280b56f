// Links the geometry layer: reads a mesh file, glues its triangles and audits the surface.
#include <tightflip/geometry/file_place.hpp>
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/kernel/build.hpp>

#include <iostream>

using namespace tightflip;

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: example MESH\n";
        return 2;
    }
    try {
        const geometry::TriangleSoup soup = geometry::read_mesh_file(argv[1]);
        const auto reading = kernel::glue_faces(soup.triangles, soup.vertex_count());
        const kernel::AuditReport report = kernel::audit(reading.gluing);
        for (const kernel::Violation& violation : report.violations) {
            std::cout << geometry::where(soup, violation) << ": " << message(violation) << '\n';
        }
        std::cout << (report.is_valid() ? "valid" : "not valid") << ", Euler characteristic "
                  << report.topology.euler_characteristic << '\n';
        return report.is_valid() ? 0 : 1;
    } catch (const kernel::FileError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
