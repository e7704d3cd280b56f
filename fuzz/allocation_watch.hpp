/// \file
/// The largest single allocation while something is read. A program that links this has its
/// `operator new` replaced by one that watches.
#pragma once

#include <cstddef>
#include <string>

namespace tightflip::fuzz {

class AllocationWatch {
public:
    /// Starts anew; one watch at a time on a thread.
    AllocationWatch();
    /// The largest allocation on this thread since the start.
    [[nodiscard]] std::size_t largest() const;
    /// Where that is more than `bytes` of input can be worth: what was asked for, in words.
    [[nodiscard]] std::string objection(std::size_t bytes) const;

    /// A reader may ask at once for so much a byte, and for so much in any case (streams, blocks).
    static constexpr std::size_t most_a_byte = 64;
    static constexpr std::size_t most_in_any_case = std::size_t{1} << 17U;
};

}  // namespace tightflip::fuzz
