/// \file
/// What a fuzz target offers to the two programs made of it: libFuzzer's and the replayer.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>

namespace tightflip::fuzz {

/// What does not hold of an input, in words; empty where everything does. Takes any bytes.
[[nodiscard]] std::string objection(std::span<const std::uint8_t> data);

/// The input that the bytes say, in words, in lines.
void show(std::ostream& out, std::span<const std::uint8_t> data);

}  // namespace tightflip::fuzz
