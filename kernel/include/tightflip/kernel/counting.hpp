/// \file
/// How many triangulations of the sphere there are: closed formulas, independent of any flip.
#pragma once

#include <tightflip/kernel/handles.hpp>

#include <cstdint>
#include <optional>

namespace tightflip::kernel {

/// Rooted triangulations of the sphere with V >= 3 vertices, one for each surface and each choice
/// of a halfedge, up to isomorphisms that keep orientation. Empty where the number exceeds 64 bits.
///
/// Loopless, parallel edges allowed: OEIS A000309(k) = 2^k (3k)! / ((k + 1)! (2k + 1)!), k = V - 2
/// (Mullin, Canad. J. Math. 17 (1965)).
[[nodiscard]] std::optional<std::uint64_t> rooted_spheres(Index vertices) noexcept;
/// Simple graphs: OEIS A000256, 2 (4n + 1)! / ((n + 1)! (3n + 2)!) with n = V - 3 (Tutte,
/// Canad. J. Math. 14 (1962)).
[[nodiscard]] std::optional<std::uint64_t> rooted_simple_spheres(Index vertices) noexcept;

/// V!, empty beyond 64 bits.
[[nodiscard]] std::optional<std::uint64_t> factorial(Index vertices) noexcept;

/// The labelled surfaces behind `rooted` rooted ones with `halfedges` halfedges, where no symmetry
/// fixes all labels (the sphere with V >= 4): rooted * V! / halfedges, exact or empty.
[[nodiscard]] std::optional<std::uint64_t> labelled_from_rooted(std::uint64_t rooted,
                                                                Index vertices,
                                                                Index halfedges) noexcept;

}  // namespace tightflip::kernel
