/// \file
/// Other halfedge kernels, filled through their low-level interfaces so that edge k is edge k of
/// the start (both number the halfedges of edge k by 2k and 2k + 1) and parallel edges survive.
///
/// Their flip turns the edge the other way round than the EDF here: the halfedges of the flipped
/// edge are exchanged, edges and faces are the same.
#pragma once

#include "workload.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace tightflip::kernel::bench {

// ---- CGAL::Surface_mesh ----

class Cgal {
public:
    using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

    explicit Cgal(const Triangulation& start) {
        const auto count = [](Index n) { return static_cast<Mesh::size_type>(n); };
        mesh_.reserve(count(start.vertex_count()), count(start.edge_count()),
                      count(start.face_count()));
        for (Index v = 0; v < start.vertex_count(); ++v)
            mesh_.add_vertex();
        for (Index e = 0; e < start.edge_count(); ++e)
            mesh_.add_edge();
        for (const Halfedge first : start.faces()) {
            const Mesh::Face_index face = mesh_.add_face();
            mesh_.set_halfedge(face, halfedge(first));
            for (const Halfedge h : start.face_sides(first)) {
                const Mesh::Vertex_index target(count(start.target(h).id));
                mesh_.set_face(halfedge(h), face);
                mesh_.set_next(halfedge(h), halfedge(start.next(h)));
                mesh_.set_target(halfedge(h), target);
                mesh_.set_halfedge(target, halfedge(h));
            }
        }
    }

    [[nodiscard]] FaceList faces() const {
        FaceList faces;
        for (const auto face : mesh_.faces()) {
            auto& corners = faces.emplace_back();
            std::size_t i = 0;
            for (const auto v : mesh_.vertices_around_face(mesh_.halfedge(face)))
                corners[i++] = static_cast<Index>(v.idx());
        }
        return faces;
    }

protected:
    static Mesh::Halfedge_index halfedge(Halfedge h) {
        return Mesh::Halfedge_index(static_cast<Mesh::size_type>(h.id));
    }

    /// Flips the edges of a list whose two opposite corners satisfy a condition.
    template <class Condition>
    std::size_t flip_where(std::span<const Edge> edges, Condition&& condition) {
        std::size_t done = 0;
        for (const Edge e : edges) {
            const auto h = halfedge(halfedge_of(e));
            const auto c = mesh_.target(mesh_.next(h));
            const auto d = mesh_.target(mesh_.next(mesh_.opposite(h)));
            if (!condition(c, d)) continue;
            CGAL::Euler::flip_edge(h, mesh_);
            ++done;
        }
        return done;
    }

    Mesh mesh_;
};

struct CgalUnchecked : Cgal {
    static constexpr const char* name = "CGAL Surface_mesh, no check";
    using Cgal::Cgal;
    std::size_t flip_each(std::span<const Edge> edges) {
        for (const Edge e : edges)
            CGAL::Euler::flip_edge(halfedge(halfedge_of(e)), mesh_);
        return edges.size();
    }
};

/// With the condition of the EDF, which CGAL does not offer, put in front.
struct CgalDistinctCorners : Cgal {
    static constexpr const char* name = "CGAL Surface_mesh, opposite corners compared";
    using Cgal::Cgal;
    std::size_t flip_each(std::span<const Edge> edges) {
        return flip_where(edges, [](auto c, auto d) { return c != d; });
    }
};

/// With the check that keeps a graph simple.
struct CgalSimple : Cgal {
    static constexpr const char* name = "CGAL Surface_mesh, no edge halfedge(c, d)";
    using Cgal::Cgal;
    std::size_t flip_each(std::span<const Edge> edges) {
        return flip_where(edges,
                          [&](auto c, auto d) { return !CGAL::halfedge(c, d, mesh_).second; });
    }
};

// ---- OpenMesh::TriMesh_ArrayKernelT ----

class OpenMeshKernel {
public:
    using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

    explicit OpenMeshKernel(const Triangulation& start) {
        const auto count = [](Index n) { return static_cast<std::size_t>(n); };
        mesh_.reserve(count(start.vertex_count()), count(start.edge_count()),
                      count(start.face_count()));
        for (Index v = 0; v < start.vertex_count(); ++v)
            mesh_.new_vertex();
        for (Index h = 0; h < start.halfedge_count(); h += 2)
            mesh_.new_edge(OpenMesh::VertexHandle(start.origin({h}).id),
                           OpenMesh::VertexHandle(start.target({h}).id));
        for (const Halfedge first : start.faces()) {
            const OpenMesh::FaceHandle face = mesh_.new_face();
            mesh_.set_halfedge_handle(face, halfedge(first));
            for (const Halfedge h : start.face_sides(first)) {
                mesh_.set_face_handle(halfedge(h), face);
                mesh_.set_next_halfedge_handle(halfedge(h), halfedge(start.next(h)));
                mesh_.set_halfedge_handle(OpenMesh::VertexHandle(start.origin(h).id), halfedge(h));
            }
        }
    }

    [[nodiscard]] FaceList faces() const {
        FaceList faces;
        for (const auto face : mesh_.faces()) {
            auto& corners = faces.emplace_back();
            std::size_t i = 0;
            for (const auto v : face.vertices())
                corners[i++] = v.idx();
        }
        return faces;
    }

protected:
    static OpenMesh::HalfedgeHandle halfedge(Halfedge h) { return OpenMesh::HalfedgeHandle(h.id); }

    /// The flip by OpenMesh's own navigation and setters, inline and without a check: the library's
    /// `flip` repeats `is_flip_ok` in an assertion that packaged builds may keep.
    void flip_inline(Edge e) {
        const auto h = halfedge(halfedge_of(e));
        const auto t = mesh_.opposite_halfedge_handle(h);
        const auto h1 = mesh_.next_halfedge_handle(h), h2 = mesh_.next_halfedge_handle(h1);
        const auto t1 = mesh_.next_halfedge_handle(t), t2 = mesh_.next_halfedge_handle(t1);
        const auto a = mesh_.to_vertex_handle(t), b = mesh_.to_vertex_handle(h);
        const auto f = mesh_.face_handle(h), g = mesh_.face_handle(t);
        mesh_.set_vertex_handle(h, mesh_.to_vertex_handle(h1));
        mesh_.set_vertex_handle(t, mesh_.to_vertex_handle(t1));
        mesh_.set_next_halfedge_handle(h, h2);
        mesh_.set_next_halfedge_handle(h2, t1);
        mesh_.set_next_halfedge_handle(t1, h);
        mesh_.set_next_halfedge_handle(t, t2);
        mesh_.set_next_halfedge_handle(t2, h1);
        mesh_.set_next_halfedge_handle(h1, t);
        mesh_.set_face_handle(t1, f);
        mesh_.set_face_handle(h1, g);
        mesh_.set_halfedge_handle(f, h);
        mesh_.set_halfedge_handle(g, t);
        if (mesh_.halfedge_handle(a) == h) mesh_.set_halfedge_handle(a, t1);
        if (mesh_.halfedge_handle(b) == t) mesh_.set_halfedge_handle(b, h1);
    }

    /// `is_flip_ok` of a closed mesh, inline and without an assertion.
    [[nodiscard]] bool keeps_simple(Edge e) const {
        const auto h = halfedge(halfedge_of(e));
        const auto c = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
        const auto d =
            mesh_.to_vertex_handle(mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h)));
        if (c == d) return false;
        for (auto neighbour = mesh_.cvv_iter(c); neighbour.is_valid(); ++neighbour) {
            if (*neighbour == d) return false;
        }
        return true;
    }

    Mesh mesh_;
};

struct OpenMeshUnchecked : OpenMeshKernel {
    static constexpr const char* name = "OpenMesh connectivity, inline, no check";
    using OpenMeshKernel::OpenMeshKernel;
    std::size_t flip_each(std::span<const Edge> edges) {
        for (const Edge e : edges)
            flip_inline(e);
        return edges.size();
    }
};

struct OpenMeshSimple : OpenMeshKernel {
    static constexpr const char* name = "OpenMesh, is_flip_ok and flip as packaged";
    using OpenMeshKernel::OpenMeshKernel;
    std::size_t flip_each(std::span<const Edge> edges) {
        std::size_t done = 0;
        for (const Edge e : edges) {
            const OpenMesh::EdgeHandle edge(e.id);
            if (!mesh_.is_flip_ok(edge)) continue;
            mesh_.flip(edge);
            ++done;
        }
        return done;
    }
};

struct OpenMeshSimpleInline : OpenMeshKernel {
    static constexpr const char* name = "OpenMesh connectivity, inline, neighbours walked";
    using OpenMeshKernel::OpenMeshKernel;
    std::size_t flip_each(std::span<const Edge> edges) {
        std::size_t done = 0;
        for (const Edge e : edges) {
            if (!keeps_simple(e)) continue;
            flip_inline(e);
            ++done;
        }
        return done;
    }
};

}  // namespace tightflip::kernel::bench
