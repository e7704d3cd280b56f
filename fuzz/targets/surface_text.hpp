/// \file
/// The target surface_text: bytes as one of the project's own text formats.
#pragma once

#include <string>
#include <string_view>

namespace tightflip::fuzz {

/// What does not hold of a text read as tightflip-triangulation, -gluing or -surface.
[[nodiscard]] std::string surface_text_objection(std::string_view text);

}  // namespace tightflip::fuzz
