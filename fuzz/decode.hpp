/// \file
/// Bytes as a start and a flip script. Every byte string is a valid case; fuzz/README.md gives the
/// layout.
#pragma once

#include "bytes.hpp"
#include <tightflip/properties/flip_case.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace tightflip::fuzz {

/// Bounds that keep a run near a millisecond under the sanitizers.
inline constexpr kernel::Index most_spare_vertices = 8;  ///< beyond the least of the kind
inline constexpr kernel::Index most_genus = 3;
inline constexpr std::size_t most_flips = 32;

/// The start that the next four bytes say, with no flips yet.
[[nodiscard]] properties::FlipCase decode_start(Bytes& bytes);

/// The case that the bytes say; missing ones count as 0, and those after the last flip are ignored.
[[nodiscard]] properties::FlipCase decode(std::span<const std::uint8_t> data);

}  // namespace tightflip::fuzz
