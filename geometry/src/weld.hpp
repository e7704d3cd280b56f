/// \file
/// One vertex for points that are near each other.
#pragma once

#include <tightflip/geometry/triangle_soup.hpp>

namespace tightflip::geometry {

/// Each point in turn goes to the first earlier point that was kept and is no further away than
/// `distance`. Points that are kept keep their order and position; -0 becomes 0. Precondition:
/// 0 <= distance, finite.
void weld(TriangleSoup& soup, double distance);

}  // namespace tightflip::geometry
