/// \file
/// Mesh kernels that the conformance suite has been pointed at. CGAL's meshes are GPL: only tests
/// and fuzz targets, which are not installed, link them. The libraries do not name a class for
/// their meshes; so each is judged in all three.
#pragma once

#include <tightflip/properties/kernel_under_test.hpp>

#include <vector>

namespace tightflip::properties {

[[nodiscard]] KernelDescription our_kernel();
/// Ours, with a fault on purpose: what a broken kernel looks like under the suite.
[[nodiscard]] KernelDescription broken_kernel();
[[nodiscard]] KernelDescription cgal_surface_mesh(KernelClass allowed);
[[nodiscard]] KernelDescription cgal_polygon_mesh(KernelClass allowed);
[[nodiscard]] KernelDescription cgal_polyhedron(KernelClass allowed);
[[nodiscard]] KernelDescription cgal_triangulation_data_structure(KernelClass allowed);
[[nodiscard]] KernelDescription open_mesh(KernelClass allowed);
[[nodiscard]] KernelDescription open_mesh_by_hand(KernelClass allowed);
[[nodiscard]] KernelDescription boost_graph_kernel();

/// The description of an adaptor, judged in another class than it names.
template <MeshKernel K>
[[nodiscard]] KernelDescription judged_as(KernelClass allowed) {
    KernelDescription description = kernel_description<K>();
    description.allowed = allowed;
    return description;
}

/// All of them, in the order of docs/conformance.md.
[[nodiscard]] std::vector<KernelDescription> all_kernels();

}  // namespace tightflip::properties
