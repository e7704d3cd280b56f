/// \file
/// The target criterion_text: text as a criterion.
#pragma once

#include <string>
#include <string_view>

namespace tightflip::fuzz {

/// What does not hold of a text read as a criterion for two small surfaces, a closed and a
/// functional one.
[[nodiscard]] std::string criterion_text_objection(std::string_view text);

}  // namespace tightflip::fuzz
