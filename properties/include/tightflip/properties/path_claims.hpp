/// \file
/// Theorem 4.3 and what follows from it, as callable checks in the manner of claims.hpp.
#pragma once

#include <tightflip/properties/finding.hpp>

#include <optional>
#include <span>

namespace tightflip::properties {

/// Theorem 4.3, of two labelled spheres with V vertices each: `connect` finds a path of at most
/// `connect_bound(V)` flips from the table of `from`; every flip of it is done and keeps the
/// topology; and it ends in exactly the labelled surface `to`. The finding's step is the flip after
/// which something went wrong, or the path's length. O(V log V) time.
[[nodiscard]] std::optional<Finding> any_two_spheres_connect(const Triangulation& from,
                                                             const Triangulation& to);

/// Shortening the flips that a script does gives a log from the same start, no longer, all of whose
/// flips are done, to the same labelled surface.
[[nodiscard]] std::optional<Finding> shortening_keeps_the_ends(const Triangulation& start,
                                                               std::span<const Edge> script);

}  // namespace tightflip::properties
