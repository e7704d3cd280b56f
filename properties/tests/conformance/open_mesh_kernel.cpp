// Assertions are off, as in released programs, whatever the build.
#ifndef NDEBUG
#define NDEBUG
#endif

#include "kernels.hpp"

#include <ostream>
#include <stdexcept>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>

namespace tightflip::properties {
namespace {

struct OpenMeshKernel {
    using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
    static constexpr std::string_view name = "OpenMesh::TriMesh";
    static constexpr KernelClass allowed = KernelClass::simple;
    using Side = OpenMesh::HalfedgeHandle;

    OpenMeshKernel(Index vertex_count, std::span<const std::array<Index, 3>> faces) {
        for (Index v = 0; v < vertex_count; ++v)
            mesh.add_vertex(Mesh::Point(0, 0, 0));
        for (const auto& [a, b, c] : faces) {
            if (!mesh.add_face(vertex(a), vertex(b), vertex(c)).is_valid()) {
                throw std::invalid_argument("add_face refuses a face");
            }
        }
    }

    [[nodiscard]] std::array<Index, 3> counts() const {
        return {static_cast<Index>(mesh.n_vertices()), static_cast<Index>(mesh.n_edges()),
                static_cast<Index>(mesh.n_faces())};
    }
    [[nodiscard]] std::vector<Side> sides() const {
        std::vector<Side> all;
        for (const Side s : mesh.halfedges())
            all.push_back(s);
        return all;
    }
    [[nodiscard]] Side next(Side s) const { return mesh.next_halfedge_handle(s); }
    [[nodiscard]] Side across(Side s) const { return mesh.opposite_halfedge_handle(s); }
    [[nodiscard]] Index origin(Side s) const { return mesh.from_vertex_handle(s).idx(); }
    [[nodiscard]] bool can_flip(Side s) const { return mesh.is_flip_ok(mesh.edge_handle(s)); }
    void flip(Side s) { mesh.flip(mesh.edge_handle(s)); }
    [[nodiscard]] bool is_valid() const {
        std::ostream nowhere(nullptr);
        // The checker's interface lacks a const; it changes nothing.
        auto& checked = const_cast<Mesh&>(mesh);
        return OpenMesh::Utils::MeshCheckerT<Mesh>(checked).check(
            OpenMesh::Utils::MeshCheckerT<Mesh>::CHECK_ALL, nowhere);
    }

    void set_origin(Side s, Index v) { mesh.set_vertex_handle(across(s), vertex(v)); }
    void set_next(Side s, Side wrong) { mesh.set_next_halfedge_handle(s, wrong); }

    static OpenMesh::VertexHandle vertex(Index v) { return OpenMesh::VertexHandle(v); }

    Mesh mesh;
};

/// The flip made of the mesh's setters and asking nothing, to see what the checker says of the
/// results: flip() itself asserts is_flip_ok().
struct ByHandOpenMeshKernel : OpenMeshKernel {
    static constexpr std::string_view name = "OpenMesh::TriMesh, flipped through its setters";
    using OpenMeshKernel::OpenMeshKernel;

    [[nodiscard]] bool can_flip(Side s) const {
        return mesh.face_handle(s) != mesh.face_handle(across(s));
    }
    void flip(Side s) {
        const Side t = across(s);
        const Side s1 = next(s);
        const Side s2 = next(s1);
        const Side t1 = next(t);
        const Side t2 = next(t1);
        const auto from = mesh.from_vertex_handle(s);
        const auto to = mesh.to_vertex_handle(s);
        mesh.set_vertex_handle(s, mesh.to_vertex_handle(s1));
        mesh.set_vertex_handle(t, mesh.to_vertex_handle(t1));
        make_face(mesh.face_handle(s), {s, s2, t1});
        make_face(mesh.face_handle(t), {t, t2, s1});
        if (mesh.halfedge_handle(from) == s) mesh.set_halfedge_handle(from, t1);
        if (mesh.halfedge_handle(to) == t) mesh.set_halfedge_handle(to, s1);
    }
    void make_face(OpenMesh::FaceHandle face, const std::array<Side, 3>& sides) {
        for (std::size_t i = 0; i < 3; ++i) {
            mesh.set_next_halfedge_handle(sides[i], sides[(i + 1) % 3]);
            mesh.set_face_handle(sides[i], face);
        }
        mesh.set_halfedge_handle(face, sides[0]);
    }
};

}  // namespace

KernelDescription open_mesh_by_hand(KernelClass allowed) {
    return judged_as<ByHandOpenMeshKernel>(allowed);
}

KernelDescription open_mesh(KernelClass allowed) {
    return judged_as<OpenMeshKernel>(allowed);
}

}  // namespace tightflip::properties
