#include "parallel.hpp"
#include <tightflip/kernel/flip_graph_distances.hpp>

#include <algorithm>
#include <array>
#include <compare>

namespace tightflip::kernel {
namespace {

/// Chooses where to search next: with the extremes in turn from the side of the diameter and the
/// side of the radius, each time where the bounds leave most room.
class Bounds {
public:
    explicit Bounds(std::size_t states) {
        known_.lower.assign(states, 0);
        known_.upper.assign(states, unreached);
        known_.radius = unreached;
    }

    [[nodiscard]] const Eccentricities& known() const noexcept { return known_; }

    void take_in(std::uint32_t source, const Reach& reach) {
        const Distance e = *std::ranges::max_element(reach.far);
        for (std::size_t i = 0; i < known_.lower.size(); ++i) {
            const int near = reach.near[i];
            known_.lower[i] = std::max(
                {known_.lower[i], reach.far[i], static_cast<Distance>(std::max(0, e - near))});
            known_.upper[i] = std::min(known_.upper[i], static_cast<Distance>(e + near));
        }
        known_.lower[source] = known_.upper[source] = e;
        known_.diameter = std::max(known_.diameter, e);
        known_.radius = std::min(known_.radius, e);
        ++known_.searches;
    }

    /// The next sources, at most two; none when the goal is met.
    [[nodiscard]] std::vector<std::uint32_t> next(EccentricityGoal goal) const {
        std::optional<std::uint32_t> outer;
        std::optional<std::uint32_t> inner;
        for (std::uint32_t i = 0; i < known_.lower.size(); ++i) {
            if (known_.is_exact(i)) continue;
            const bool is_wanted = goal == EccentricityGoal::all;
            if ((is_wanted || known_.upper[i] >= known_.diameter) &&
                (!outer || outwards(i) > outwards(*outer))) {
                outer = i;
            }
            if ((is_wanted || known_.lower[i] < known_.radius) &&
                (!inner || inwards(i) < inwards(*inner))) {
                inner = i;
            }
        }
        std::vector<std::uint32_t> sources;
        if (outer) sources.push_back(*outer);
        if (inner && inner != outer) sources.push_back(*inner);
        return sources;
    }

private:
    using Key = std::array<Distance, 2>;
    [[nodiscard]] Key outwards(std::uint32_t i) const { return {known_.upper[i], known_.lower[i]}; }
    [[nodiscard]] Key inwards(std::uint32_t i) const { return {known_.lower[i], known_.upper[i]}; }

    Eccentricities known_;
};

}  // namespace

std::vector<Distance> distances_from(const FlipGraphTable& graph, std::uint32_t source) {
    std::vector<Distance> distances(graph.size(), unreached);
    std::vector<std::uint32_t> queue{source};
    distances[source] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const auto next = static_cast<Distance>(distances[queue[i]] + 1);
        for (const std::uint32_t state : graph.row(queue[i])) {
            if (distances[state] != unreached) continue;
            distances[state] = next;
            queue.push_back(state);
        }
    }
    return distances;
}

Components components(const FlipGraphTable& graph) {
    constexpr auto none = ~std::uint32_t{0};
    Components result;
    result.of.assign(graph.size(), none);
    std::vector<std::uint32_t> pending;
    for (std::uint32_t first = 0; first < graph.size(); ++first) {
        if (result.of[first] != none) continue;
        const auto number = static_cast<std::uint32_t>(result.least.size());
        result.least.push_back(first);
        result.of[first] = number;
        pending.assign(1, first);
        while (!pending.empty()) {
            const std::uint32_t state = pending.back();
            pending.pop_back();
            for (const std::uint32_t neighbour : graph.row(state)) {
                if (result.of[neighbour] != none) continue;
                result.of[neighbour] = number;
                pending.push_back(neighbour);
            }
        }
    }
    return result;
}

std::vector<std::uint32_t> Eccentricities::peripheral() const {
    std::vector<std::uint32_t> states;
    for (std::uint32_t i = 0; i < lower.size(); ++i) {
        if (lower[i] == diameter) states.push_back(i);
    }
    return states;
}

std::vector<std::size_t> Eccentricities::counts() const {
    std::vector<std::size_t> counts(std::size_t{diameter} + 1);
    for (std::size_t i = 0; i < lower.size(); ++i) {
        if (is_exact(i)) ++counts[lower[i]];
    }
    return counts;
}

Eccentricities bound_eccentricities(std::size_t states,
                                    const std::function<Reach(std::uint32_t)>& search,
                                    EccentricityGoal goal, unsigned threads,
                                    const std::function<void(const Eccentricities&)>& progress) {
    Bounds bounds(states);
    std::vector<std::uint32_t> sources{0};
    while (!sources.empty()) {
        std::vector<Reach> found(sources.size());
        for_each_task(thread_count(threads), sources.size(),
                      [&](unsigned, std::size_t i) { found[i] = search(sources[i]); });
        for (std::size_t i = 0; i < sources.size(); ++i)
            bounds.take_in(sources[i], found[i]);
        if (progress) progress(bounds.known());
        sources = bounds.next(goal);
    }
    return bounds.known();
}

}  // namespace tightflip::kernel
