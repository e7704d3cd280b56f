#include <tightflip/kernel/text_cursor.hpp>

#include <algorithm>
#include <charconv>

namespace tightflip::kernel {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

/// A word fit for an error message, whatever bytes a broken file holds.
std::string quoted(std::string_view word) {
    constexpr std::size_t most = 40;
    std::string text = "'";
    for (const char c : word.substr(0, most))
        text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > most ? "...'" : "'");
}

}  // namespace

bool TextCursor::next_line() {
    while (!text_.empty()) {
        const auto end = std::min(text_.find('\n'), text_.size());
        rest_ = text_.substr(0, end);
        text_.remove_prefix(std::min(end + 1, text_.size()));
        ++line_;
        rest_ = rest_.substr(0, rest_.find('#'));
        if (rest_.find_first_not_of(blanks) != std::string_view::npos) return true;
    }
    rest_ = {};
    return false;
}

void TextCursor::require_line(std::string_view expected) {
    if (!next_line()) {
        fail("the file ends where " + std::string(expected) + " should follow; it is truncated");
    }
}

std::string_view TextCursor::word() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
    rest_.remove_prefix(word.size());
    return word;
}

void TextCursor::require_word(std::string_view expected) {
    const std::string_view found = word();
    if (found != expected) {
        fail(quoted(expected) + " should stand here, not " + quoted(found));
    }
}

std::int64_t TextCursor::integer(std::string_view what, std::int64_t low, std::int64_t high) {
    const std::string_view text = word();
    if (text.empty()) fail("the line ends where " + std::string(what) + " should follow");
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
        fail(quoted(text) + " is no whole number; " + std::string(what) + " should stand here");
    }
    if (error == std::errc::result_out_of_range || value < low || value > high) {
        fail(std::string(what) + " is " + std::string(text.substr(0, 24)) + ", outside " +
             std::to_string(low) + " .. " + std::to_string(high));
    }
    return value;
}

Index TextCursor::count(std::string_view name, Index least_bytes) {
    require_line(quoted(std::string(name) + " COUNT"));
    require_word(name);
    const std::int64_t value = integer("the count", 0);
    require_end_of_line();
    if (value >
        static_cast<std::int64_t>(text_.size() / static_cast<std::size_t>(least_bytes)) + 1) {
        fail(std::to_string(value) + " " + std::string(name) +
             " are announced, more than the rest of the file can hold; it is truncated or damaged");
    }
    return static_cast<Index>(value);
}

void TextCursor::require_end_of_line() {
    const std::string_view extra = word();
    if (!extra.empty()) fail("the line should end before " + quoted(extra));
}

void TextCursor::fail(const std::string& reason) const {
    throw FileError(source_, FileError::Unit::line, line_, reason);
}

}  // namespace tightflip::kernel
