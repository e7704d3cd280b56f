/// \file
/// Equality of labelled surfaces: the numbers of halfedges and the order of faces do not matter.
/// (Equality of tables, where they do, is `operator==`.)
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <cstdint>

namespace tightflip::kernel {

/// Whether an isomorphism that keeps orientation and every vertex label joins the two. A mirror
/// image is another surface. O(n log n) time; on surfaces of large genus with few vertices a
/// factor more, the multiplicity of the least parallel edge.
[[nodiscard]] bool same_labelled_surface(const Triangulation& a, const Triangulation& b);

/// A hash consistent with `same_labelled_surface`; linear time.
[[nodiscard]] std::uint64_t surface_hash(const Triangulation& surface) noexcept;

}  // namespace tightflip::kernel
