/// \file
/// Distances in a finite flip graph: components, radius, diameter, who is far out.
#pragma once

#include <tightflip/kernel/flip_graph_table.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace tightflip::kernel {

using Distance = std::uint16_t;
inline constexpr Distance unreached = 0xffff;

/// Distances from a state by breadth-first search; `unreached` where there is no path. Linear time.
[[nodiscard]] std::vector<Distance> distances_from(const FlipGraphTable& graph,
                                                   std::uint32_t source);

/// The number of each state's component, in the order of their least states.
struct Components {
    std::vector<std::uint32_t> of;
    std::vector<std::uint32_t> least;  ///< by component, its least state

    [[nodiscard]] std::size_t count() const noexcept { return least.size(); }
};
/// Precondition: arcs are there in both directions, as flips are. Linear time.
[[nodiscard]] Components components(const FlipGraphTable& graph);

/// What a search from one state tells of all. In a graph of classes both distances are the same. In
/// a labelled graph states stand for all their labellings, whose eccentricities are equal; `near`
/// is the distance to the nearest labelling and `far` to the farthest.
struct Reach {
    std::vector<Distance> near;
    std::vector<Distance> far;
};

/// What is known of the eccentricities of a connected graph.
struct Eccentricities {
    std::vector<Distance> lower;
    std::vector<Distance> upper;
    std::size_t searches = 0;  ///< that it took
    Distance radius = 0;
    Distance diameter = 0;

    [[nodiscard]] bool is_exact(std::size_t state) const noexcept {
        return lower[state] == upper[state];
    }
    /// The states whose eccentricity is the diameter; all of them, in ascending order.
    [[nodiscard]] std::vector<std::uint32_t> peripheral() const;
    /// How many states have each eccentricity, as far as that was decided on the way.
    [[nodiscard]] std::vector<std::size_t> counts() const;
};

enum class EccentricityGoal : std::uint8_t {
    extremes,  ///< radius, diameter and peripheral states, exactly
    all,       ///< every state's eccentricity
};

/// Bounds eccentricities by searches from few states until the goal is met: a search from s with
/// eccentricity e leaves max(far(x), e - near(x)) <= ecc(x) <= e + near(x) (Takes and Kosters,
/// Algorithms 6 (2013)). `search` is called on several threads at once where `threads` says so;
/// the result does not depend on it. Precondition: the graph is connected and has states.
[[nodiscard]] Eccentricities bound_eccentricities(
    std::size_t states, const std::function<Reach(std::uint32_t)>& search, EccentricityGoal goal,
    unsigned threads, const std::function<void(const Eccentricities&)>& progress = {});

}  // namespace tightflip::kernel
