/// \file
/// What the paper says of the optimisation of convex data by the Tight criterion, and of tight
/// surfaces (Alboul et al., sections 4.1.2 and 5), as callable checks.
///
/// Each has premises, said at the function. A finding is a surface, or a run, for which they hold
/// and the claim does not; where they do not hold there is none. Verdicts are in docs/theory.md:
/// some of the claims are refuted, and their checks find the bundled instances.
#pragma once

#include <tightflip/geometry/optimise.hpp>
#include <tightflip/geometry/surface.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tightflip::properties {

/// The claims by their stable codes.
enum class OptimisationClaim : std::uint16_t {
    tight_is_global = 1101,                   ///< no embedded minimum but the hull
    tight_is_global_while_embedded = 1102,    ///< the same with flips that keep it embedded
    concave_flips_do_not_raise_tight = 1103,  ///< of embedded surfaces on convex data
    tight_search_ends_convex = 1104,          ///< from all without global self-intersections
    flips_keep_intersections_local = 1105,    ///< those that lower Tight
    global_intersections_show_the_negative_side = 1106,
    convex_is_unique = 1107,   ///< up to flat edges
    tight_is_two_piece = 1108  ///< Omega_abs = 2 pi (4 - chi) and two pieces are one property
};

[[nodiscard]] std::string_view name(OptimisationClaim claim);

struct OptimisationFinding {
    OptimisationClaim claim{};
    std::size_t step = 0;  ///< flips done before it showed
    std::string detail;    ///< where, and the numbers
};

/// One line: the step, the code, the claim and the detail.
[[nodiscard]] std::string describe(const OptimisationFinding& finding);

/// Whether a surface is convex up to flat edges, decided exactly, whichever way its faces turn.
enum class Convexity : std::uint8_t { none, convex, inside_out };
[[nodiscard]] Convexity convexity(const geometry::SurfaceView& surface);

/// An embedded sphere on convex data is convex up to flat edges, or some flip lowers Tight. O(n^2)
/// in the worst case, mostly O(n log n).
[[nodiscard]] std::optional<OptimisationFinding> tight_is_global(const geometry::Surface& surface);
/// The same, and the surface after that flip is embedded. O(n^2).
[[nodiscard]] std::optional<OptimisationFinding> tight_is_global_while_embedded(
    const geometry::Surface& surface);

/// No flip of a concave edge of an embedded sphere on convex data, faces turned outwards, raises
/// Tight (proved in docs/theory.md). Outside general position too.
[[nodiscard]] std::optional<OptimisationFinding> concave_flips_do_not_raise_tight(
    const geometry::Surface& surface);

/// From a sphere on convex data without global self-intersections, plain local search on Tight
/// ends in a surface that is convex up to flat edges, whichever way its faces turn.
[[nodiscard]] std::optional<OptimisationFinding> tight_search_ends_convex(
    geometry::Surface start, geometry::FlipOrder order);

/// A sphere on convex data without global self-intersections has none after any flip of a script
/// all of whose flips are done and lower Tight.
[[nodiscard]] std::optional<OptimisationFinding> flips_keep_intersections_local(
    geometry::Surface start, std::span<const kernel::Edge> script);

/// A surface with global self-intersections is no sum of at most `most` tetrahedra (whose inner
/// side no ray from outside meets first; see negative_side.hpp). Time: (V - 3)^most.
[[nodiscard]] std::optional<OptimisationFinding> global_intersections_show_the_negative_side(
    const geometry::Surface& surface, std::size_t most);

/// Two surfaces on the same points, both convex up to flat edges, differ in flat edges only.
[[nodiscard]] std::optional<OptimisationFinding> convex_is_unique(const geometry::Surface& surface,
                                                                  const geometry::Surface& other);

/// Omega_abs = 2 pi (4 - chi), its least value for tight surfaces, just where no plane cuts the
/// surface into more than two pieces. Premise: no two neighbours coincide. O(V^4).
[[nodiscard]] std::optional<OptimisationFinding> tight_is_two_piece(
    const geometry::Surface& surface);

}  // namespace tightflip::properties
