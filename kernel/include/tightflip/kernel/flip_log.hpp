/// \file
/// A start and the flips done from it: the way anything is reproduced, undone, animated or proved.
#pragma once

#include <tightflip/kernel/surface_text.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::kernel {

/// A start and a list of edges, flipped in order.
struct FlipLog {
    Triangulation start;
    std::vector<Edge> flips;

    friend bool operator==(const FlipLog&, const FlipLog&) = default;
};

/// A log as a file gives it; nothing is known about its table but that its numbers are numbers.
struct RawFlipLog {
    RawTable start;
    std::vector<Edge> flips;
};

/// A log in anybody's memory, for those who only read.
struct FlipLogView {
    TableView start;
    std::span<const Edge> flips;

    FlipLogView(const FlipLog& log) noexcept  // NOLINT(google-explicit-constructor)
        : start(log.start), flips(log.flips) {}
    FlipLogView(const RawFlipLog& log) noexcept  // NOLINT(google-explicit-constructor)
        : start(log.start), flips(log.flips) {}
};

/// How far a log could be followed.
struct Replay {
    Triangulation surface;  ///< after the flips that were done
    std::size_t done = 0;   ///< flips done before the first that was not
    /// Empty when all were done; else what is wrong with flip number `done`.
    std::string reason;

    [[nodiscard]] bool is_complete() const noexcept { return reason.empty(); }
};

/// Follows a log to its end, or to the first flip that is refused or names no edge.
[[nodiscard]] Replay replay(const FlipLog& log);

/// A surface that writes down its flips and can take them back.
class RecordedSurface {
public:
    explicit RecordedSurface(Triangulation start) : log_{start, {}}, surface_(std::move(start)) {}
    /// Continues where a replayed log ended. Throws std::invalid_argument where it does not replay.
    explicit RecordedSurface(FlipLog log);

    [[nodiscard]] const Triangulation& surface() const noexcept { return surface_; }
    [[nodiscard]] const FlipLog& log() const noexcept { return log_; }

    /// Flips and, where that was done, records. Amortised constant time.
    FlipVerdict flip(Edge e);
    /// Takes the last flip back; false where there is none.
    bool undo();

private:
    FlipLog log_;
    Triangulation surface_;
};

/// Text and compact binary, versioned, ending in a checksum of the content. Throws
/// std::length_error for more than 2^31 - 1 flips.
void write_text(std::ostream& out, const FlipLogView& log);
void write_binary(std::ostream& out, const FlipLogView& log);

/// Whether bytes begin like a log in either form.
[[nodiscard]] bool is_flip_log(std::string_view bytes) noexcept;

/// Reads either form. Throws FileError with the line or byte where the log is damaged, truncated,
/// foreign, of another version, names an edge its start does not have, or starts from a surface
/// that does not pass the audit. Memory and time are linear in the bytes.
[[nodiscard]] FlipLog parse_flip_log(std::string_view bytes, const std::string& source);

/// Reads either form, but only byte by byte as this library writes it, so that no byte can be
/// changed unnoticed; its start is not audited. Throws FileError as `parse_flip_log` does, and
/// where the spelling alone differs: comments, blanks, line ends, capitals, leading zeros.
[[nodiscard]] RawFlipLog parse_flip_log_as_written(std::string_view bytes,
                                                   const std::string& source);

}  // namespace tightflip::kernel
