/// \file
/// The paper's claims as callable checks. Unit tests, property tests, fuzz targets and the command
/// all call these; each returns the first finding, or nothing where the claim held.
#pragma once

#include <tightflip/properties/finding.hpp>

#include <optional>
#include <span>

namespace tightflip::properties {

/// Theorem 4.2: flips preserve the Euler characteristic, orientability, genus, V, E, F,
/// connectedness, looplessness, strong connectedness, the three-neighbour rule and the cycles of
/// faces about vertices. Every flip is checked in constant time, and the whole surface by an audit
/// after every `audit_every` attempts (0: never in between), quickly where nothing is wrong, and by
/// the whole ladder at the end.
[[nodiscard]] std::optional<Finding> topology_is_preserved(const Triangulation& start,
                                                           std::span<const Edge> script,
                                                           std::size_t audit_every = 1);

/// The kernel and the reference model, flipped alike, agree after every attempt: in whether the
/// flip is allowed, and in every handle of the surface. So what an audit finds of the one holds of
/// the other. Quadratic time; for small surfaces.
[[nodiscard]] std::optional<Finding> reference_model_agrees(const Triangulation& start,
                                                            std::span<const Edge> script);

/// The flip's group laws after each step of a script, bit for bit: unflip undoes flip and flip
/// undoes unflip, four flips of one edge are the identity, two exchange its halves; and in the end
/// the unflips in reverse order lead back to the start.
[[nodiscard]] std::optional<Finding> flip_laws_hold(const Triangulation& start,
                                                    std::span<const Edge> script);

/// Writing the script's log, reading it back and replaying it gives the directly flipped surface,
/// in both written forms, and a surface survives its own text format bit for bit.
[[nodiscard]] std::optional<Finding> log_reproduces_run(const Triangulation& start,
                                                        std::span<const Edge> script);

}  // namespace tightflip::properties
