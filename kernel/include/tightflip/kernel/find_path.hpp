/// \file
/// Flip paths between two labelled surfaces of any genus: constructed, searched for, or proved not
/// to exist.
///
/// \code
///     const PathSearch found = find_path(a, b, {.shortest = true});
///     if (found) write_text(out, *found.path);
/// \endcode
#pragma once

#include <tightflip/kernel/flip_log.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace tightflip::kernel {

/// How a search ended. Values are stable.
enum class PathOutcome : std::uint8_t {
    found = 0,
    isolated = 1,       ///< none exists: the ends differ, and from one of them no flip leads away
    not_connected = 2,  ///< none exists: all that one end leads to was seen, and not the other
    not_found = 3,      ///< undecided: a limit was reached first
    interrupted = 4,    ///< undecided: asked to stop
    ends_differ = 5,    ///< none exists: flips keep the number of vertices and the genus
};

/// The outcome as one word, say "not_connected".
[[nodiscard]] std::string_view name(PathOutcome outcome) noexcept;
/// The outcome in one line of plain words.
[[nodiscard]] std::string_view describe(PathOutcome outcome) noexcept;

struct PathOptions {
    /// Ask for a path as short as any. Otherwise spheres are connected by construction
    /// (connect.hpp), which is fast and never fails.
    bool shortest = false;
    std::size_t most_states = 20'000'000;            ///< labelled surfaces kept
    std::size_t most_bytes = std::size_t{2} << 30U;  ///< memory for them
    std::function<bool()> interrupted = {};          ///< asked often; may be empty
};

/// What came of it.
struct PathSearch {
    PathOutcome outcome = PathOutcome::not_found;
    /// From the table of the one end to the labelled surface of the other; only where found.
    std::optional<FlipLog> path;
    std::size_t states = 0;  ///< labelled surfaces seen; 0 where the path was constructed
    /// Where undecided: every path has at least so many flips.
    std::int64_t least_length = 0;

    [[nodiscard]] explicit operator bool() const noexcept { return path.has_value(); }
};

/// Looks for a path. Searches breadth-first from both ends, level by level, always where fewer
/// surfaces wait: so a path found is shortest, and an end that cannot leave a small component is
/// seen soon. Time: O(V^2) a surface. Memory: a canonical code of about 5 V numbers of one byte
/// each (two from V = 45 on) and some 20 bytes a surface. A path of d flips takes about as many
/// surfaces as lie within d / 2 flips of either end.
[[nodiscard]] PathSearch find_path(const Triangulation& from, const Triangulation& to,
                                   const PathOptions& options = {});

}  // namespace tightflip::kernel
