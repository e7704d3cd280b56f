/// \file
/// The target point_file: bytes as any file that holds points.
#pragma once

#include <string>
#include <string_view>

namespace tightflip::fuzz {

/// What does not hold of bytes read as points; the name lends its extension.
[[nodiscard]] std::string point_file_objection(std::string_view bytes, const std::string& name);

}  // namespace tightflip::fuzz
