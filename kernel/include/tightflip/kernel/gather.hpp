/// \file
/// Gathering a surface at a vertex: flips after which every face contains it.
#pragma once

#include <tightflip/kernel/flip_log.hpp>

namespace tightflip::kernel {

/// Flips after which every face contains `hub`, on a surface of any genus: exactly
/// F - (the hub's degree) of them, linear time.
///
/// A face that contains the hub but whose neighbour across the side opposite the hub does not can
/// have that side flipped: the new edge ends at the hub, so the hub's degree rises by one. No flip
/// takes the hub from a face; so one turn about the hub sees every such side, and where none is
/// left the faces at the hub are closed under neighbourhood and hence all there are. Then the
/// degree is F, for a face has three distinct corners.
///
/// Throws std::out_of_range for a vertex that does not exist.
[[nodiscard]] FlipLog gather_at(const Triangulation& surface, Vertex hub);

}  // namespace tightflip::kernel
