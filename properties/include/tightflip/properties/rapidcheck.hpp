/// \file
/// RapidCheck generators of surfaces, scripts, points and cases that shrink well. Only includers of
/// this header need RapidCheck.
///
/// \code
///     RC_GTEST_PROP(MyKernel, KeepsTheTopology, (const FlipCase& flip_case)) {
///         require_claim("my_kernel", flip_case, my_claim);
///     }
/// \endcode
///
/// For a mesh type of your own, make it from the start and flip it along:
///
/// \code
///     RC_GTEST_PROP(MyMesh, FlipsSimpleSurfaces, ()) {
///         const Triangulation start = *any_surface({.graph = GraphKind::simple});
///         MyMesh mesh(start.vertex_count(), corners(start));
///         for (const Edge e : *any_script(start, 50)) ...
///     }
/// \endcode
#pragma once

#include <tightflip/kernel/surface_text.hpp>
#include <tightflip/properties/failing_case.hpp>
#include <tightflip/properties/flip_case.hpp>
#include <tightflip/properties/simpler_cases.hpp>
#include <tightflip/properties/simpler_points.hpp>
#include <tightflip/properties/surface_case.hpp>

#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include <rapidcheck.h>

namespace tightflip::kernel {

/// How RapidCheck prints edges and other handles, and surfaces.
template <class Tag>
void showValue(Handle<Tag> handle, std::ostream& out) {
    out << handle.id;
}
inline void showValue(const Triangulation& surface, std::ostream& out) {
    write_text(out, surface);
}

}  // namespace tightflip::kernel

namespace tightflip::properties {

/// Whether parallel edges are wanted.
enum class GraphKind : std::uint8_t { any, simple, multigraph };

/// What cases are drawn from.
struct FlipCaseLimits {
    Index genus = 3;                       ///< the largest, for kinds that have any
    Index spare_vertices = 24;             ///< beyond a kind's least number, at full size
    int flips = 120;                       ///< at full size
    const StartKind* only_kind = nullptr;  ///< null: all kinds
    GraphKind graph = GraphKind::any;
    std::optional<Index> exact_genus{};     ///< this genus and no other
    std::optional<Index> exact_vertices{};  ///< so many vertices
};

namespace detail {

/// Uniform below a bound, whatever the size.
template <class T>
[[nodiscard]] rc::Gen<T> below(T bound) {
    return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(0, bound));
}

/// Whether a case's start is what the limits ask for.
[[nodiscard]] inline bool is_wanted(const FlipCase& flip_case, const FlipCaseLimits& limits) {
    if (limits.only_kind != nullptr && flip_case.kind != limits.only_kind) return false;
    if (limits.graph == GraphKind::any && !limits.exact_genus && !limits.exact_vertices) {
        return true;
    }
    const AuditReport report = audit(flip_case.start());
    const Topology& topology = report.topology;
    return (limits.graph == GraphKind::any ||
            (limits.graph == GraphKind::simple) == report.is_simple()) &&
           (!limits.exact_genus || topology.genus == limits.exact_genus) &&
           (!limits.exact_vertices || topology.vertices == limits.exact_vertices);
}

/// Cases with no script.
[[nodiscard]] inline rc::Gen<FlipCase> any_start(const FlipCaseLimits& limits) {
    const Index genera = limits.exact_genus.value_or(limits.genus) + 1;
    auto starts = rc::gen::map(
        rc::gen::tuple(below(start_kinds().size()), below(genera),
                       rc::gen::inRange<Index>(0, limits.spare_vertices + 1),
                       below(std::uint64_t{1} << 16)),
        [limits](const auto& drawn) {
            const auto& [kind_number, drawn_genus, spare, seed] = drawn;
            const StartKind& kind =
                limits.only_kind != nullptr ? *limits.only_kind : start_kinds()[kind_number];
            const Index genus = kind.any_genus ? limits.exact_genus.value_or(drawn_genus) : 0;
            return FlipCase{.kind = &kind,
                            .request = {.vertices = limits.exact_vertices.value_or(
                                            kind.least_vertices(genus) + spare),
                                        .genus = genus,
                                        .seed = seed},
                            .picks = {}};
        });
    return rc::gen::suchThat(std::move(starts), [limits](const FlipCase& flip_case) {
        return is_wanted(flip_case, limits);
    });
}

/// Lists of numbers that name edges modulo their number.
[[nodiscard]] inline rc::Gen<std::vector<std::uint32_t>> any_picks(int most) {
    return rc::gen::scale(
        static_cast<double>(most) / rc::kNominalSize,
        rc::gen::container<std::vector<std::uint32_t>>(below(std::uint32_t{1} << 16)));
}

/// A start that is wanted, and a script.
[[nodiscard]] inline FlipCase drawn_flip_case(const FlipCaseLimits& limits,
                                              const rc::Random& random, int size) {
    rc::Random stream = random;
    FlipCase flip_case = any_start(limits)(stream.split(), size).value();
    flip_case.picks = any_picks(limits.flips)(stream, size).value();
    return flip_case;
}

[[nodiscard]] inline const FlipCase& flips_of(const FlipCase& flip_case) {
    return flip_case;
}
[[nodiscard]] inline const FlipCase& flips_of(const SurfaceCase& surface_case) {
    return surface_case.flips;
}

/// A case with its simpler cases that keep to the limits.
template <class Case>
[[nodiscard]] rc::Shrinkable<Case> shrinking_case(Case drawn, const FlipCaseLimits& limits) {
    return rc::shrinkable::shrinkRecur(std::move(drawn), [limits](const Case& larger) {
        return rc::seq::filter(
            rc::seq::fromContainer(simpler_cases(larger)),
            [limits](const Case& simpler) { return is_wanted(flips_of(simpler), limits); });
    });
}

/// A kind of points, the one given or any where it is null, and a seed.
[[nodiscard]] inline rc::Gen<std::pair<const PointKind*, std::uint64_t>> any_place(
    const PointKind* only_kind) {
    return rc::gen::map(rc::gen::pair(below(point_kinds().size()), below(std::uint64_t{1} << 16)),
                        [only_kind](const std::pair<std::size_t, std::uint64_t>& drawn) {
                            const PointKind* const kind =
                                only_kind != nullptr ? only_kind : &point_kinds()[drawn.first];
                            return std::pair{kind, drawn.second};
                        });
}

}  // namespace detail

/// Cases of every kind; vertices and flips grow with RapidCheck's size. They shrink as
/// `simpler_cases` says: towards earlier kinds, genus 0, few vertices, seed 0, short scripts and
/// low edges, all within the limits. Limits that no kind can keep to are an error that RapidCheck
/// reports. A case costs its start, and with limits on graph, genus or vertices the start and audit
/// of every one that is drawn on the way.
[[nodiscard]] inline rc::Gen<FlipCase> any_flip_case(const FlipCaseLimits& limits = {}) {
    return [=](const rc::Random& random, int size) {
        return detail::shrinking_case(detail::drawn_flip_case(limits, random, size), limits);
    };
}

/// The starts of such cases, as surfaces.
[[nodiscard]] inline rc::Gen<Triangulation> any_surface(const FlipCaseLimits& limits = {}) {
    FlipCaseLimits starts = limits;
    starts.flips = 0;
    return rc::gen::map(any_flip_case(starts),
                        [](const FlipCase& flip_case) { return flip_case.start(); });
}

/// Scripts of at most so many flips, at full size, from a start; refused ones among them. They
/// shrink in length and towards low edges.
[[nodiscard]] inline rc::Gen<FlipScript> any_script(const Triangulation& start, int most_flips) {
    return rc::gen::map(
        detail::any_picks(most_flips),
        [edges = start.edge_count()](const std::vector<std::uint32_t>& picks) {
            FlipScript script;
            for (const std::uint32_t pick : picks)
                script.push_back({static_cast<Index>(pick % static_cast<std::uint32_t>(edges))});
            return script;
        });
}

/// The same without refused flips, which are left out after each shrink again: every flip of a
/// script is defined when its turn comes.
[[nodiscard]] inline rc::Gen<FlipScript> any_defined_script(const Triangulation& start,
                                                            int most_flips) {
    return rc::gen::map(any_script(start, most_flips), [start](const FlipScript& script) {
        return without_refused(start, script);
    });
}

/// So many points of a kind, or of any where it is null. They shrink as `simpler_points` says:
/// towards few distinct small integers.
[[nodiscard]] inline rc::Gen<std::vector<geometry::Point>> any_points(
    Index count, const PointKind* only_kind = nullptr) {
    return [=](const rc::Random& random, int size) {
        const auto [kind, seed] = detail::any_place(only_kind)(random, size).value();
        return rc::shrinkable::shrinkRecur(
            kind->make(count, seed), [](const std::vector<geometry::Point>& points) {
                return rc::seq::fromContainer(simpler_points(points));
            });
    };
}

/// What surface cases are drawn from.
struct SurfaceCaseLimits {
    FlipCaseLimits flips{.genus = 2, .spare_vertices = 12, .flips = 16};
    const PointKind* only_points = nullptr;  ///< null: all kinds
};

/// Surfaces in space with scripts. They shrink as flip cases do, and to simpler points.
[[nodiscard]] inline rc::Gen<SurfaceCase> any_surface_case(const SurfaceCaseLimits& limits = {}) {
    return [=](const rc::Random& random, int size) {
        rc::Random stream = random;
        FlipCase flips = detail::drawn_flip_case(limits.flips, stream.split(), size);
        const auto [kind, seed] = detail::any_place(limits.only_points)(stream, size).value();
        return detail::shrinking_case(
            SurfaceCase{.flips = std::move(flips), .point_kind = kind, .point_seed = seed},
            limits.flips);
    };
}

/// How RapidCheck prints cases.
inline void showValue(const FlipCase& flip_case, std::ostream& out) {
    out << describe(flip_case);
}
inline void showValue(const SurfaceCase& surface_case, std::ostream& out) {
    out << describe(surface_case);
}

/// Fails the running property where the claim does not hold of the case, with the finding, the
/// script in words and the place of a log that shows it, or why that could not be written. Cases
/// that fail while RapidCheck shrinks overwrite each other, so that the smallest remains.
template <class Case, class Claim>
void require_claim(std::string_view name, const Case& drawn, const Claim& claim) {
    const auto start = drawn.start();
    FlipScript script = drawn.script();
    const auto finding = claim(start, std::span<const Edge>(script));
    if (!finding) return;
    const FailingCase failing{
        {triangulation_of(start), std::move(script)}, describe(*finding), points_of(start)};
    RC_FAIL(written_and_in_words(name, failing));
}

}  // namespace tightflip::properties

/// Let a property take cases as its arguments.
template <>
struct rc::Arbitrary<tightflip::properties::FlipCase> {
    static Gen<tightflip::properties::FlipCase> arbitrary() {
        return tightflip::properties::any_flip_case();
    }
};
template <>
struct rc::Arbitrary<tightflip::properties::SurfaceCase> {
    static Gen<tightflip::properties::SurfaceCase> arbitrary() {
        return tightflip::properties::any_surface_case();
    }
};
