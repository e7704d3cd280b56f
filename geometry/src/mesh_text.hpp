/// \file
/// What the text forms of the mesh formats share.
#pragma once

#include <tightflip/kernel/text_cursor.hpp>

#include <string>
#include <string_view>

namespace tightflip::geometry {

using kernel::LineSyntax;
using kernel::quoted;
using kernel::TextCursor;

/// The lines of PLY and STL, which have no comments.
constexpr LineSyntax bare_lines{.comment = '\0', .plus_signs = true};
/// The lines of OFF.
constexpr LineSyntax commented_lines{.comment = '#', .plus_signs = true};
/// The lines of OBJ.
constexpr LineSyntax continued_lines{.comment = '#', .continued_lines = true, .plus_signs = true};

/// A text in lower case (ASCII letters alone, whatever the locale).
[[nodiscard]] std::string lowered(std::string_view text);

}  // namespace tightflip::geometry
