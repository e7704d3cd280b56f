/// \file
/// Numbers as they stand in binary files of either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

namespace tightflip::geometry {

/// The number whose bytes stand at `offset`. Precondition: they all exist.
template <class T>
[[nodiscard]] T load(std::string_view bytes, std::size_t offset, std::endian order) noexcept {
    std::array<char, sizeof(T)> raw;
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw.begin());
    if (order != std::endian::native) std::ranges::reverse(raw);
    return std::bit_cast<T>(raw);
}

/// Adds the bytes of a number, lowest first.
template <class T>
void append_little_endian(std::string& bytes, T number) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
    if (std::endian::native != std::endian::little) std::ranges::reverse(raw);
    bytes.append(raw.begin(), raw.end());
}

}  // namespace tightflip::geometry
