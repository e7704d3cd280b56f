/// \file
/// An input's bytes, taken one by one; and put together, for seeds.
#pragma once

#include "target.hpp"
#include <tightflip/kernel/handles.hpp>

namespace tightflip::fuzz {

/// Reads on from where it stands; what is missing counts as 0.
class Bytes {
public:
    explicit Bytes(Input bytes) : bytes_(bytes) {}
    /// The bytes behind the version.
    static Bytes after_version(Input input) { return Bytes(input.subspan(input.empty() ? 0 : 1)); }

    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    /// The next byte; 0 where there is none.
    std::uint32_t byte() {
        if (bytes_.empty()) return 0;
        const std::uint8_t value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value;
    }
    /// Two bytes, the low one first.
    std::uint32_t pair() {
        const std::uint32_t low = byte();
        return low + 256 * byte();
    }
    kernel::Index below(kernel::Index bound) { return static_cast<kernel::Index>(byte()) % bound; }

private:
    Input bytes_;
};

/// An input of this version, with these bytes behind it.
[[nodiscard]] inline InputBytes with_version(Input bytes) {
    InputBytes input{format_version};
    input.insert(input.end(), bytes.begin(), bytes.end());
    return input;
}

/// Two bytes, the low one first.
inline void append_pair(InputBytes& input, std::uint32_t value) {
    input.push_back(static_cast<std::uint8_t>(value & 0xffU));
    input.push_back(static_cast<std::uint8_t>((value >> 8U) & 0xffU));
}

}  // namespace tightflip::fuzz
