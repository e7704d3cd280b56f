/// \file
/// Reads words and numbers line by line and knows where it is when something is wrong.
#pragma once

#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/handles.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace tightflip::kernel {

/// A cursor over a text in memory. Blank lines and what follows '#' are skipped; lines end in LF or
/// CR LF. Every failure throws FileError with the source's name and the line.
class TextCursor {
public:
    /// `text` must outlive the cursor; `source` names it in errors.
    TextCursor(std::string_view text, std::string source)
        : text_(text), source_(std::move(source)) {}

    /// Moves to the next line that has words; false at the end of the text.
    bool next_line();
    /// Moves to the next line; fails at the end of the text, naming what was expected there.
    void require_line(std::string_view expected);
    /// The next word of the line; empty at its end.
    std::string_view word();
    /// The next word, which must be `expected`.
    void require_word(std::string_view expected);
    /// The next word as an integer in [low, high]; `what` names it in errors.
    std::int64_t integer(std::string_view what,
                         std::int64_t low = std::numeric_limits<Index>::min(),
                         std::int64_t high = std::numeric_limits<Index>::max());
    /// A line "name count", where the text left could hold that many lines of `least_bytes` each.
    Index count(std::string_view name, Index least_bytes);
    /// Fails where the line has more words.
    void require_end_of_line();

    [[nodiscard]] std::uint64_t line() const noexcept { return line_; }
    [[nodiscard]] const std::string& source() const noexcept { return source_; }
    [[noreturn]] void fail(const std::string& reason) const;

private:
    std::string_view text_;  // after the current line
    std::string_view rest_;  // of the current line
    std::string source_;
    std::uint64_t line_ = 0;
};

}  // namespace tightflip::kernel
