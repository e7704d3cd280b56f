/// \file
/// The target flip_path: bytes as two labelled spheres, a path between them, and what certifies it.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace tightflip::fuzz {

inline constexpr kernel::Index least_path_vertices = 4;
inline constexpr kernel::Index most_path_vertices = 40;
inline constexpr std::size_t most_flips_an_end = 32;

/// Two spheres with equally many vertices.
struct PathCase {
    kernel::Triangulation from;
    kernel::Triangulation to;
    std::string words;  ///< one line: how they are made
};

/// The case that the bytes say (fuzz/README.md gives the layout); missing ones count as 0, and
/// those after the last flip are ignored.
[[nodiscard]] PathCase decode_path_case(std::span<const std::uint8_t> data);

/// What does not hold of the pair; empty where all does: a path is constructed within its bound,
/// written, read and verified as a certificate; so is the shortened path, which is no longer; and,
/// of few vertices, a shortest one, which is no longer still.
[[nodiscard]] std::string path_objection(const PathCase& ends);

}  // namespace tightflip::fuzz
