/// \file
/// Writes words and numbers as the formats have them, whatever a stream's locale and flags say.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <ostream>
#include <string>
#include <string_view>

namespace tightflip::kernel {

/// Unformatted output to a stream: a stream's own `<<` would group digits where its locale does,
/// and heed a base and a width that were set for something else.
class PlainWriter {
public:
    explicit PlainWriter(std::ostream& out) : out_(out) {}

    PlainWriter& operator<<(std::string_view text) {
        out_.write(text.data(), static_cast<std::streamsize>(text.size()));
        return *this;
    }
    PlainWriter& operator<<(char c) { return *this << std::string_view(&c, 1); }
    template <std::integral T>
    PlainWriter& operator<<(T number) {
        return *this << std::string_view(std::to_string(number));
    }
    /// The shortest digits that read back as the same number.
    template <std::floating_point T>
    PlainWriter& operator<<(T number) {
        std::array<char, 32> digits;
        const auto [end, error] = std::to_chars(digits.begin(), digits.end(), number);
        return *this << std::string_view(digits.data(),
                                         static_cast<std::size_t>(end - digits.begin()));
    }

private:
    std::ostream& out_;
};

}  // namespace tightflip::kernel
