/// \file
/// The target canonical: canonical codes beside the plain comparison of all walks.
#pragma once

#include "target.hpp"
#include <tightflip/kernel/canonical.hpp>

#include <cstdint>

namespace tightflip::fuzz {

inline constexpr std::size_t most_canonical_flips = 16;

struct CanonicalCase {
    kernel::Triangulation surface;
    kernel::Triangulation other;  ///< some flips away
    std::uint64_t seed = 0;       ///< of the renumberings
};

/// The case that the bytes say: fuzz/README.md gives the layout.
[[nodiscard]] CanonicalCase decode_canonical(Input input);

/// How many roots of `b` spell the word that the first root of `a` spells: 0 where the two are not
/// isomorphic, else the order of the automorphism group.
[[nodiscard]] std::size_t isomorphisms_by_walks(const kernel::Triangulation& a,
                                                const kernel::Triangulation& b,
                                                kernel::Equality equality);

/// What does not hold of the codes of a case.
[[nodiscard]] std::string canonical_objection(const CanonicalCase& surfaces);

}  // namespace tightflip::fuzz
