/// \file
/// An input's bytes, taken one by one.
#pragma once

#include <tightflip/kernel/handles.hpp>

#include <cstdint>
#include <span>

namespace tightflip::fuzz {

class Bytes {
public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

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
    std::span<const std::uint8_t> bytes_;
};

}  // namespace tightflip::fuzz
