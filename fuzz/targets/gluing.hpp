/// \file
/// The target gluing: a raw gluing table, judged by the audit and by everybody who relies on it.
#pragma once

#include "target.hpp"
#include <tightflip/kernel/gluing.hpp>

namespace tightflip::fuzz {

inline constexpr std::size_t most_glued_faces = 42;  ///< whose sides a byte can name
inline constexpr kernel::Index most_gluing_vertices = 254;

/// The gluing that the bytes say: fuzz/README.md gives the layout.
[[nodiscard]] kernel::Gluing decode_gluing(Input input);
/// The bytes of a gluing whose numbers the layout can say.
[[nodiscard]] InputBytes encode_gluing(const kernel::Gluing& gluing);

/// The same surface, or the same mess: faces and vertices in another order, some faces turned over,
/// corners numbered from another one on.
[[nodiscard]] kernel::Gluing rearranged(const kernel::Gluing& gluing, std::uint64_t seed);

/// What a gluing is, found out by putting things into heaps: no traversal, nothing kept in order.
struct HeapJudgement {
    bool is_allowed = false;  ///< Definition 4.1 holds
    /// Where it does: V - E + F.
    kernel::Index euler_characteristic = 0;
};
[[nodiscard]] HeapJudgement judge_by_heaps(const kernel::Gluing& gluing);

/// What does not hold of a gluing.
[[nodiscard]] std::string gluing_objection(const kernel::Gluing& gluing);

}  // namespace tightflip::fuzz
