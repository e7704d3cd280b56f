/// \file
/// New inputs from old ones, record by record. The same arguments give the same input.
#pragma once

#include "target.hpp"

namespace tightflip::fuzz {

/// A fuzzer's own mutation: changes `size` bytes in place into at most `most` and returns how many.
using ByteMutator = std::size_t (*)(std::uint8_t* data, std::size_t size, std::size_t most);

/// An input like this one. Records are put in, left out, doubled, exchanged or changed, or a byte
/// of the head is; now and then the fuzzer's own mutation does as it likes, where there is one. The
/// result is of this version, with its whole head, whole records and not too many of these, as far
/// as `most_bytes` go. Text is left to the fuzzer.
[[nodiscard]] InputBytes mutate(const Layout& layout, Input input, std::size_t most_bytes,
                                std::uint64_t seed, ByteMutator mutate_bytes = nullptr);

/// The first records of one input and the last of another, behind the head of either; in the same
/// form. Empty for text, which is left to the fuzzer.
[[nodiscard]] InputBytes cross_over(const Layout& layout, Input first, Input second,
                                    std::size_t most_bytes, std::uint64_t seed);

}  // namespace tightflip::fuzz
