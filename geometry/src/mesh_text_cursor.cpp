#include "mesh_text_cursor.hpp"

#include <tightflip/kernel/file_error.hpp>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace tightflip::geometry {
namespace {

using kernel::FileError;

constexpr bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// from_chars takes no plus sign; files have it.
std::string_view without_plus(std::string_view token) noexcept {
    const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
    return plus ? token.substr(1) : token;
}

/// The error of reading the whole token as a T: none, out of range, or not a T.
template <class T>
std::errc parse(std::string_view token, T& value) noexcept {
    token = without_plus(token);
    const char* const end = token.data() + token.size();
    const auto [stop, error] = std::from_chars(token.data(), end, value);
    return error == std::errc{} && stop != end ? std::errc::invalid_argument : error;
}

}  // namespace

MeshTextCursor::MeshTextCursor(std::string_view text, std::string_view source, LineSyntax syntax)
    : text_(text), source_(source), syntax_(syntax) {}

bool MeshTextCursor::next_line() {
    while (line_ == 0 || !rest_of_line_ends_text()) {
        if (line_ != 0) offset_ = after_line();
        ++line_;
        if (!peek().empty()) return true;
    }
    offset_ = text_.size();
    return false;
}

void MeshTextCursor::require_line(std::string_view expected) {
    if (!next_line()) fail("the file ends where " + std::string(expected) + " should follow");
}

bool MeshTextCursor::rest_of_line_ends_text() noexcept {
    while (!token().empty()) {  // token by token, for the line may be continued
    }
    return after_line() == text_.size();
}

std::size_t MeshTextCursor::after_line() const noexcept {
    const std::size_t feed = text_.find('\n', offset_);
    return feed == std::string_view::npos ? text_.size() : feed + 1;
}

void MeshTextCursor::skip_blanks() noexcept {
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

std::size_t MeshTextCursor::continuation_end() const noexcept {
    const std::string_view rest = text_.substr(offset_, 3);
    if (!syntax_.continued_lines) return offset_;
    if (rest.starts_with("\\\n")) return offset_ + 2;
    if (rest.starts_with("\\\r\n")) return offset_ + 3;
    return offset_;
}

std::string_view MeshTextCursor::peek() noexcept {
    skip_blanks();
    const MeshTextCursor here = *this;
    const std::string_view ahead = token();
    *this = here;
    return ahead;
}

std::string_view MeshTextCursor::token() noexcept {
    skip_blanks();
    const std::size_t begin = offset_;
    while (offset_ < text_.size() && text_[offset_] != '\n' && !is_blank(text_[offset_]) &&
           (syntax_.comment == '\0' || text_[offset_] != syntax_.comment) &&
           continuation_end() == offset_) {
        ++offset_;
    }
    return text_.substr(begin, offset_ - begin);
}

std::string_view MeshTextCursor::require_token(std::string_view expected) {
    const std::string_view found = token();
    if (found.empty()) fail("the line ends where " + std::string(expected) + " should follow");
    return found;
}

double MeshTextCursor::number(std::string_view expected) {
    const std::string_view found = require_token(expected);
    double value = 0;
    const std::errc error = parse(found, value);
    if (error == std::errc::result_out_of_range) {
        fail(std::string(expected) + ", " + quoted(found) + ", is beyond the range of a double");
    }
    if (error != std::errc{}) {
        fail(std::string(expected) + " should be a number, but " + quoted(found) + " is none");
    }
    return value;
}

std::int64_t MeshTextCursor::integer(std::string_view expected) {
    const std::string_view found = require_token(expected);
    std::int64_t value = 0;
    if (!parse_integer(found, value)) {
        fail(std::string(expected) + " should be an integer, but " + quoted(found) + " is none");
    }
    return value;
}

std::uint64_t MeshTextCursor::count(std::string_view expected) {
    const std::int64_t value = integer(expected);
    if (value < 0) fail(std::string(expected) + " is negative: " + std::to_string(value));
    return static_cast<std::uint64_t>(value);
}

void MeshTextCursor::require_end_of_line(std::string_view content) {
    if (const std::string_view more = token(); !more.empty()) {
        fail("the line goes on with " + quoted(more) + " after " + std::string(content));
    }
}

void MeshTextCursor::fail(const std::string& reason) const {
    throw FileError(std::string(source_), FileError::Unit::line, std::max<std::uint64_t>(line_, 1),
                    reason);
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

std::string lowered(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
}

bool parse_integer(std::string_view token, std::int64_t& value) noexcept {
    return parse(token, value) == std::errc{};
}

}  // namespace tightflip::geometry
