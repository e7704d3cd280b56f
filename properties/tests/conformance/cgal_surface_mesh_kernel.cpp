#include "cgal_graph_kernel.hpp"
#include "kernels.hpp"

#include <CGAL/Surface_mesh.h>

namespace tightflip::properties {
namespace {

struct SurfaceMeshKernel : CgalGraphKernel<CGAL::Surface_mesh<CgalPoint>> {
    static constexpr std::string_view name = "CGAL::Surface_mesh";
    static constexpr KernelClass allowed = KernelClass::simple;
    using CgalGraphKernel::CgalGraphKernel;

    [[nodiscard]] bool is_valid() const { return mesh.is_valid(false); }
};

struct PolygonMeshKernel : SurfaceMeshKernel {
    static constexpr std::string_view name = "CGAL::Surface_mesh, is_valid_polygon_mesh";
    using SurfaceMeshKernel::SurfaceMeshKernel;

    [[nodiscard]] bool is_valid() const { return CGAL::is_valid_polygon_mesh(mesh, false); }
};

}  // namespace

KernelDescription cgal_polygon_mesh(KernelClass allowed) {
    return judged_as<PolygonMeshKernel>(allowed);
}

KernelDescription cgal_surface_mesh(KernelClass allowed) {
    return judged_as<SurfaceMeshKernel>(allowed);
}

}  // namespace tightflip::properties
