/// \file
/// Pictures as PNG, by librsvg's converter.
#pragma once

#include <string>

namespace tightflip::tools {

/// The bytes of the PNG that `rsvg-convert` makes of an SVG. Throws kernel::FileError where that
/// program is not installed, saying so and how to mend it, or where it fails. Titles and legends
/// are drawn in the fonts that are installed.
[[nodiscard]] std::string png_of(const std::string& svg);

}  // namespace tightflip::tools
