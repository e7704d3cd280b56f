#include "descent.hpp"
#include <tightflip/geometry/composed_criteria.hpp>
#include <tightflip/geometry/convexify.hpp>
#include <tightflip/geometry/star_shaped.hpp>
#include <tightflip/geometry/strategy.hpp>
#include <tightflip/kernel/connect.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace tightflip::geometry {
namespace {

/// Other surfaces to start from, which a path of flips leads to.
enum class Detour : std::uint8_t { none, hull, star };

/// What a strategy consists of, in this order.
struct Plan {
    StrategyInfo info;
    bool looks_ahead = false;
    bool tries_both_orders = false;
    std::array<Detour, 2> detours{};  ///< the first that is possible
    bool needs_detour = false;
    bool alternates = false;
    bool kicks = false;
};

constexpr std::array plans{
    Plan{.info = {Strategy::automatic, "automatic",
                  "hull where wanted and possible; else star where possible, then alternate"},
         .looks_ahead = true,
         .tries_both_orders = true,
         .detours = {Detour::hull, Detour::star},
         .alternates = true},
    Plan{.info = {Strategy::local, "local", "flip what improves until nothing does"}},
    Plan{.info = {Strategy::look_ahead, "look_ahead",
                  "local, then flips that only pay together with others near them"},
         .looks_ahead = true},
    Plan{.info = {Strategy::alternate, "alternate",
                  "look_ahead in turn by area, edge length, mean curvature and the criterion"},
         .looks_ahead = true,
         .alternates = true},
    Plan{.info = {Strategy::kicks, "kicks", "automatic, then random flips, repaired nearby"},
         .looks_ahead = true,
         .tries_both_orders = true,
         .detours = {Detour::hull, Detour::star},
         .alternates = true,
         .kicks = true},
    Plan{.info = {Strategy::star, "star",
                  "look_ahead, from the start and from a star-shaped surface"},
         .looks_ahead = true,
         .detours = {Detour::star},
         .needs_detour = true},
    Plan{.info = {Strategy::hull, "hull", "a path to the convex hull of convex data"},
         .looks_ahead = true,
         .detours = {Detour::hull},
         .needs_detour = true},
};

constexpr auto infos = [] {
    std::array<StrategyInfo, plans.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = plans[i].info;
    return all;
}();

constexpr std::array hull_wanted_by{CriterionKind::tight, CriterionKind::mean_weighted,
                                    CriterionKind::volume};

Point centroid(Points points) {
    Point sum = Point::Zero();
    for (const Point& p : points)
        sum += p / static_cast<double>(points.size());
    return sum;
}

/// A path of flips, or why there is none.
struct Path {
    StrategyRefusal refusal{};
    std::vector<Edge> flips{};
    std::optional<OptimiseEnd> end{};  ///< a limit, on the way
};

Path path_to_star(const Triangulation& surface, Points points) {
    const auto star = star_shaped_surface({points.begin(), points.end()}, centroid(points));
    if (!star) return {.refusal = {StrategyFault::data, star.refusal()}};
    return {.flips = connect(surface, star.value().surface.triangulation()).value().flips};
}

Path path_to_hull(Triangulation surface, Points points, Effort& effort) {
    const OptimiseOptions rest = effort.rest();
    const ConvexifyOptions limits{
        .max_flips = rest.max_flips,
        .max_time = rest.max_time,
        .keep_going = [&](std::int64_t) { return effort.may_go_on(); },
    };
    ConvexifyResult result = convexify(surface, points, limits);
    switch (result.end) {
        case ConvexifyEnd::convex:
            return {.flips = std::move(result.flips)};
        case ConvexifyEnd::flip_limit:
            return {.end = OptimiseEnd::flip_limit};
        case ConvexifyEnd::time_limit:
            return {.end = OptimiseEnd::time_limit};
        case ConvexifyEnd::stopped:
            return {.end = OptimiseEnd::stopped};
        case ConvexifyEnd::not_a_sphere:
            return {.refusal = {StrategyFault::not_a_sphere}};
        case ConvexifyEnd::not_reached:
            return {.refusal = {StrategyFault::too_flat}};
        case ConvexifyEnd::unfit_data:
            break;
    }
    return {.refusal = {StrategyFault::data, result.data}};
}

/// Why no path can be taken that may need any flip.
StrategyFault what_blocks_paths(const Triangulation& surface, Points points, const Goal& goal,
                                const OptimiseOptions& options) {
    if (surface.genus() != 0) return StrategyFault::not_a_sphere;
    if (!options.locked.empty()) return StrategyFault::locked_edges;
    if (options.allowed != AllowedFlips::all) return StrategyFault::restricted_flips;
    if (!goal.may_forbid_flips) return StrategyFault::none;
    const auto criterion = goal.make({surface.table(), points});
    return forbids_flips(surface, *criterion) ? StrategyFault::restricted_flips
                                              : StrategyFault::none;
}

/// The energies along the flips made: summed up from the changes or, where few are asked for, from
/// scratch. To follow a flip costs a criterion about what four vertices cost it from scratch, and
/// much more at the hubs of paths.
std::vector<EnergyAt> trace(Triangulation surface, Points points, const Goal& goal,
                            const StrategyResult& result, std::int64_t every) {
    const bool from_scratch = 4 * every > surface.vertex_count();
    const auto criterion = goal.make({surface.table(), points});
    std::vector<EnergyAt> energies{{0, result.before}};
    Energy energy = result.before;
    std::int64_t done = 0;
    for (const Edge e : result.flips) {
        if (!from_scratch) energy += criterion->change(e);
        static_cast<void>(surface.flip(e));
        if (!from_scratch) criterion->flipped(e);
        if (++done % every != 0) continue;
        energies.push_back({done, from_scratch ? criterion->value() : energy});
    }
    if (energies.back().flips != done) energies.push_back({done, result.after});
    return energies;
}

/// Does the flips of a result that is known but for its trace.
StrategyResult with_flips_done(StrategyResult result, Triangulation& surface, Points points,
                               const Goal& goal, const OptimiseOptions& options) {
    if (options.trace_every > 0) {
        result.trace = trace(surface, points, goal, result, options.trace_every);
    }
    static_cast<void>(surface.flip_all(result.flips));
    return result;
}

struct Route {
    Detour detour = Detour::none;
    Path path{};
};

/// The first detour of the plan that is possible, or why the last is not. The hull is one where it
/// is wanted or asked for.
Route find_route(const Plan& plan, const Triangulation& surface, Points points, const Goal& goal,
                 const OptimiseOptions& options, Effort& effort) {
    Route route;
    for (const Detour detour : plan.detours) {
        const bool is_hull = detour == Detour::hull;
        if (detour == Detour::none || (is_hull && !plan.needs_detour && !goal.wants_hull)) {
            continue;
        }
        const StrategyFault blocked = what_blocks_paths(surface, points, goal, options);
        if (blocked != StrategyFault::none) return {Detour::none, {.refusal = {blocked}}};
        route.path =
            is_hull ? path_to_hull(surface, points, effort) : path_to_star(surface, points);
        if (route.path.end) return route;
        if (route.path.refusal.fault == StrategyFault::none) return {detour, std::move(route.path)};
    }
    return route;
}

}  // namespace

std::span<const StrategyInfo> all_strategies() {
    return infos;
}

const StrategyInfo& info(Strategy strategy) {
    return infos.at(static_cast<std::size_t>(strategy));
}

std::optional<Strategy> strategy_by_name(std::string_view name) {
    const auto* const found = std::ranges::find(infos, name, &StrategyInfo::name);
    if (found == infos.end()) return std::nullopt;
    return found->strategy;
}

Goal goal_by_text(const std::string& text, Vertex marked) {
    const auto kind = criterion_by_name(text);
    return {[text, marked](const SurfaceView& surface) {
                return parse_criterion(text, surface, marked);
            },
            kind && std::ranges::find(hull_wanted_by, *kind) != hull_wanted_by.end(),
            marked.is_valid()};
}

std::string message(const StrategyRefusal& refusal) {
    switch (refusal.fault) {
        case StrategyFault::none:
            return {};
        case StrategyFault::locked_edges:
            return "the strategy may have to flip any edge: lock none, or take another strategy";
        case StrategyFault::restricted_flips:
            return "the strategy needs all flips: allow them all, take a criterion that forbids "
                   "none, or take another strategy";
        case StrategyFault::not_a_sphere:
            return "the strategy is for genus 0 alone: take another strategy";
        case StrategyFault::data:
            return message(refusal.data) + ": take another strategy";
        case StrategyFault::too_flat:
            return message(ConvexifyResult{.end = ConvexifyEnd::not_reached}) +
                   ": take another strategy";
    }
    return {};
}

StrategyResult optimise_by(Strategy strategy, Triangulation& surface, Points points,
                           const Goal& goal, const OptimiseOptions& options) {
    const Plan& plan = plans.at(static_cast<std::size_t>(strategy));
    StrategyResult result;
    result.used = strategy == Strategy::automatic ? Strategy::alternate : strategy;
    result.before = goal.make({surface.table(), points})->value();
    result.after = result.before;

    Effort effort(options, result.before);
    const Route route = find_route(plan, surface, points, goal, options, effort);
    if (plan.needs_detour && route.path.refusal.fault != StrategyFault::none) {
        result.refusal = route.path.refusal;
        return result;
    }
    // With fewer flips than that something may still be done.
    if (route.path.end && *route.path.end != OptimiseEnd::flip_limit) effort.stop(*route.path.end);

    if (route.detour == Detour::hull && goal.wants_hull) {
        result.flips = route.path.flips;
        if (strategy == Strategy::automatic) result.used = Strategy::hull;
        Triangulation hull = surface;
        static_cast<void>(hull.flip_all(result.flips));
        result.after = goal.make({hull.table(), points})->value();
        return with_flips_done(std::move(result), surface, points, goal, options);
    }

    Descent direct(surface, points, goal, options, effort);
    OptimiseOptions reordered_options = options;
    reordered_options.order =
        options.order == FlipOrder::first ? FlipOrder::best : FlipOrder::first;
    std::optional<Descent> reordered;
    std::optional<Descent> detour;
    if (route.detour != Detour::none) detour.emplace(surface, points, goal, options, effort);
    Descent* best = &direct;
    direct.descend(plan.looks_ahead);
    if (plan.tries_both_orders && !effort.end()) {
        reordered.emplace(surface, points, goal, reordered_options, effort);
        reordered->descend(plan.looks_ahead);
        if (reordered->best() < direct.best()) best = &*reordered;
    }
    if (detour && detour->follow(route.path.flips)) {
        detour->descend(plan.looks_ahead);
        if (detour->best() < best->best()) best = &*detour;
    }
    if (plan.alternates) best->alternate();
    if (plan.kicks) best->kick();
    best->go_back_to_best();

    if (strategy == Strategy::automatic && detour && best == &*detour) {
        result.used = route.detour == Detour::hull ? Strategy::hull : Strategy::star;
    }
    result.flips = std::move(best->flips());
    for (const Descent* descent :
         {&direct, reordered ? &*reordered : nullptr, detour ? &*detour : nullptr}) {
        if (descent != nullptr) result.evaluated += descent->evaluated();
    }
    result.end = effort.end().value_or(route.path.end.value_or(OptimiseEnd::local_minimum));
    result.after = best->energy();
    return with_flips_done(std::move(result), surface, points, goal, options);
}

}  // namespace tightflip::geometry
