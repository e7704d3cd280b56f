/// \file
/// Theorem 4.3 and what follows from it, as callable checks in the manner of claims.hpp.
#pragma once

#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/finding.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace tightflip::properties {

/// Of a path of anybody's making: it starts from the table of `from`; every flip of it is done and
/// keeps the topology; and after at most `most` flips it ends in exactly the labelled surface `to`.
/// The finding's step is the flip after which something went wrong, or how many were done. Linear
/// time.
[[nodiscard]] std::optional<Finding> path_leads_to(const kernel::FlipLog& path,
                                                   const Triangulation& from,
                                                   const Triangulation& to, std::int64_t most);

/// Theorem 4.3, of two labelled spheres with V vertices each: `connect` finds a path of at most
/// `connect_bound(V)` flips that leads from the one to the other, as `path_leads_to` has it.
/// O(V log V) time.
[[nodiscard]] std::optional<Finding> any_two_spheres_connect(const Triangulation& from,
                                                             const Triangulation& to);

/// Shortening the flips that a script does gives a log from the same start, no longer, all of whose
/// flips are done, to the same labelled surface.
[[nodiscard]] std::optional<Finding> shortening_keeps_the_ends(const Triangulation& start,
                                                               std::span<const Edge> script);

}  // namespace tightflip::properties
