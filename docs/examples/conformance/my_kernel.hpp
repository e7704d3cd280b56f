// The adaptor of docs/conformance.md.
#pragma once

#include "my_mesh.hpp"
#include <tightflip/properties/mesh_kernel.hpp>

namespace tightflip::properties {

struct MyKernel {
    static constexpr std::string_view name = "my mesh";
    static constexpr KernelClass allowed = KernelClass::simple;
    using Side = int;

    MyKernel(Index vertex_count, std::span<const std::array<Index, 3>> faces)
        : vertices(vertex_count), mesh({faces.begin(), faces.end()}) {}

    std::array<Index, 3> counts() const {
        const auto sides = static_cast<Index>(mesh.halfedges.size());
        return {vertices, sides / 2, sides / 3};
    }
    std::vector<Side> sides() const {
        std::vector<Side> all(mesh.halfedges.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<int>(i);
        return all;
    }
    Side next(Side s) const { return mesh.at(s).next; }
    Side across(Side s) const { return mesh.at(s).twin; }
    Index origin(Side s) const { return mesh.at(s).origin; }
    bool can_flip(Side s) const { return mesh.can_flip(s); }
    void flip(Side s) { mesh.flip(s); }
    bool is_valid() const { return mesh.is_valid(); }

    // If the mesh can be damaged on purpose, its validator is tested too.
    void set_origin(Side s, Index vertex) { mesh.at(s).origin = vertex; }
    void set_next(Side s, Side wrong) { mesh.at(s).next = wrong; }
    void set_across(Side s, Side wrong) { mesh.at(s).twin = wrong; }

    Index vertices;
    MyMesh mesh;
};

}  // namespace tightflip::properties
