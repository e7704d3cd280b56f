/// \file
/// The target flip_log: bytes as a flip log, in text or binary.
#pragma once

#include "target.hpp"

#include <string>
#include <string_view>

namespace tightflip::fuzz {

/// The bytes with the checksum that their content has, where they are so much like a log that they
/// have a place for one; else as they are. Otherwise nearly no changed log would be read.
[[nodiscard]] std::string with_right_checksum(std::string_view bytes);

/// What does not hold of bytes read as a log.
[[nodiscard]] std::string flip_log_objection(std::string_view bytes);

}  // namespace tightflip::fuzz
