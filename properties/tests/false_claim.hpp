/// \file
/// A claim that does not hold, for tests of what is made of failing cases.
#pragma once

#include <tightflip/properties/finding.hpp>

#include <algorithm>
#include <optional>
#include <span>

namespace tightflip::properties {

/// Does not hold: no script flips edge 3 and later edge 1.
inline std::optional<Finding> never_three_then_one(const Triangulation& /*start*/,
                                                   std::span<const Edge> script) {
    const auto three = std::ranges::find(script, Edge{3});
    const auto one = std::find(three, script.end(), Edge{1});
    if (one == script.end()) return std::nullopt;
    return Finding{static_cast<std::size_t>(one - script.begin()) + 1,
                   {.code = ViolationCode::flip_law_broken}};
}

}  // namespace tightflip::properties
