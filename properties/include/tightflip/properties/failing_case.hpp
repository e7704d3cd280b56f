/// \file
/// A failing case, made small, in words and on disk. Needs no test library: those that have one,
/// and programs without, call this.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/shrink.hpp>

#include <concepts>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tightflip::properties {

/// The environment variable that names the directory for the logs of failing cases; without it, the
/// current one.
inline constexpr const char* failures_directory_variable = "TIGHTFLIP_FAILURES";

/// A check: a start (a `Triangulation`, or a `geometry::Surface` with points) and a script in, an
/// optional finding out, which has `describe(finding)` in words. Those of claims.hpp are such, and
/// so may one of your own kernel be.
template <class C, class Start>
concept ClaimOn = requires(const C& claim, const Start& start, std::span<const Edge> script) {
    { describe(*claim(start, script)) } -> std::convertible_to<std::string>;
    { claim(start, script).has_value() } -> std::convertible_to<bool>;
};

/// A case with the shortest script found that fails.
struct FailingCase {
    kernel::FlipLog log;
    std::string finding;                  ///< of that script
    std::vector<geometry::Point> points;  ///< of the start, where it has any
};

/// What a start is made of.
[[nodiscard]] inline const Triangulation& triangulation_of(const Triangulation& start) noexcept {
    return start;
}
[[nodiscard]] inline const Triangulation& triangulation_of(
    const geometry::Surface& start) noexcept {
    return start.triangulation();
}
[[nodiscard]] inline std::vector<geometry::Point> points_of(const Triangulation& /*start*/) {
    return {};
}
[[nodiscard]] inline std::vector<geometry::Point> points_of(const geometry::Surface& start) {
    return {start.points().begin(), start.points().end()};
}

/// Nothing where the claim holds of a script from a start; else its failing case, shrunk.
template <class Start, ClaimOn<Start> Claim>
[[nodiscard]] std::optional<FailingCase> failing_case(const Claim& claim, const Start& start,
                                                      FlipScript script) {
    std::string finding;
    const auto fails = [&](std::span<const Edge> shorter) {
        const auto found = claim(start, shorter);
        if (found.has_value()) finding = describe(*found);
        return found.has_value();
    };
    if (!fails(script)) return std::nullopt;
    FlipScript shortest = shrink(std::move(script), fails);  // the last that failed
    return FailingCase{{triangulation_of(start), std::move(shortest)}, finding, points_of(start)};
}

/// The finding, the points if there are any, and the script in words.
[[nodiscard]] std::string in_words(const FailingCase& failing);

/// Writes the log to "NAME.flips" and, of a start with points, the start to "NAME.surface", in the
/// directory for failing cases, which is made if there is none, and returns the log's path. What is
/// no letter, digit, '.', '_' or '-' in the name becomes '-'. Throws FileError where they cannot be
/// written.
std::filesystem::path write_failing_case(std::string_view name, const FailingCase& failing);

/// Writes the case as `write_failing_case` does. Returns it in words, and then where its log is, or
/// why it could not be written.
[[nodiscard]] std::string written_and_in_words(std::string_view name, const FailingCase& failing);

}  // namespace tightflip::properties
