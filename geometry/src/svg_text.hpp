/// \file
/// The small part of SVG that drawings are written in.
#pragma once

#include <string>
#include <string_view>

namespace tightflip::geometry {

/// Appends a number of pixels in hundredths: 12, 3.5, -0.07. What is no number becomes 0, and what
/// is far outside of any picture a million.
void append_pixels(std::string& text, double value);
/// " x y", but for the first blank where the text does not end in a digit.
void append_place(std::string& text, double x, double y);
/// ` name="12.5"`.
void append_attribute(std::string& text, std::string_view name, double pixels);

/// A text as XML allows it: its marks escaped; control characters, and bytes that are no UTF-8,
/// become '?'.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace tightflip::geometry
