/// \file
/// The target flip_script: a decoded case under every claim about flips.
#pragma once

#include <tightflip/properties/flip_case.hpp>

#include <optional>
#include <string_view>

namespace tightflip::fuzz {

struct BrokenClaim {
    std::string_view claim;
    properties::Finding finding;
};

/// The first claim that does not hold of the case, or nothing.
[[nodiscard]] std::optional<BrokenClaim> first_broken_claim(const kernel::FlipLog& log);

}  // namespace tightflip::fuzz
