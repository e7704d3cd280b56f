/// \file
/// The target flip_path: bytes as two labelled spheres, a path between them, and what certifies it.
#pragma once

#include "bytes.hpp"
#include <tightflip/kernel/triangulation.hpp>

namespace tightflip::fuzz {

inline constexpr kernel::Index least_path_vertices = 4;
inline constexpr kernel::Index most_path_vertices = 40;

/// The vertices, three bytes an end; then three bytes a flip.
inline constexpr Layout path_layout{.head = 8, .record = 3, .most_records = 64};

/// Two spheres with equally many vertices.
struct PathCase {
    kernel::Triangulation from;
    kernel::Triangulation to;
    std::string words;  ///< one line: how they are made
};

/// The case that an input says (fuzz/README.md gives the layout).
[[nodiscard]] PathCase decode_path_case(Input input);

/// What does not hold of the pair; empty where all does: a path is constructed within its bound,
/// written, read and verified as a certificate; so is the shortened path, which is no longer; and,
/// of few vertices, a shortest one, which is no longer still.
[[nodiscard]] std::string path_objection(const PathCase& ends);

}  // namespace tightflip::fuzz
