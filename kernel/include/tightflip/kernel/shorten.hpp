/// \file
/// Shorter flip logs between the same two surfaces, by the relations that flips obey.
#pragma once

#include <tightflip/kernel/flip_log.hpp>

namespace tightflip::kernel {

struct ShortenOptions {
    /// Passes over the log at most; fewer where one finds nothing more. Each takes time linear in
    /// the flips.
    int most_passes = 4;
};

/// A log with the same start whose end is the same labelled surface (the numbers of edges may
/// differ), never longer. It uses the relations of the flip's two-dimensional faces:
///
/// - square: flips of edges that share no face commute. So two flips of one edge with no flip of a
///   side of its quadrilateral between them cancel: they only exchange the edge's halves.
/// - pentagon: where e and f share one face, the flips e, f, e of the two diagonals in the pentagon
///   about them, no side of it flipped in between, lead where f, e lead, but for the names of e
///   and f, which change places in all that follows.
///
/// Greedy, without a promise of how much is found; a log without such patterns comes back as it is.
/// Memory: about 12 bytes a flip and 20 an edge beside the surface.
///
/// Throws std::invalid_argument where the log does not replay, std::length_error for more than
/// 2^31 - 1 flips.
[[nodiscard]] FlipLog shorten(FlipLog log, const ShortenOptions& options = {});

}  // namespace tightflip::kernel
