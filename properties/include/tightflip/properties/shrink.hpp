/// \file
/// Makes a failing script short.
#pragma once

#include <tightflip/properties/finding.hpp>

#include <functional>
#include <span>

namespace tightflip::properties {

/// A subsequence of `script` that still fails and from which no single flip can be left out, found
/// by delta debugging (Zeller and Hildebrandt, IEEE TSE 28 (2002)): first the shortest failing
/// prefix by bisection, then ever smaller blocks are left out. Deterministic.
/// Precondition: `fails(script)`. Cost: O(n log n) calls on typical scripts, O(n^2) at worst, and
/// never more than `most_calls`; at that limit the shortest so far is returned.
[[nodiscard]] FlipScript shrink(FlipScript script,
                                const std::function<bool(std::span<const Edge>)>& fails,
                                std::size_t most_calls = 10'000);

}  // namespace tightflip::properties
