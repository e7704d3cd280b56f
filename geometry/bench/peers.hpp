/// \file
/// The same surfaces as CGAL's and OpenMesh's meshes.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace tightflip::geometry::bench {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using OpenMeshMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

inline std::vector<std::array<Index, 3>> face_list(const Triangulation& surface) {
    std::vector<std::array<Index, 3>> faces;
    for (const Halfedge h : surface.faces())
        faces.push_back({surface.origin(h).id, surface.target(h).id, surface.opposite(h).id});
    return faces;
}

inline CgalMesh cgal_mesh(const Surface& surface) {
    CgalMesh mesh;
    for (const Point& p : surface.points())
        mesh.add_vertex({p.x(), p.y(), p.z()});
    using V = CgalMesh::Vertex_index;
    for (const auto& [a, b, c] : face_list(surface.triangulation())) {
        mesh.add_face(V(static_cast<unsigned>(a)), V(static_cast<unsigned>(b)),
                      V(static_cast<unsigned>(c)));
    }
    return mesh;
}

inline OpenMeshMesh openmesh_mesh(const Surface& surface) {
    OpenMeshMesh mesh;
    for (const Point& p : surface.points())
        mesh.add_vertex({p.x(), p.y(), p.z()});
    for (const auto& [a, b, c] : face_list(surface.triangulation())) {
        mesh.add_face(OpenMeshMesh::VertexHandle(a), OpenMeshMesh::VertexHandle(b),
                      OpenMeshMesh::VertexHandle(c));
    }
    return mesh;
}

}  // namespace tightflip::geometry::bench
