/// \file
/// The target halfedge_table: a raw halfedge table, judged quickly, slowly and edge by edge.
#pragma once

#include "target.hpp"
#include <tightflip/kernel/surface_text.hpp>

namespace tightflip::fuzz {

inline constexpr std::size_t most_raw_halfedges = 120;

/// The table that the bytes say: fuzz/README.md gives the layout.
[[nodiscard]] kernel::RawTable decode_table(Input input);
/// The bytes of a table whose numbers the layout can say.
[[nodiscard]] InputBytes encode_table(const kernel::TableView& table);

/// What does not hold of a table.
[[nodiscard]] std::string table_objection(const kernel::RawTable& table);

}  // namespace tightflip::fuzz
