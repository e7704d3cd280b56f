/// \file
/// The order in which to paint polygons so that near ones cover far ones.
#pragma once

#include "projection.hpp"

#include <vector>

namespace tightflip::geometry {

/// The pieces from far to near, cut where no order of whole ones will do (binary space partition).
/// Of pieces that lie on each other, inner sides of faces come first. Those seen from the side or
/// of no area are left out. There are at most `most_pieces` or as many as were given: beyond,
/// nothing more is cut, and the order is one of depths.
[[nodiscard]] std::vector<Piece> painter_order(std::vector<Piece> pieces, std::size_t most_pieces);

}  // namespace tightflip::geometry
