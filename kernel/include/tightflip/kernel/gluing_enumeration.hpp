/// \file
/// All surfaces of a size, by gluing triangles side by side: an enumeration that knows no flip.
#pragma once

#include <tightflip/kernel/halfedge_table.hpp>

#include <cstdint>
#include <functional>

namespace tightflip::kernel {

/// Called with a surface whose root is halfedge 0; returning false ends the enumeration. The table
/// is valid during the call.
using GluingVisitor = std::function<bool(HalfedgeTable)>;

/// Visits every rooted loopless triangulation with so many vertices of the orientable surface of
/// that genus exactly once, in an order that is always the same; returns how many were visited.
/// (A surface without symmetries has as many rooted ones as halfedges; numbers of vertices and
/// edges are as `decode` gives them.)
///
/// The sides of faces are glued in the order of the rooted walk (rooted_code.hpp), each to a new
/// face or to a later open side. Given up early are loops, a handle too many, more complete
/// vertices than asked for, and boundaries of odd length that the remaining faces cannot close.
/// Time grows exponentially: see `largest_quick_enumeration`. Throws std::invalid_argument for
/// sizes that no surface has (V < 3, negative genus), and for more than 62 faces.
std::uint64_t enumerate_gluings(Index vertices, Index genus, const GluingVisitor& visit);

/// The largest number of vertices for which the enumeration of this genus takes about ten seconds
/// at most; 0 where not even three vertices do. Measured on one core of 2023, release build:
///
/// | genus | V  | rooted surfaces | seconds | one vertex less |
/// |-------|----|-----------------|---------|-----------------|
/// | 0     | 11 | 12,629,760      | 9       | 1               |
/// | 1     | 8  | 10,108,233      | 7       | 0.4             |
/// | 2     | 6  | 8,994,072       | 9       | 0.3             |
/// | 3     | 4  | 256,112         | 3       | 0.1             |
/// | 4     | 3  | 8,064           | 23      | -               |
[[nodiscard]] Index largest_quick_enumeration(Index genus) noexcept;

}  // namespace tightflip::kernel
