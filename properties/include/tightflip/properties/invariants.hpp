/// \file
/// What every flip must keep, as callable checks: the numbers of Theorem 4.2 against a start, and
/// the flip's own definition in constant time.
#pragma once

#include <tightflip/properties/finding.hpp>

#include <optional>

namespace tightflip::properties {

/// The 90x violations: which numbers of `now` are not those of `start`.
[[nodiscard]] std::vector<Violation> changes(const Topology& start, const Topology& now);

/// The first violation of the full audit of `surface`, or else the first change against `start`.
/// Climbs the whole ladder, counting everything anew from a gluing. Linear time.
[[nodiscard]] std::optional<Violation> first_violation(const Triangulation& surface,
                                                       const Topology& start);
/// The same answer several times faster where nothing is wrong: the quick judge's yes, from which
/// the numbers follow, is taken for granted; only without it the ladder is climbed.
[[nodiscard]] std::optional<Violation> first_violation_quickly(const Triangulation& surface,
                                                               const Topology& start);

/// What one flip did, and what the constant-time checks found.
struct CheckedFlip {
    bool done = false;
    std::optional<ViolationCode> code;
};

/// Flips under the constant-time checks: a refusal is justified, the new faces are the ones that
/// the definition names, and `audit_at_edge` finds nothing.
[[nodiscard]] CheckedFlip checked_flip(Triangulation& surface, Edge e);

/// The violation behind a code that `checked_flip` has just returned, with its details. Linear
/// time.
[[nodiscard]] Violation explain(const Triangulation& surface, Edge e, ViolationCode code);

}  // namespace tightflip::properties
