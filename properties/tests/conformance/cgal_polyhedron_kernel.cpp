#include "cgal_graph_kernel.hpp"
#include "kernels.hpp"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

namespace tightflip::properties {
namespace {

struct PolyhedronKernel : CgalGraphKernel<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>> {
    static constexpr std::string_view name = "CGAL::Polyhedron_3";
    static constexpr KernelClass allowed = KernelClass::simple;
    using CgalGraphKernel::CgalGraphKernel;

    [[nodiscard]] bool is_valid() const { return mesh.is_valid(false); }
};

}  // namespace

KernelDescription cgal_polyhedron(KernelClass allowed) {
    return judged_as<PolyhedronKernel>(allowed);
}

}  // namespace tightflip::properties
