#include "parallel.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/counting.hpp>
#include <tightflip/kernel/explore.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/gluing_enumeration.hpp>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>

namespace tightflip::kernel {
namespace {

/// Up to which size `usual` asks for radius and diameter.
constexpr std::uint64_t usual_classes = 2'000'000;
constexpr std::uint64_t usual_labelled_states = 1'000'000;

Index halfedges_of(const ExploreRequest& request) {
    return 6 * (request.vertices - 2 + 2 * request.genus);
}

std::string mebibytes(std::uint64_t bytes) {
    return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB";
}

void require_memory(std::uint64_t needed, const ExplorationLimits& limits, const char* what) {
    if (needed <= limits.memory_bytes) return;
    throw ExplorationStopped(ExplorationStopped::Reason::memory,
                             std::string(what) + " needs about " + mebibytes(needed) +
                                 ", more than the limit of " + mebibytes(limits.memory_bytes));
}

void require_size(const ExploreRequest& request) {
    const auto refuse = [](const std::string& words) { throw std::invalid_argument(words); };
    if (request.vertices < 3) refuse("a triangulation has at least 3 vertices");
    if (request.genus < 0) refuse("the genus is at least 0");
    const std::int64_t edges =
        3 * (std::int64_t{request.vertices} - 2 + 2 * std::int64_t{request.genus});
    if (2 * edges > max_class_halfedges) {
        refuse(std::to_string(edges) + " edges are too many to explore: codes hold " +
               std::to_string(max_class_halfedges / 2));
    }
    if (request.states == States::labelled && request.vertices > LabelWords::max_vertices) {
        refuse("labelled surfaces are explored up to " + std::to_string(LabelWords::max_vertices) +
               " vertices: one class alone has V! labellings, a bit each");
    }
}

std::optional<std::uint64_t> rooted_by_formula(const ExploreRequest& request) {
    if (request.genus != 0) return std::nullopt;
    return request.simple_only ? rooted_simple_spheres(request.vertices)
                               : rooted_spheres(request.vertices);
}

ClassRules rules_of(const ExploreRequest& request) {
    return {
        .mirror = request.states == States::mirror_classes ? Mirror::identified : Mirror::distinct,
        .simple_only = request.simple_only,
        .keep_relabellings = request.states == States::labelled};
}

/// Roots that each class without symmetries has.
std::uint64_t roots_of(const ExploreRequest& request) {
    return static_cast<std::uint64_t>(halfedges_of(request)) *
           (request.states == States::mirror_classes ? 2 : 1);
}

/// What the number of rooted surfaces tells of the memory before anything is done: classes without
/// symmetries are the least there can be.
void require_memory_beforehand(const ExploreRequest& request, std::uint64_t rooted,
                               const ExplorationLimits& limits) {
    const ClassRules rules = rules_of(request);
    const std::uint64_t classes = rooted / roots_of(request) + 1;
    require_memory(classes * class_graph_bytes_per_state(halfedges_of(request), rules), limits,
                   "exploring the classes of this size");
    if (request.states == States::labelled) {
        require_memory(labelled_search_bytes(request.vertices, classes), limits,
                       "exploring the labelled surfaces of this size");
    }
}

std::optional<std::uint64_t> expected_labelled(const ExploreRequest& request,
                                               std::optional<std::uint64_t> rooted) {
    if (!rooted || request.genus != 0) return std::nullopt;
    return labelled_from_rooted(*rooted, request.vertices, halfedges_of(request));
}

/// The caller's limits, with progress that knows how many states are to be expected: of classes at
/// least as many as if none had symmetries.
ExplorationLimits with_expectation(ExplorationLimits limits, const char* stage,
                                   std::optional<std::uint64_t> expected) {
    if (limits.progress && expected) {
        limits.progress = [report = std::move(limits.progress), name = std::string_view(stage),
                           expected](ExplorationProgress progress) {
            if (progress.stage == name) progress.expected = std::max(progress.done, *expected);
            report(progress);
        };
    }
    return limits;
}

/// A surface of each class, found without flips, and how many rooted ones there are.
struct Enumerated {
    std::vector<Triangulation> surfaces;
    std::uint64_t rooted = 0;
};

bool has_parallel_edges(HalfedgeTable table, Index vertices) {
    const auto row = static_cast<std::size_t>(vertices);
    std::vector<bool> is_joined(row * row);
    for (Index h = 0; h < static_cast<Index>(table.size()); ++h) {
        const auto from = static_cast<std::size_t>(at(table, Halfedge{h}).origin.id);
        const auto to = static_cast<std::size_t>(at(table, twin(Halfedge{h})).origin.id);
        const std::size_t pair = row * from + to;
        if (is_joined[pair]) return true;
        is_joined[pair] = true;
    }
    return false;
}

bool is_enumerable(const ExploreRequest& request) {
    return request.genus > 0 && request.vertices <= largest_quick_enumeration(request.genus);
}

Enumerated enumerate_classes(const ExploreRequest& request, const ExplorationLimits& limits) {
    Enumerated result;
    CanonicalSearch search;
    std::set<std::string> codes;
    std::string code(static_cast<std::size_t>(halfedges_of(request)) / 2, '\0');
    enumerate_gluings(request.vertices, request.genus, [&](HalfedgeTable table) {
        if (limits.interrupted && limits.interrupted()) {
            throw ExplorationStopped(ExplorationStopped::Reason::interrupted,
                                     "interrupted while gluings were enumerated");
        }
        if (request.simple_only && has_parallel_edges(table, request.vertices)) return true;
        ++result.rooted;
        search(table, request.vertices, {Labels::ignored, rules_of(request).mirror},
               std::span<char>(code));
        if (codes.insert(code).second) {
            result.surfaces.push_back(
                build({table.begin(), table.end()}, request.vertices).value());
        }
        return true;
    });
    return result;
}

std::vector<Triangulation> family_start(const ExploreRequest& request) {
    std::vector<Triangulation> starts;
    if (request.genus > 0) {
        starts.push_back(families::surface_of_genus(request.genus, request.vertices, 0));
    } else if (request.simple_only) {
        starts.push_back(families::stacked(request.vertices, 0));
    } else {
        starts.push_back(families::book(request.vertices));
    }
    return starts;
}

/// The labelled graph over the classes: its states, components and, of one component, distances.
class LabelledStage {
public:
    LabelledStage(Exploration& result, const ExplorationLimits& limits)
        : result_(result), limits_(limits), search_(result.classes) {
        require_memory(labelled_search_bytes(result.request.vertices, result.classes.size()),
                       limits, "exploring the labelled surfaces of this size");
        exchange_.emplace(result.classes.size(), search_.label_words().size());
    }

    void count(const Components& components) {
        std::vector<std::uint64_t> total(components.count());
        for (std::uint32_t c = 0; c < result_.classes.size(); ++c) {
            result_.states_of_class.push_back(search_.states_of(c));
            total[components.of[c]] += result_.states_of_class.back();
        }
        for (std::size_t i = 0; i < components.count(); ++i) {
            result_.levels.push_back(search_.run(components.least[i], *exchange_, limits_));
            // Relabelling carries components to components, so all over one set of classes are
            // of one size.
            result_.components += total[i] / result_.levels.back().total();
        }
    }

    [[nodiscard]] Reach reach(std::uint32_t source) {
        ExplorationLimits limits = limits_;
        limits.checkpoint_directory.clear();
        const LabelledLevels levels = source == result_.levels.front().source
                                          ? result_.levels.front()
                                          : search_.run(source, *exchange_, limits);
        return {distances_from(result_.classes.arcs, source),
                std::vector<Distance>(levels.farthest.begin(), levels.farthest.end())};
    }

private:
    Exploration& result_;
    const ExplorationLimits& limits_;
    LabelledSearch search_;
    std::optional<LocalExchange> exchange_;
};

bool wants_distances(const Exploration& result) {
    const bool is_labelled = result.request.states == States::labelled;
    if (result.components != 1 || result.request.distances == DistanceEffort::none) return false;
    return result.request.distances != DistanceEffort::usual ||
           result.states <= (is_labelled ? usual_labelled_states : usual_classes);
}

void find_eccentricities(Exploration& result, const ExplorationLimits& limits,
                         LabelledStage* labelled) {
    const auto began = std::chrono::steady_clock::now();
    const auto search = [&](std::uint32_t source) {
        if (limits.interrupted && limits.interrupted()) {
            throw ExplorationStopped(ExplorationStopped::Reason::interrupted,
                                     "interrupted while distances were measured");
        }
        if (labelled != nullptr) return labelled->reach(source);
        const auto distances = distances_from(result.classes.arcs, source);
        return Reach{distances, distances};
    };
    const auto progress = [&](const Eccentricities& known) {
        if (!limits.progress) return;
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
        limits.progress({"searches for distances", known.searches, 0, elapsed.count(), 0});
    };
    result.eccentricities = bound_eccentricities(
        result.classes.size(), search,
        result.request.distances == DistanceEffort::all ? EccentricityGoal::all
                                                        : EccentricityGoal::extremes,
        labelled != nullptr ? 1 : limits.threads, progress);
}

void sum_up(Exploration& result) {
    const FlipGraphTable& arcs = result.classes.arcs;
    result.min_degree = arcs.size() > 0 ? arcs.degree(0) : 0;
    for (std::size_t c = 0; c < arcs.size(); ++c) {
        result.states += result.states_of_class[c];
        result.arcs += result.states_of_class[c] * arcs.degree(c);
        result.min_degree = std::min(result.min_degree, arcs.degree(c));
        result.max_degree = std::max(result.max_degree, arcs.degree(c));
    }
}

}  // namespace

std::optional<bool> Exploration::is_complete() const noexcept {
    if (!expected.rooted) return std::nullopt;
    return rooted == *expected.rooted;
}

Exploration explore(const ExploreRequest& request, const ExplorationLimits& limits) {
    const auto began = std::chrono::steady_clock::now();
    const auto elapsed = [began] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    require_size(request);
    Exploration result;
    result.request = request;
    std::optional<std::uint64_t>& rooted = result.expected.rooted;
    rooted = rooted_by_formula(request);
    if (rooted) require_memory_beforehand(request, *rooted, limits);
    std::vector<Triangulation> starts;
    if (is_enumerable(request)) {
        Enumerated all = enumerate_classes(request, limits);
        rooted = all.rooted;
        starts = std::move(all.surfaces);
    } else {
        starts = family_start(request);
    }
    if (starts.empty()) throw std::invalid_argument("there is no such triangulation");

    const auto expected_classes =
        rooted ? std::optional(*rooted / roots_of(request)) : std::nullopt;
    result.classes = explore_classes(starts, rules_of(request),
                                     with_expectation(limits, "classes", expected_classes));
    result.rooted = result.classes.rooted_count();

    const Components parts = components(result.classes.arcs);
    std::optional<LabelledStage> labelled;
    const auto expected_states = expected_labelled(request, rooted);
    const ExplorationLimits labelled_limits =
        with_expectation(limits, "labelled surfaces", expected_states);
    if (request.states == States::labelled) {
        result.expected.states = expected_states;
        labelled.emplace(result, labelled_limits);
        labelled->count(parts);
    } else {
        result.states_of_class.assign(result.classes.size(), 1);
        result.components = parts.count();
    }
    sum_up(result);
    if (!result.expected.states && result.is_complete() == true) {
        result.expected.states = result.states;
    }
    result.exploring_seconds = elapsed();
    if (wants_distances(result)) {
        find_eccentricities(result, limits, labelled ? &*labelled : nullptr);
    }
    result.distance_seconds = elapsed() - result.exploring_seconds;
    return result;
}

}  // namespace tightflip::kernel
