/// \file
/// Bytes as a start and a flip script, and back. Every byte string is a valid case; fuzz/README.md
/// gives the layout.
#pragma once

#include "bytes.hpp"
#include <tightflip/properties/flip_case.hpp>

#include <initializer_list>

namespace tightflip::fuzz {

/// Bounds that keep a run short under the sanitizers.
inline constexpr kernel::Index most_spare_vertices = 8;  ///< beyond the least of the kind
inline constexpr kernel::Index most_genus = 3;
inline constexpr std::size_t most_flips = 32;
inline constexpr std::uint32_t start_seeds = 16;  ///< of a kind, size and genus

/// The version and the four bytes of a start; then two bytes a flip.
inline constexpr Layout script_layout{.head = 5, .record = 2, .most_records = most_flips};

/// The start that the next four bytes say, with no flips yet.
[[nodiscard]] properties::FlipCase decode_start(Bytes& bytes);

/// The case that an input says.
[[nodiscard]] properties::FlipCase decode_script(Input input);

/// The start of a case that `decode_start` or `decode_script` gave. Made once and kept: making it
/// costs as much as all claims of a script do, and there are no more than some thousands.
[[nodiscard]] const properties::Triangulation& start_of(const properties::FlipCase& flip_case);

/// The case's script on its start.
[[nodiscard]] properties::FlipScript script_of(const properties::FlipCase& flip_case);

/// A start as seeds name it.
struct StartBytes {
    std::string_view kind;  ///< a name in `start_kinds()`
    std::uint8_t spare = 0;
    std::uint8_t genus = 0;
    std::uint8_t seed = 0;
};

/// The input that says this start and, in two bytes each, these flips. Throws std::invalid_argument
/// where there is no such kind.
[[nodiscard]] InputBytes script_input(const StartBytes& start,
                                      std::span<const std::uint32_t> picks = {});
[[nodiscard]] InputBytes script_input(const StartBytes& start,
                                      std::initializer_list<std::uint32_t> picks);

}  // namespace tightflip::fuzz
