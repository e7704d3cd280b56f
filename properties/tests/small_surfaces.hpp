/// \file
/// Small surfaces for the tests that the families do not have: closed but not orientable, or
/// orientable but listed with some faces turned over.
#pragma once

#include <tightflip/kernel/build.hpp>

#include <stdexcept>
#include <utility>
#include <vector>

namespace tightflip::properties::testing {

using kernel::Gluing;
using kernel::Index;
using kernel::SideGluing;

[[nodiscard]] inline Gluing glued(const std::vector<std::array<Index, 3>>& faces, Index vertices) {
    kernel::FaceListReading reading = kernel::glue_faces(faces, vertices);
    if (!reading.violations.empty()) throw std::logic_error("the face list is ambiguous");
    return std::move(reading.gluing);
}

/// Half an icosahedron: 6 vertices, every two of them joined.
[[nodiscard]] inline Gluing projective_plane() {
    std::vector<std::array<Index, 3>> faces;
    for (Index i = 0; i < 5; ++i) {
        const auto rim = [i](Index k) { return 1 + (i + k) % 5; };
        faces.push_back({0, rim(0), rim(1)});
        faces.push_back({rim(0), rim(3), rim(1)});
    }
    return glued(faces, 6);
}

/// A grid of 4 by 3 squares; columns close straight, rows close mirrored.
[[nodiscard]] inline Gluing klein_bottle() {
    constexpr Index columns = 4;
    constexpr Index rows = 3;
    const auto at = [](Index x, Index y) {
        x %= columns;
        return y < rows ? columns * y + x : (columns - x) % columns;
    };
    std::vector<std::array<Index, 3>> faces;
    for (Index y = 0; y < rows; ++y) {
        for (Index x = 0; x < columns; ++x) {
            faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    }
    return glued(faces, columns * rows);
}

/// The same surface, with the faces for which `chosen(face)` holds listed backwards.
template <class Chosen>
[[nodiscard]] Gluing turned_over(const Gluing& gluing, Chosen&& chosen) {
    const auto moved = [&](Index side) {
        return chosen(side / 3) ? 3 * (side / 3) + 2 - side % 3 : side;
    };
    Gluing turned = gluing;
    for (Index f = 0; f < static_cast<Index>(gluing.faces.size()); ++f) {
        const kernel::GluedFace& old = gluing.faces[static_cast<std::size_t>(f)];
        kernel::GluedFace& face = turned.faces[static_cast<std::size_t>(f)];
        if (chosen(f)) std::swap(face.corners[1], face.corners[2]);
        for (std::size_t i = 0; i < 3; ++i) {
            const Index other = old.sides[i].side();
            const bool reversed = old.sides[i].is_reversed() != (chosen(f) != chosen(other / 3));
            face.sides[static_cast<std::size_t>(moved(3 * f + static_cast<Index>(i)) % 3)] =
                reversed ? SideGluing::reversed(moved(other)) : SideGluing::coherent(moved(other));
        }
    }
    return turned;
}

}  // namespace tightflip::properties::testing
