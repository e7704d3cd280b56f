/// \file
/// Four points to begin with.
#pragma once

#include <tightflip/geometry/data_refusal.hpp>
#include <tightflip/geometry/surface.hpp>

#include <array>
#include <vector>

namespace tightflip::geometry {

/// Four of the points of these labels, in lexicographic order, that do not lie in one plane; far
/// apart as far as roundings can tell. The fourth lies on the negative side of the first three.
/// Linear time. Otherwise collinear_points or coplanar_points.
[[nodiscard]] DataFault choose_simplex(Points points, const std::vector<Index>& labels,
                                       std::array<Index, 4>& corners);

}  // namespace tightflip::geometry
