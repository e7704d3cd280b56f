/// \file
/// The plain table under a Triangulation: two words a halfedge, 48 bytes a vertex on the sphere.
///
/// `twin` is implicit (h xor 1). `next` is a permutation whose cycles are the faces; `origin`
/// names the vertex a halfedge leaves. Nothing here owns memory or checks anything: the functions
/// work on spans of any origin, in constant expressions too.
#pragma once

#include <tightflip/kernel/handles.hpp>

#include <span>

namespace tightflip::kernel {

/// What is stored for one halfedge.
struct HalfedgeRecord {
    Halfedge next;  ///< the following side of the same face, in the direction of the face
    Vertex origin;  ///< the vertex it leaves

    friend constexpr bool operator==(HalfedgeRecord, HalfedgeRecord) noexcept = default;
};

using HalfedgeTable = std::span<const HalfedgeRecord>;
using MutableHalfedgeTable = std::span<HalfedgeRecord>;

/// Unchecked navigation on a table whose entries are in range; each is one read.
[[nodiscard]] constexpr const HalfedgeRecord& at(HalfedgeTable table, Halfedge h) noexcept {
    return table[static_cast<std::size_t>(h.id)];
}
[[nodiscard]] constexpr HalfedgeRecord& at(MutableHalfedgeTable table, Halfedge h) noexcept {
    return table[static_cast<std::size_t>(h.id)];
}

}  // namespace tightflip::kernel
