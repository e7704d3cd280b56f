#include <tightflip/kernel/text_cursor.hpp>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace tightflip::kernel {
namespace {

constexpr bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// The error of reading the whole word as a T: none, out of range, or not a T.
template <class T>
std::errc parse(std::string_view word, bool plus_signs, T& value) noexcept {
    // from_chars takes no plus sign.
    if (plus_signs && word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return stop == end ? error : std::errc::invalid_argument;
}

}  // namespace

bool TextCursor::next_line() {
    while (line_ == 0 || !rest_of_line_ends_text()) {
        if (line_ != 0) offset_ = after_line();
        ++line_;
        skip_blanks();
        if (in_word()) return true;
    }
    offset_ = text_.size();
    return false;
}

void TextCursor::require_line(std::string_view expected) {
    if (!next_line()) {
        fail("the file ends where " + std::string(expected) + " should follow; it is truncated");
    }
}

void TextCursor::require_end_of_line(std::string_view content) {
    if (const std::string_view more = word(); !more.empty()) {
        fail("the line goes on with " + quoted(more) + " after " + std::string(content));
    }
}

std::string_view TextCursor::word() noexcept {
    skip_blanks();
    const std::size_t begin = offset_;
    while (in_word())
        ++offset_;
    return text_.substr(begin, offset_ - begin);
}

std::string_view TextCursor::peek() noexcept {
    const std::string_view ahead = word();
    offset_ -= ahead.size();
    return ahead;
}

std::string_view TextCursor::word(std::string_view what) {
    const std::string_view found = word();
    if (found.empty()) fail("the line ends where " + std::string(what) + " should follow");
    return found;
}

void TextCursor::require_word(std::string_view expected) {
    const std::string_view found = word();
    if (found.empty()) fail("the line ends where " + quoted(expected) + " should follow");
    if (found != expected) {
        fail(quoted(expected) + " should stand here, not " + quoted(found));
    }
}

double TextCursor::number(std::string_view what) {
    const std::string_view found = word(what);
    double value = 0;
    const std::errc error = parse(found, syntax_.plus_signs, value);
    if (error == std::errc::result_out_of_range) {
        fail(std::string(what) + ", " + quoted(found) + ", is beyond the range of a double");
    }
    if (error != std::errc{}) {
        fail(std::string(what) + " should be a number, but " + quoted(found) + " is none");
    }
    return value;
}

std::int64_t TextCursor::integer(std::string_view what, std::int64_t low, std::int64_t high) {
    const std::string_view found = word(what);
    std::int64_t value = 0;
    const std::errc error = parse(found, syntax_.plus_signs, value);
    if (error == std::errc::invalid_argument) {
        fail(std::string(what) + " should be a whole number, but " + quoted(found) + " is none");
    }
    if (error != std::errc{} || value < low || value > high) {
        fail(std::string(what) + " is " + quoted(found) + ", outside " + std::to_string(low) +
             " .. " + std::to_string(high));
    }
    return value;
}

Index TextCursor::index(std::string_view what, Index low, Index high) {
    return static_cast<Index>(integer(what, low, high));
}

std::uint64_t TextCursor::count(std::string_view what) {
    const std::int64_t value = integer(what);
    if (value < 0) fail(std::string(what) + " is negative: " + std::to_string(value));
    return static_cast<std::uint64_t>(value);
}

Index TextCursor::announced_lines(std::string_view name, Index least_bytes) {
    require_line(quoted(std::string(name) + " COUNT"));
    require_word(name);
    const Index value = index("the count", 0);
    require_end_of_line("the count");
    // The last line of a text needs no line feed.
    const std::size_t most =
        (text_.size() - after_line()) / static_cast<std::size_t>(least_bytes) + 1;
    if (static_cast<std::size_t>(value) > most) {
        fail(std::to_string(value) + " " + std::string(name) +
             " are announced, more than the rest of the file can hold; it is truncated or damaged");
    }
    return value;
}

std::optional<std::int64_t> TextCursor::parse_integer(std::string_view text) const noexcept {
    std::int64_t value = 0;
    if (parse(text, syntax_.plus_signs, value) != std::errc{}) return std::nullopt;
    return value;
}

std::size_t TextCursor::after_line() const noexcept {
    const std::size_t feed = text_.find('\n', offset_);
    return feed == std::string_view::npos ? text_.size() : feed + 1;
}

void TextCursor::fail(const std::string& reason) const {
    throw FileError(source_, FileError::Unit::line, std::max<std::uint64_t>(line_, 1), reason);
}

bool TextCursor::in_word() const noexcept {
    if (offset_ >= text_.size()) return false;
    const char c = text_[offset_];
    const bool begins_comment = syntax_.comment != '\0' && c == syntax_.comment;
    return c != '\n' && !is_blank(c) && !begins_comment && continuation_end() == offset_;
}

std::size_t TextCursor::continuation_end() const noexcept {
    if (!syntax_.continued_lines || text_[offset_] != '\\') return offset_;
    const std::string_view rest = text_.substr(offset_ + 1, 2);
    if (rest.starts_with('\n')) return offset_ + 2;
    if (rest == "\r\n") return offset_ + 3;
    return offset_;
}

void TextCursor::skip_blanks() noexcept {
    while (offset_ < text_.size()) {
        if (is_blank(text_[offset_])) {
            ++offset_;
        } else if (const std::size_t after = continuation_end(); after != offset_) {
            offset_ = after;
            ++line_;
        } else {
            return;
        }
    }
}

bool TextCursor::rest_of_line_ends_text() noexcept {
    while (!word().empty()) {  // word by word, for the line may be continued
    }
    return after_line() == text_.size();
}

std::string quoted(std::string_view text) {
    constexpr std::size_t most = 32;
    constexpr std::string_view digits = "0123456789abcdef";
    std::string result = "'";
    for (const char c : text.substr(0, most)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7f) {
            result += c;
        } else {
            result += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
        }
    }
    return result + (text.size() > most ? "...'" : "'");
}

}  // namespace tightflip::kernel
