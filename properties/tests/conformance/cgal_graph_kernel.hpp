/// \file
/// Any mesh that models CGAL's halfedge graphs, flipped with CGAL's Euler operation. Assertions are
/// off, as in released programs, whatever the build: what a program meets is what is looked for.
#pragma once

#ifndef CGAL_NDEBUG
#define CGAL_NDEBUG
#endif

#include <tightflip/properties/mesh_kernel.hpp>

#include <map>
#include <stdexcept>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

namespace tightflip::properties {

using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;

namespace detail {  // free functions, found beside the mesh's type, that the kernel's members hide
template <class Mesh, class Side>
Side next_in(const Mesh& mesh, Side s) {
    return next(s, mesh);
}
template <class Mesh, class Side>
void set_next_in(Mesh& mesh, Side s, Side wrong) {
    set_next(s, wrong, mesh);
}
}  // namespace detail

template <class Mesh>
struct CgalGraphKernel {
    using Traits = boost::graph_traits<Mesh>;
    using Side = typename Traits::halfedge_descriptor;
    using MeshVertex = typename Traits::vertex_descriptor;

    CgalGraphKernel(Index vertex_count, std::span<const std::array<Index, 3>> faces) {
        for (Index v = 0; v < vertex_count; ++v) {
            vertices.push_back(add_vertex(mesh));
            numbers[vertices.back()] = v;
        }
        for (const auto& [a, b, c] : faces) {
            const std::array<MeshVertex, 3> corners{at(a), at(b), at(c)};
            if (CGAL::Euler::add_face(corners, mesh) == Traits::null_face()) {
                throw std::invalid_argument("add_face refuses a face");
            }
        }
    }
    // Copies of a mesh would have vertices of their own.
    CgalGraphKernel(const CgalGraphKernel&) = delete;
    CgalGraphKernel& operator=(const CgalGraphKernel&) = delete;

    [[nodiscard]] std::array<Index, 3> counts() const {
        return {static_cast<Index>(num_vertices(mesh)), static_cast<Index>(num_edges(mesh)),
                static_cast<Index>(num_faces(mesh))};
    }
    [[nodiscard]] std::vector<Side> sides() const {
        const auto all = halfedges(mesh);
        return {all.begin(), all.end()};
    }
    [[nodiscard]] Side next(Side s) const { return detail::next_in(mesh, s); }
    [[nodiscard]] Side across(Side s) const { return opposite(s, mesh); }
    [[nodiscard]] Index origin(Side s) const { return numbers.at(source(s, mesh)); }
    // The documented precondition: both sides of the edge belong to triangles.
    [[nodiscard]] bool can_flip(Side s) const {
        return !CGAL::is_border_edge(s, mesh) && CGAL::is_triangle(s, mesh) &&
               CGAL::is_triangle(opposite(s, mesh), mesh);
    }
    void flip(Side s) { CGAL::Euler::flip_edge(s, mesh); }

    void set_origin(Side s, Index v) { set_target(opposite(s, mesh), at(v), mesh); }
    void set_next(Side s, Side wrong) { detail::set_next_in(mesh, s, wrong); }

    Mesh mesh;
    std::vector<MeshVertex> vertices;
    std::map<MeshVertex, Index> numbers;

private:
    [[nodiscard]] MeshVertex at(Index v) const { return vertices.at(static_cast<std::size_t>(v)); }
};

}  // namespace tightflip::properties
