/// \file
/// A place in a text that knows its line: lines of tokens, comments and continuations left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tightflip::geometry {

/// What a format leaves out of its lines.
struct LineSyntax {
    char comment = '\0';           ///< begins a comment up to the line's end; none where '\0'
    bool continued_lines = false;  ///< a backslash at a line's end joins the next line
};

/// Walks a text line by line and token by token. Lines end in LF or CR LF. Numbers are read the
/// same in every locale. The text and the source's name must outlive the cursor.
class MeshTextCursor {
public:
    MeshTextCursor(std::string_view text, std::string_view source, LineSyntax syntax = {});

    /// Goes to the first token of the next line that has one; false where there is none.
    bool next_line();
    /// As `next_line`, but throws where the text ends; `expected` says what should follow.
    void require_line(std::string_view expected);
    /// The next token of this line; empty at its end.
    [[nodiscard]] std::string_view token() noexcept;
    /// The next token without taking it.
    [[nodiscard]] std::string_view peek() noexcept;
    /// Moves over the first `count` bytes of the token ahead, so that the rest is the next token.
    void skip_bytes(std::size_t count) noexcept { offset_ += count; }

    /// Token, or an error that says what is missing.
    [[nodiscard]] std::string_view require_token(std::string_view expected);
    /// A decimal number, which may be nan or inf.
    [[nodiscard]] double number(std::string_view expected);
    /// A decimal integer.
    [[nodiscard]] std::int64_t integer(std::string_view expected);
    /// A decimal integer that is not negative.
    [[nodiscard]] std::uint64_t count(std::string_view expected);
    /// Throws where the line goes on; `content` says what it may hold.
    void require_end_of_line(std::string_view content);

    /// The line, from 1, of the token taken last.
    [[nodiscard]] std::uint64_t line() const noexcept { return line_; }
    /// The first byte after this line.
    [[nodiscard]] std::size_t after_line() const noexcept;

    /// Throws FileError at this line.
    [[noreturn]] void fail(const std::string& reason) const;

private:
    void skip_blanks() noexcept;
    /// Skips what is left of this line; whether the text ends with it.
    [[nodiscard]] bool rest_of_line_ends_text() noexcept;
    /// The first byte after a continuation that stands here; here where there is none.
    [[nodiscard]] std::size_t continuation_end() const noexcept;

    std::string_view text_;
    std::string_view source_;
    LineSyntax syntax_;
    std::size_t offset_ = 0;
    std::uint64_t line_ = 0;  // 0: before the first line
};

/// Text from a file made fit for a message: quoted, cut short, unprintable bytes as \xNN.
[[nodiscard]] std::string quoted(std::string_view text);

/// A token in lower case (ASCII letters alone, whatever the locale).
[[nodiscard]] std::string lowered(std::string_view text);

/// The whole token as a decimal integer; false where it is none or does not fit.
[[nodiscard]] bool parse_integer(std::string_view token, std::int64_t& value) noexcept;

}  // namespace tightflip::geometry
