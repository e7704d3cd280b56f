/// \file
/// Exhaustive exploration: all triangulations of one size that flips reach, and what is known of
/// their number without flips.
#pragma once

#include <tightflip/kernel/class_graph.hpp>
#include <tightflip/kernel/exploration.hpp>
#include <tightflip/kernel/flip_graph_distances.hpp>
#include <tightflip/kernel/labelled_search.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace tightflip::kernel {

/// When two triangulations are one state.
enum class States : std::uint8_t {
    classes,         ///< up to isomorphisms that keep orientation
    mirror_classes,  ///< up to isomorphisms, mirror images identified
    labelled,        ///< equal with their vertex labels and orientation
};

/// Which distances are asked for.
enum class DistanceEffort : std::uint8_t {
    none,
    usual,  ///< radius and diameter, but not where that takes more than a minute or so
    extremes,
    all,  ///< every eccentricity
};

struct ExploreRequest {
    Index vertices = 4;
    Index genus = 0;
    States states = States::classes;
    bool simple_only = false;
    DistanceEffort distances = DistanceEffort::usual;
};

/// How many states there are, known without a single flip.
struct Expectation {
    /// Rooted surfaces: the closed formula on the sphere, else all gluings enumerated.
    std::optional<std::uint64_t> rooted;
    /// States: of labelled spheres the formula; else the number found, where the rooted surfaces
    /// behind it are all there are: each class has its share of roots, so none can be missing.
    std::optional<std::uint64_t> states;
};

struct Exploration {
    ExploreRequest request;
    ClassGraph classes;  ///< labelled states: the classes behind them
    std::uint64_t states = 0;
    std::uint64_t arcs = 0;  ///< legal flips of all states: each edge of the graph from both ends
    std::uint64_t components = 0;
    std::uint64_t rooted = 0;  ///< rooted surfaces that the states stand for
    Expectation expected;
    std::size_t min_degree = 0;  ///< legal flips of a state
    std::size_t max_degree = 0;
    std::optional<Eccentricities> eccentricities;  ///< of a connected graph, where asked for
    std::vector<LabelledLevels> levels;  ///< labelled: one search for each class component

    std::vector<std::uint64_t> states_of_class;  ///< labelled states, else 1
    double exploring_seconds = 0;                ///< until all states and arcs were known
    double distance_seconds = 0;                 ///< for the eccentricities

    /// Whether all states that exist were found; empty where that is not known.
    [[nodiscard]] std::optional<bool> is_complete() const noexcept;
};

/// Explores from the family of the size (and, where all gluings can be enumerated, from every
/// class). Throws std::invalid_argument for a size that no surface has or that the mode cannot
/// hold, ExplorationStopped where the run met a limit or was interrupted (before it starts, where
/// the formula tells that memory will not do), FileError for a bad checkpoint.
[[nodiscard]] Exploration explore(const ExploreRequest& request,
                                  const ExplorationLimits& limits = {});

}  // namespace tightflip::kernel
