#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/properties/negative_side.hpp>
#include <tightflip/properties/optimisation_claims.hpp>
#include <tightflip/properties/plane_pieces.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

namespace tightflip::properties {
namespace {

using geometry::Criterion;
using geometry::CriterionKind;
using geometry::EdgeShape;
using geometry::FlatEdges;
using geometry::Point;
using geometry::Points;
using geometry::SelfIntersections;
using geometry::Surface;
using geometry::SurfaceView;
using kernel::Edge;
using kernel::Index;
using kernel::Triangulation;

using Result = std::optional<OptimisationFinding>;

/// Changes of Tight of at most this size count as none: far above roundings and far below what was
/// ever met for the best flip.
constexpr double least_change = 1e-11;

template <class... Parts>
Result found(OptimisationClaim claim, const Parts&... parts) {
    std::ostringstream out;
    out.precision(17);
    (out << ... << parts);
    return OptimisationFinding{claim, 0, out.str()};
}

bool is_sphere_on_convex_data(const Surface& surface) {
    return surface.triangulation().genus() == 0 && geometry::is_convex_data(surface.points());
}

bool is_embedded_on_convex_data(const Surface& surface) {
    return is_sphere_on_convex_data(surface) && geometry::is_embedded(surface.view());
}

std::int64_t global_count(const SurfaceView& surface) {
    return geometry::find_self_intersections(surface, 0).global_count;
}

/// Whether a flip that lowers Tight is among those that `allowed` admits.
template <class Allowed>
bool has_lowering_flip(const Surface& surface, Allowed&& allowed) {
    const auto tight = make_criterion(CriterionKind::tight, surface.view());
    for (Index id = 0; id < surface.triangulation().edge_count(); ++id) {
        const Edge e{id};
        if (!surface.triangulation().can_flip(e)) continue;
        if (tight->change(e).first() < -least_change && allowed(e)) return true;
    }
    return false;
}

double tight_value(const SurfaceView& surface) {
    return make_criterion(CriterionKind::tight, surface)->value().first();
}

bool has_coincident_neighbours(const SurfaceView& surface) {
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        if (surface.origin({id}) == surface.target({id})) return true;
    }
    return false;
}

/// The ends of all bent edges, each ascending, in ascending order.
std::vector<std::pair<Index, Index>> bent_edges(const Surface& surface) {
    std::vector<std::pair<Index, Index>> ends;
    for (Index id = 0; id < surface.triangulation().edge_count(); ++id) {
        if (edge_shape(surface.view(), Edge{id}) == EdgeShape::flat) continue;
        const kernel::Halfedge h = kernel::halfedge_of(Edge{id});
        ends.emplace_back(std::minmax(
            {surface.triangulation().origin(h).id, surface.triangulation().target(h).id}));
    }
    std::ranges::sort(ends);
    return ends;
}

}  // namespace

std::string_view name(OptimisationClaim claim) {
    static constexpr std::array<std::string_view, 8> names{
        "tight_is_global",
        "tight_is_global_while_embedded",
        "concave_flips_do_not_raise_tight",
        "tight_search_ends_convex",
        "flips_keep_intersections_local",
        "global_intersections_show_the_negative_side",
        "convex_is_unique",
        "tight_is_two_piece"};
    return names.at(static_cast<std::size_t>(claim) -
                    static_cast<std::size_t>(OptimisationClaim::tight_is_global));
}

std::string describe(const OptimisationFinding& finding) {
    return "after " + std::to_string(finding.step) +
           " flips: " + std::to_string(static_cast<int>(finding.claim)) + " " +
           std::string(name(finding.claim)) + ": " + finding.detail;
}

Convexity convexity(const SurfaceView& surface) {
    if (is_convex_surface(surface, FlatEdges::admitted)) return Convexity::convex;
    // The reflection through the origin turns a surface inside out.
    std::vector<Point> reflected;
    reflected.reserve(surface.points.size());
    for (const Point& point : surface.points)
        reflected.emplace_back(-point);
    return is_convex_surface({surface.table, reflected}, FlatEdges::admitted)
               ? Convexity::inside_out
               : Convexity::none;
}

Result tight_is_global(const Surface& surface) {
    if (!is_embedded_on_convex_data(surface)) return std::nullopt;
    if (convexity(surface.view()) != Convexity::none) return std::nullopt;
    if (has_lowering_flip(surface, [](Edge) { return true; })) return std::nullopt;
    return found(OptimisationClaim::tight_is_global,
                 "no flip lowers Omega_abs = ", tight_value(surface.view()));
}

Result tight_is_global_while_embedded(const Surface& surface) {
    if (!is_embedded_on_convex_data(surface)) return std::nullopt;
    if (convexity(surface.view()) != Convexity::none) return std::nullopt;
    const auto keeps_embedded = [&](Edge e) { return flip_keeps_embedded(surface.view(), e); };
    if (has_lowering_flip(surface, keeps_embedded)) return std::nullopt;
    return found(OptimisationClaim::tight_is_global_while_embedded,
                 "no flip to an embedded surface lowers Omega_abs = ", tight_value(surface.view()));
}

Result concave_flips_do_not_raise_tight(const Surface& surface) {
    if (!is_embedded_on_convex_data(surface) || measure(surface.view()).volume < 0) {
        return std::nullopt;
    }
    const auto tight = make_criterion(CriterionKind::tight, surface.view());
    for (Index id = 0; id < surface.triangulation().edge_count(); ++id) {
        if (edge_shape(surface.view(), Edge{id}) != EdgeShape::concave) continue;
        const double change = tight->change(Edge{id}).first();
        if (change <= least_change) continue;
        return found(OptimisationClaim::concave_flips_do_not_raise_tight, "the flip of edge ", id,
                     " changes Omega_abs by ", change);
    }
    return std::nullopt;
}

Result tight_search_ends_convex(Surface start, geometry::FlipOrder order) {
    if (!is_sphere_on_convex_data(start) || global_count(start.view()) > 0) return std::nullopt;
    const std::vector<Point> points(start.points().begin(), start.points().end());
    Triangulation surface = start.triangulation();
    const auto tight = make_criterion(CriterionKind::tight, {surface.table(), points});
    const auto run = optimise(surface, points, *tight, {.order = order});
    if (convexity({surface.table(), points}) != Convexity::none) return std::nullopt;
    Result result = found(OptimisationClaim::tight_search_ends_convex,
                          "ends at Omega_abs = ", run.after.first(), " and is not convex");
    result->step = run.flips.size();
    return result;
}

Result flips_keep_intersections_local(Surface start, std::span<const Edge> script) {
    if (!is_sphere_on_convex_data(start) || global_count(start.view()) > 0) return std::nullopt;
    const auto tight = make_criterion(CriterionKind::tight, start.view());
    for (std::size_t step = 0; step < script.size(); ++step) {
        const Edge e = script[step];
        if (!start.triangulation().can_flip(e)) return std::nullopt;
        const double change = tight->change(e).first();
        if (change >= -least_change) return std::nullopt;
        static_cast<void>(start.triangulation().flip(e));
        tight->flipped(e);
        const SelfIntersections now = geometry::find_self_intersections(start.view(), 0);
        if (now.global_count == 0) continue;
        Result result =
            found(OptimisationClaim::flips_keep_intersections_local, "the flip of edge ", e.id,
                  " changes Omega_abs by ", change, " and makes ", now.global_count, " global and ",
                  now.local_count, " local self-intersections");
        result->step = step + 1;
        return result;
    }
    return std::nullopt;
}

Result global_intersections_show_the_negative_side(const Surface& surface, std::size_t most) {
    const std::int64_t count = global_count(surface.view());
    if (count == 0) return std::nullopt;
    const auto tetrahedra = as_sum_of_tetrahedra(surface.view(), most);
    if (!tetrahedra) return std::nullopt;
    return found(OptimisationClaim::global_intersections_show_the_negative_side, count,
                 " global self-intersections of a sum of ", tetrahedra->size(), " tetrahedra");
}

Result convex_is_unique(const Surface& surface, const Surface& other) {
    if (!std::ranges::equal(surface.points(), other.points()) ||
        !is_convex_surface(surface.view(), FlatEdges::admitted) ||
        !is_convex_surface(other.view(), FlatEdges::admitted)) {
        return std::nullopt;
    }
    if (bent_edges(surface) == bent_edges(other)) return std::nullopt;
    return found(OptimisationClaim::convex_is_unique,
                 "two convex surfaces on the same points differ in edges that are not flat");
}

Result tight_is_two_piece(const Surface& surface) {
    if (has_coincident_neighbours(surface.view())) return std::nullopt;
    const int euler = surface.triangulation().euler_characteristic();
    const double least = 2 * std::numbers::pi * (4 - euler);
    const double value = tight_value(surface.view());
    const PlaneCut cut = most_pieces(surface.view());
    if ((value < least + 1e-9) == (cut.pieces() <= 2)) return std::nullopt;
    return found(OptimisationClaim::tight_is_two_piece, "Omega_abs = ", value, ", least ", least,
                 ", pieces ", cut.pieces());
}

}  // namespace tightflip::properties
