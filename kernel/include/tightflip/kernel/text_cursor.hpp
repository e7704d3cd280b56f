/// \file
/// Reads words and numbers line by line and knows where it is when something is wrong.
#pragma once

#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/handles.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace tightflip::kernel {

/// How a format writes its lines and numbers; the default is that of the kernel's own formats.
struct LineSyntax {
    char comment = '#';            ///< begins a comment up to the line's end; none where '\0'
    bool continued_lines = false;  ///< a backslash at a line's end joins the next line
    bool plus_signs = false;       ///< a number may begin with '+'
};

/// A cursor over a text in memory: lines of words, comments and continuations left out. Lines end
/// in LF or CR LF; those without a word are skipped. Numbers are read the same in every locale.
/// Whatever is required and not there throws FileError with the source's name and the line.
class TextCursor {
public:
    /// Before the first line. `text` must outlive the cursor; `source` names it in errors.
    TextCursor(std::string_view text, std::string source, LineSyntax syntax = {})
        : text_(text), source_(std::move(source)), syntax_(syntax) {}

    /// Moves to the next line that has words; false at the end of the text.
    bool next_line();
    /// Moves to the next line; fails at the end of the text, naming what was expected there.
    void require_line(std::string_view expected);
    /// Fails where the line has more words; `content` says what it may hold.
    void require_end_of_line(std::string_view content);

    /// The next word of the line; empty at its end.
    std::string_view word() noexcept;
    /// The next word without taking it.
    [[nodiscard]] std::string_view peek() noexcept;
    /// Moves over the first `count` bytes of the word ahead, so that the rest is the next word.
    void skip_bytes(std::size_t count) noexcept { offset_ += count; }

    /// The next word; fails at the line's end. Here and below `what` names it in errors.
    std::string_view word(std::string_view what);
    /// The next word, which must be `expected`.
    void require_word(std::string_view expected);
    /// The next word as a decimal number, which may be nan or inf.
    double number(std::string_view what);
    /// The next word as a decimal integer in [low, high].
    std::int64_t integer(std::string_view what,
                         std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                         std::int64_t high = std::numeric_limits<std::int64_t>::max());
    /// The next word as an integer in [low, high], by default as any Index.
    Index index(std::string_view what, Index low = std::numeric_limits<Index>::min(),
                Index high = std::numeric_limits<Index>::max());
    /// The next word as an integer that is not negative.
    std::uint64_t count(std::string_view what);
    /// A line "name count", where the text left could hold that many lines of `least_bytes` each.
    Index announced_lines(std::string_view name, Index least_bytes);

    /// All of `text`, say a part of a word, as a decimal integer; empty where it is none or does
    /// not fit.
    [[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text) const noexcept;

    /// The line, from 1, of the word taken last; 0 before the first line.
    [[nodiscard]] std::uint64_t line() const noexcept { return line_; }
    /// The first byte after this line.
    [[nodiscard]] std::size_t after_line() const noexcept;
    [[nodiscard]] const std::string& source() const noexcept { return source_; }
    [[noreturn]] void fail(const std::string& reason) const;

private:
    /// Whether a byte of a word stands here.
    [[nodiscard]] bool in_word() const noexcept;
    /// The first byte after a continuation that stands here; here where there is none.
    [[nodiscard]] std::size_t continuation_end() const noexcept;
    void skip_blanks() noexcept;
    /// Skips what is left of this line; whether the text ends with it.
    [[nodiscard]] bool rest_of_line_ends_text() noexcept;

    std::string_view text_;
    std::string source_;
    LineSyntax syntax_;
    std::size_t offset_ = 0;
    std::uint64_t line_ = 0;
};

/// Text from a file made fit for a message: quoted, cut short, unprintable bytes as \xNN.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace tightflip::kernel
