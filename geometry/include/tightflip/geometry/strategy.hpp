/// \file
/// Optimisation that does not end where plain local search sticks: named strategies over any
/// criterion, for surfaces of any genus. docs/optimisation.md says what each is good for, measured.
#pragma once

#include <tightflip/geometry/data_refusal.hpp>
#include <tightflip/geometry/optimise.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tightflip::geometry {

enum class Strategy : std::uint8_t { automatic, local, look_ahead, alternate, kicks, star, hull };

struct StrategyInfo {
    Strategy strategy{};
    std::string_view name;
    std::string_view description;  ///< one line
};

// clang-format off
/// All strategies, in the order of the enumeration.
///
/// | name       | what it does |
/// |------------|--------------|
/// | automatic  | `hull` where that is wanted and possible; else `look_ahead` in both flip orders, `star` where it is possible, and `alternate` from the best of these ends |
/// | local      | flips what improves until nothing does: `optimise` |
/// | look_ahead | `local`, then flips that do not improve where others near them make good for it |
/// | alternate  | `look_ahead`, then rounds of it by area, by edge length, by length-weighted mean curvature and by the criterion again, until a round helps by less than a thousandth |
/// | kicks      | `automatic`, then random flips of three edges near one another, repaired nearby and taken back where that does not help; 30 a vertex |
/// | star       | genus 0: `look_ahead`, and again from the star-shaped surface about the centroid, which a path of flips leads to; the better of the two |
/// | hull       | convex data, genus 0: a path to the convex hull (convexify.hpp), and where that is not what is wanted `look_ahead` from both ends, the better of the two |
// clang-format on
[[nodiscard]] std::span<const StrategyInfo> all_strategies();

[[nodiscard]] const StrategyInfo& info(Strategy strategy);

/// The strategy of that name; empty where there is none.
[[nodiscard]] std::optional<Strategy> strategy_by_name(std::string_view name);

/// Binds the wanted criterion to a surface: always one that is as at the start.
using CriterionMaker = std::function<std::unique_ptr<Criterion>(const SurfaceView&)>;

struct Goal {
    CriterionMaker make;
    /// Whether the convex hull is what is wanted where the data are convex.
    bool wants_hull = false;
    /// Whether there may be flips that the criterion does not allow, which all edges are then
    /// asked.
    bool may_forbid_flips = true;
};

/// The criterion that `parse_criterion` makes of the text. The hull is wanted by tight and
/// mean_weighted, which have their least values there, and by volume, for which only surfaces that
/// wind about it more than once have less.
[[nodiscard]] Goal goal_by_text(const std::string& text, Vertex marked = {});

/// Why a strategy cannot be followed. Values are stable.
enum class StrategyFault : std::uint8_t {
    none = 0,
    locked_edges = 1,  ///< a path of flips may need any edge
    restricted_flips =
        2,             ///< and any flip: by the options, or by the criterion, not all are allowed
    not_a_sphere = 3,  ///< the construction is for genus 0
    data = 4,          ///< see `StrategyRefusal::data`
    too_flat = 5,      ///< points too close to flat for coordinates to tell an axis
};

struct StrategyRefusal {
    StrategyFault fault = StrategyFault::none;
    DataRefusal data{};

    friend bool operator==(const StrategyRefusal&, const StrategyRefusal&) = default;
};

/// One line of plain words that says what would help; empty where nothing is wrong.
[[nodiscard]] std::string message(const StrategyRefusal& refusal);

/// `flips` lead from the surface before to the surface after; `before` and `after` are the wanted
/// criterion's; `evaluated` counts all that was asked of any criterion.
struct StrategyResult : OptimiseResult {
    Strategy used = Strategy::local;  ///< for `automatic`, whose end it is: hull, star or alternate
    StrategyRefusal refusal{};        ///< with a fault nothing was done
};

/// Optimises by a strategy. Never ends with more energy than it starts with, nor than `optimise`
/// ends with for the same options. The hull where it is wanted is an exception: it is taken for any
/// energy, and a limit that stops the path to it leaves the surface as it was, for such a path is
/// of no use before its end.
///
/// Locked edges and the flips allowed are kept to throughout. `order` and `seed` are those of the
/// local searches; kicks draw from the seed too. `least_gain` is the wanted criterion's. The limits
/// are for the whole: `max_flips` counts all flips made, those taken back included, and so does
/// `keep_going`, which is told the least energy so far, and is
/// asked now and then where no flips are made. When a limit is reached the surface is left
/// with the best found until then. The same for equal arguments, but for `max_time`.
///
/// For cost see docs/optimisation.md; memory is linear in the surface and the flips.
[[nodiscard]] StrategyResult optimise_by(Strategy strategy, Triangulation& surface, Points points,
                                         const Goal& goal, const OptimiseOptions& options = {});

}  // namespace tightflip::geometry
