/// \file
/// Local edge flipping on a criterion (Alboul et al., section 5): flip what improves until nothing
/// does.
#pragma once

#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/surface.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace tightflip::geometry {

/// Which of the flips that improve is done next.
enum class FlipOrder : std::uint8_t {
    first,  ///< that of the edge that has waited longest
    best,   ///< the one that improves most
};

/// Which flips are allowed.
enum class AllowedFlips : std::uint8_t {
    all,       ///< every EDF
    simple,    ///< those that make no parallel edge
    embedded,  ///< those after which an embedded surface is embedded still; linear time each
};

struct OptimiseOptions {
    FlipOrder order = FlipOrder::first;
    AllowedFlips allowed = AllowedFlips::all;
    std::span<const Edge> locked{};  ///< never flipped
    /// Shuffles the order in which edges wait at first; 0 leaves them in that of their numbers.
    std::uint64_t seed = 0;
    /// Smaller improvements count as none. Empty: 0 for criteria with exact signs, and for others
    /// 1e-12 of what an edge has of the value on average, well above what roundings can do.
    std::optional<double> least_gain{};
    std::int64_t max_flips = std::numeric_limits<std::int64_t>::max();
    std::chrono::duration<double> max_time = std::chrono::duration<double>::max();
    /// Called after each flip with the flips done and the energy, from `before` and the changes
    /// since; false stops.
    std::function<bool(std::int64_t flips, const Energy& energy)> keep_going{};
    /// The energy is traced before the first flip, after every so many, and at the end; 0: not.
    std::int64_t trace_every = 0;
};

/// The energy after so many flips, from that before and the changes since.
struct EnergyAt {
    std::int64_t flips = 0;
    Energy energy;

    friend bool operator==(const EnergyAt&, const EnergyAt&) = default;
};

/// Why it ended.
enum class OptimiseEnd : std::uint8_t {
    local_minimum,  ///< no allowed flip improves
    flip_limit,
    time_limit,
    stopped,  ///< `keep_going` said so
};

struct OptimiseResult {
    OptimiseEnd end = OptimiseEnd::local_minimum;
    std::vector<Edge> flips;  ///< in order: with the triangulation before, a FlipLog
    Energy before;
    Energy after;                 ///< from scratch
    std::vector<EnergyAt> trace;  ///< in order of flips; empty unless asked for
    std::int64_t evaluated = 0;   ///< changes asked of the criterion
};

/// Flips edges of the surface that `criterion` is bound to. Only edges whose change may be another
/// after a flip are looked at again. The same for equal arguments, but for `max_time`. Every flip
/// improves the energy, so that none is done for ever. (Roundings can say so falsely: each four
/// flips an edge the value is taken from scratch, and where it has not fallen the flips since are
/// taken back, and that is the end.) Stopped, it goes on when called again, from where it was but
/// with all edges waiting anew. Per flip 5 to 20 changes are asked of the criterion, and O(log n)
/// more time passes where the best is wanted.
[[nodiscard]] OptimiseResult optimise(Triangulation& surface, Points points, Criterion& criterion,
                                      const OptimiseOptions& options = {});

}  // namespace tightflip::geometry
