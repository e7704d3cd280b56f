#include "kernels.hpp"

namespace tightflip::properties {

std::vector<KernelDescription> all_kernels() {
    std::vector<KernelDescription> kernels{our_kernel(), broken_kernel(), boost_graph_kernel()};
    for (const auto make : {cgal_surface_mesh, cgal_polygon_mesh, cgal_polyhedron,
                            cgal_triangulation_data_structure, open_mesh, open_mesh_by_hand}) {
        for (const KernelClass allowed :
             {KernelClass::simple, KernelClass::loopless, KernelClass::delta_complex})
            kernels.push_back(make(allowed));
    }
    return kernels;
}

}  // namespace tightflip::properties
