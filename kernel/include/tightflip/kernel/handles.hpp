/// \file
/// Strong handle types: a vertex is not a halfedge is not an edge, and the compiler knows it.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace tightflip::kernel {

/// The integer behind every handle and every raw table entry.
using Index = std::int32_t;

/// A typed index; -1 where it names nothing.
template <class Tag>
struct Handle {
    Index id = -1;

    [[nodiscard]] constexpr bool is_valid() const noexcept { return id >= 0; }
    friend constexpr bool operator==(Handle, Handle) noexcept = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the ordering's 0 for a pointer
    friend constexpr std::strong_ordering operator<=>(Handle, Handle) noexcept = default;
};

/// A vertex: the label that a corner carries, 0 <= id < vertex count.
using Vertex = Handle<struct VertexTag>;
/// A directed side of a face (a dart, in theory text), 0 <= id < 2 * edge count.
using Halfedge = Handle<struct HalfedgeTag>;
/// An undirected edge; its halfedges are 2 * id and 2 * id + 1.
using Edge = Handle<struct EdgeTag>;

/// The halfedge on the other side of the same edge, in the opposite direction.
[[nodiscard]] constexpr Halfedge twin(Halfedge h) noexcept {
    return {h.id ^ 1};
}
/// The edge that `h` is a side of.
[[nodiscard]] constexpr Edge edge_of(Halfedge h) noexcept {
    return {h.id >> 1};
}
/// The even halfedge of `e`; the odd one is its twin.
[[nodiscard]] constexpr Halfedge halfedge_of(Edge e) noexcept {
    return {2 * e.id};
}

}  // namespace tightflip::kernel

template <class Tag>
struct std::hash<tightflip::kernel::Handle<Tag>> {
    std::size_t operator()(tightflip::kernel::Handle<Tag> handle) const noexcept {
        return std::hash<tightflip::kernel::Index>{}(handle.id);
    }
};
