#include "optimise.hpp"

#include "script_input.hpp"
#include "targets.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/invariants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <stdexcept>

namespace tightflip::fuzz {
namespace {

using geometry::AllowedFlips;
using geometry::Energy;
using geometry::FlipOrder;
using geometry::OptimiseEnd;
using geometry::Strategy;
using geometry::StrategyFault;
using geometry::StrategyResult;
using geometry::Surface;
using kernel::Edge;
using kernel::Index;

constexpr Layout layout{.head = 11, .record = 2, .most_records = most_locked_edges};

/// In this order for ever: bytes name them by number.
constexpr std::array criteria{"tight",
                              "mean",
                              "mean_weighted",
                              "area",
                              "edge_length",
                              "volume",
                              "abn",
                              "abn_squares",
                              "delaunay",
                              "min_angle",
                              "area+0.5*edge_length",
                              "tight,mean",
                              "mean,area,volume"};

constexpr std::array allowed_flips{AllowedFlips::all, AllowedFlips::simple, AllowedFlips::embedded};

/// A run stops after so many flips at most, those taken back included.
constexpr std::uint32_t flips_a_step = 2;
constexpr std::uint32_t number_of_steps = 64;
constexpr std::int64_t most_flips_of_a_run = 64;

constexpr Index most_optimised_vertices = 6;

/// Points for which every predicate takes long exact arithmetic, so that longer searches would take
/// seconds.
constexpr std::array slow_points{"huge", "tiny", "subnormal", "wild"};

bool is_forbidden_or_nan(const Energy& energy) {
    return std::ranges::any_of(energy.levels, [](double level) { return !std::isfinite(level); });
}

/// Whether `a` is greater than `b`, in the first level in which they differ, by more than
/// roundings. (Energies are compared so: what rounds differently in one level hides the next.)
bool is_clearly_more(const Energy& a, const Energy& b) {
    for (std::size_t i = 0; i < Energy::max_levels; ++i) {
        const double difference = a.levels.at(i) - b.levels.at(i);
        if (difference == 0) continue;
        return difference > 1e-9 * (1 + std::abs(a.levels.at(i)) + std::abs(b.levels.at(i)));
    }
    return false;
}

bool is_simple(const Surface& surface) {
    return audit(surface.triangulation()).is_simple().value();
}

std::string flips_are_as_allowed(const OptimiseCase& run, const Surface& before,
                                 const Surface& after, const StrategyResult& result) {
    for (const Edge e : run.locked) {
        if (std::ranges::find(result.flips, e) != result.flips.end()) {
            return "locked_edges_stay: edge " + std::to_string(e.id);
        }
    }
    if (run.options.allowed == AllowedFlips::simple && is_simple(before) && !is_simple(after)) {
        return "simple_flips_keep_graphs_simple: they do not";
    }
    if (run.options.allowed == AllowedFlips::embedded && is_embedded(before.view()) &&
        !is_embedded(after.view())) {
        return "embedded_flips_keep_surfaces_embedded: they do not";
    }
    return {};
}

std::string energies_are_right(const OptimiseCase& run, const Surface& before, const Surface& after,
                               const StrategyResult& result) {
    const auto value_of = [&](const Surface& surface) {
        return geometry::goal_by_text(run.criterion).make(surface.view())->value();
    };
    const Energy first = value_of(before);
    const Energy last = value_of(after);
    if (is_forbidden_or_nan(first) || is_forbidden_or_nan(last)) return {};  // beyond doubles
    if (is_clearly_more(first, result.before) || is_clearly_more(result.before, first) ||
        is_clearly_more(last, result.after) || is_clearly_more(result.after, last)) {
        return "energies_are_those_of_the_ends: they are not";
    }
    const bool takes_hull = geometry::goal_by_text(run.criterion).wants_hull &&
                            (result.used == Strategy::hull || run.strategy == Strategy::hull);
    if (!takes_hull && is_clearly_more(last, first)) return "energy_does_not_rise: it does";
    return {};
}

std::string hull_is_certified(const OptimiseCase& run, const Surface& after,
                              const StrategyResult& result) {
    if (run.strategy != Strategy::hull || result.end != OptimiseEnd::local_minimum ||
        result.refusal.fault != StrategyFault::none ||
        !geometry::goal_by_text(run.criterion).wants_hull) {
        return {};
    }
    return is_convex_surface(after.view(), geometry::FlatEdges::admitted)
               ? std::string()
               : "the_way_to_the_hull_ends_there: it does not";
}

std::string log_leads_there(const Surface& before, const Surface& after,
                            const StrategyResult& result) {
    const kernel::Replay followed = replay(kernel::FlipLog{before.triangulation(), result.flips});
    if (!followed.is_complete()) return "logs_of_runs_replay: " + followed.reason;
    if (!(followed.surface == after.triangulation())) return "logs_lead_to_the_result: no";
    const auto topology = audit(before.triangulation()).topology;
    if (const auto violation = properties::first_violation(after.triangulation(), topology)) {
        return "topology_is_preserved: " + message(*violation);
    }
    return {};
}

std::string objection_to_result(const OptimiseCase& run, const Surface& before,
                                const Surface& after, const StrategyResult& result) {
    if (result.refusal.fault != StrategyFault::none) {
        return after.triangulation() == before.triangulation() && result.flips.empty() &&
                       !message(result.refusal).empty()
                   ? std::string()
                   : "refused_strategies_do_nothing: this one did";
    }
    if (static_cast<std::int64_t>(result.flips.size()) > run.options.max_flips) {
        return "runs_keep_to_their_limit: " + std::to_string(result.flips.size()) + " flips";
    }
    for (const std::string& objection :
         {log_leads_there(before, after, result), flips_are_as_allowed(run, before, after, result),
          energies_are_right(run, before, after, result), hull_is_certified(run, after, result)}) {
        if (!objection.empty()) return objection;
    }
    return {};
}

// ---- seeds ----

struct SeedBytes {
    StartBytes start;
    std::string_view points;
    std::uint8_t criterion = 0;
    std::uint8_t strategy = 0;
    std::uint8_t flags = 0;
    std::uint8_t steps = number_of_steps - 1;
};

InputBytes bytes_of(const SeedBytes& seed) {
    InputBytes bytes = script_input(seed.start);
    const auto kinds = properties::point_kinds();
    const auto* const kind = properties::find_point_kind(seed.points);
    bytes.push_back(static_cast<std::uint8_t>(kind - kinds.data()));
    bytes.insert(bytes.end(), {7, seed.criterion, seed.strategy, seed.flags, seed.steps});
    return bytes;
}

std::vector<Seed> seeds() {
    std::vector<Seed> seeds;
    const StartBytes sphere{"random", 5, 0, 1};
    for (std::size_t c = 0; c < criteria.size(); ++c) {
        for (const geometry::StrategyInfo& strategy : geometry::all_strategies()) {
            const auto s = static_cast<std::uint8_t>(strategy.strategy);
            seeds.push_back({"criterion_" + std::to_string(c) + "_" + std::string(strategy.name),
                             bytes_of({sphere, c % 2 == 0 ? "sphere" : "general",
                                       static_cast<std::uint8_t>(c), s})});
        }
    }
    for (const properties::PointKind& points : properties::point_kinds()) {
        for (const std::uint8_t strategy : {std::uint8_t{0}, std::uint8_t{6}}) {
            seeds.push_back(
                {"points_" + std::string(points.name) + "_strategy_" + std::to_string(strategy),
                 bytes_of({sphere, points.name, 0, strategy})});
        }
    }
    for (std::uint8_t flags = 0; flags < 6; ++flags) {
        InputBytes bytes = bytes_of({{"stacked", 6, 0, 2}, "general", 0, 2, flags});
        append_pair(bytes, 3);
        append_pair(bytes, 11);
        seeds.push_back({"locked_flags_" + std::to_string(flags), bytes});
        seeds.push_back({"genus_two_flags_" + std::to_string(flags),
                         bytes_of({{"genus", 4, 2, 2}, "general", 3, 3, flags})});
    }
    seeds.push_back({"no_flips_allowed", bytes_of({sphere, "general", 3, 1, 0, 0})});
    seeds.push_back({"hull_stopped", bytes_of({sphere, "sphere", 0, 6, 0, 1})});
    return seeds;
}

}  // namespace

OptimiseCase decode_optimise(Input input) {
    Bytes bytes = Bytes::after_version(input.first(std::min(input.size(), layout.most_bytes())));
    OptimiseCase run;
    run.surface.flips = decode_start(bytes);
    run.surface.flips.request.vertices =
        std::min(run.surface.flips.request.vertices, most_optimised_vertices);
    const auto kinds = properties::point_kinds();
    run.surface.point_kind = &kinds[bytes.byte() % kinds.size()];
    run.surface.point_seed = bytes.byte();
    run.criterion = criteria.at(bytes.byte() % criteria.size());
    const auto strategies = geometry::all_strategies();
    run.strategy = strategies[bytes.byte() % strategies.size()].strategy;
    const bool is_slow =
        std::ranges::find(slow_points, run.surface.point_kind->name) != slow_points.end();
    if (is_slow && run.strategy != Strategy::hull) run.strategy = Strategy::local;
    const std::uint32_t flags = bytes.byte();
    run.options.allowed = allowed_flips.at(flags % allowed_flips.size());
    run.options.order = flags / allowed_flips.size() % 2 == 0 ? FlipOrder::first : FlipOrder::best;
    run.options.seed = flags / (2 * allowed_flips.size());
    run.options.max_flips = std::min(std::int64_t{flips_a_step} * (bytes.byte() % number_of_steps),
                                     most_flips_of_a_run);
    const Index edges = start_of(run.surface.flips).edge_count();
    while (!bytes.empty())
        run.locked.push_back({static_cast<Index>(bytes.pair()) % edges});
    return run;
}

std::string optimise_objection(const OptimiseCase& run) {
    const kernel::Triangulation& start = start_of(run.surface.flips);
    const Surface before(
        start, run.surface.point_kind->make(start.vertex_count(), run.surface.point_seed));
    Surface after = before;
    geometry::OptimiseOptions options = run.options;
    options.locked = run.locked;
    const StrategyResult result = optimise_by(run.strategy, after.triangulation(), after.points(),
                                              geometry::goal_by_text(run.criterion), options);
    return objection_to_result(run, before, after, result);
}

const Target optimise_target{
    .name = "optimise",
    .description =
        "a surface with points of any kind, a criterion and a strategy: topology, "
        "limits, energies, the log and the hull's certificate",
    .layout = layout,
    .objection = [](Input input) { return optimise_objection(decode_optimise(input)); },
    .show =
        [](std::ostream& out, Input input) {
            const OptimiseCase run = decode_optimise(input);
            out << describe(run.surface) << "\nminimise " << run.criterion << " by "
                << info(run.strategy).name << ", at most " << run.options.max_flips
                << " flips, seed " << run.options.seed
                << (run.options.order == FlipOrder::best ? ", best first" : "")
                << (run.options.allowed == AllowedFlips::simple     ? ", simple"
                    : run.options.allowed == AllowedFlips::embedded ? ", embedded"
                                                                    : "")
                << "\nlocked:";
            for (const Edge e : run.locked)
                out << ' ' << e.id;
            out << '\n';
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
