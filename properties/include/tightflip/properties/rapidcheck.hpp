/// \file
/// RapidCheck generators of starts and flip scripts that shrink well. Only includers of this header
/// need RapidCheck.
///
/// \code
///     RC_GTEST_PROP(MyKernel, KeepsTheTopology, (const FlipCase& flip_case)) {
///         require_claim("my_kernel", flip_case, my_claim);
///     }
/// \endcode
#pragma once

#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <ostream>

#include <rapidcheck.h>

namespace tightflip::properties {

/// What cases are drawn from.
struct FlipCaseLimits {
    Index genus = 3;                       ///< the largest, for kinds that have any
    Index spare_vertices = 24;             ///< beyond a kind's least number, at full size
    int flips = 120;                       ///< at full size
    const StartKind* only_kind = nullptr;  ///< null: all kinds
};

/// The directory for the logs of failing cases; without it, the current one.
inline constexpr const char* failures_directory_variable = "TIGHTFLIP_FAILURES";

/// Cases of every kind; vertices and flips grow with RapidCheck's size. They shrink towards earlier
/// kinds, genus 0, few vertices, seed 0, short scripts and low edges.
[[nodiscard]] inline rc::Gen<FlipCase> any_flip_case(const FlipCaseLimits& limits = {}) {
    const auto below = []<class T>(T bound) {  // whatever the size
        return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(0, bound));
    };
    return rc::gen::map(
        rc::gen::tuple(
            below(start_kinds().size()), below(limits.genus + 1),
            rc::gen::inRange<Index>(0, limits.spare_vertices + 1), below(std::uint64_t{1} << 16),
            rc::gen::scale(
                static_cast<double>(limits.flips) / rc::kNominalSize,
                rc::gen::container<std::vector<std::uint32_t>>(below(std::uint32_t{1} << 16)))),
        [only_kind = limits.only_kind](auto drawn) {
            auto& [kind_number, drawn_genus, spare, seed, picks] = drawn;
            const StartKind& kind = only_kind != nullptr ? *only_kind : start_kinds()[kind_number];
            const Index genus = kind.any_genus ? drawn_genus : 0;
            return FlipCase{.kind = &kind,
                            .request = {.vertices = kind.least_vertices(genus) + spare,
                                        .genus = genus,
                                        .seed = seed},
                            .picks = std::move(picks)};
        });
}

/// How RapidCheck prints a case.
inline void showValue(const FlipCase& flip_case, std::ostream& out) {
    out << describe(flip_case);
}

/// Writes a log to "<name>.flips" and returns where. Cases that fail while RapidCheck shrinks
/// overwrite each other, so that the smallest remains.
inline std::filesystem::path write_failing_case(std::string_view name, const kernel::FlipLog& log) {
    const char* const directory = std::getenv(failures_directory_variable);
    const auto path = std::filesystem::path(directory != nullptr ? directory : ".") /
                      (std::string(name) + ".flips");
    kernel::write_file(path, [&](std::ostream& out) { write_text(out, log); });
    return path;
}

/// A check from claims.hpp, or one of your own kernel.
using Claim = std::function<std::optional<Finding>(const Triangulation&, std::span<const Edge>)>;

/// Fails the running property where the claim does not hold of the case, with the finding and the
/// place of a log that shows it.
inline void require_claim(std::string_view name, const FlipCase& flip_case, const Claim& claim) {
    const kernel::FlipLog log = flip_case.log();
    const std::optional<Finding> finding = claim(log.start, log.flips);
    if (!finding) return;
    const auto path = write_failing_case(name, log);
    RC_FAIL(describe(*finding) + "\nwritten to " + path.string());
}

}  // namespace tightflip::properties

/// Lets a property take a FlipCase as its argument.
template <>
struct rc::Arbitrary<tightflip::properties::FlipCase> {
    static Gen<tightflip::properties::FlipCase> arbitrary() {
        return tightflip::properties::any_flip_case();
    }
};
