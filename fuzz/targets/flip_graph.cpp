#include "flip_graph.hpp"

#include "bytes.hpp"
#include "naive_flip_graph.hpp"
#include "reading.hpp"
#include "renumbering.hpp"
#include "targets.hpp"
#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/find_path.hpp>
#include <tightflip/kernel/flip_graph.hpp>
#include <tightflip/kernel/flip_graph_dot.hpp>
#include <tightflip/kernel/random_flips.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace tightflip::fuzz {
namespace {

using kernel::DistanceEffort;
using kernel::Edge;
using kernel::Equality;
using kernel::Exploration;
using kernel::Halfedge;
using kernel::Handedness;
using kernel::Index;
using kernel::Labels;
using kernel::Mirror;
using kernel::PathOutcome;
using kernel::States;
using kernel::Triangulation;

constexpr Layout layout{.head = 6, .record = 0, .most_records = 0};

/// Sizes of which a naive exploration takes milliseconds; in this order for ever.
struct Size {
    Index vertices;
    Index genus;
    bool simple_only;
    States states;
};
constexpr std::array sizes{
    Size{3, 0, false, States::classes},        Size{4, 0, false, States::classes},
    Size{5, 0, false, States::classes},        Size{6, 0, false, States::classes},
    Size{3, 1, false, States::classes},        Size{4, 1, false, States::classes},
    Size{4, 0, true, States::classes},         Size{6, 0, true, States::classes},
    Size{7, 0, true, States::classes},         Size{4, 0, false, States::mirror_classes},
    Size{5, 0, false, States::mirror_classes}, Size{6, 0, false, States::mirror_classes},
    Size{4, 1, false, States::mirror_classes}, Size{7, 0, true, States::mirror_classes},
    Size{3, 0, false, States::labelled},       Size{4, 0, false, States::labelled},
    Size{5, 0, false, States::labelled},       Size{3, 1, false, States::labelled},
    Size{4, 1, false, States::labelled},       Size{3, 2, false, States::classes},
};
constexpr std::array efforts{DistanceEffort::none, DistanceEffort::usual, DistanceEffort::extremes,
                             DistanceEffort::all};

// ---- claims ----

Equality equality_of(States states) {
    return {states == States::labelled ? Labels::kept : Labels::ignored,
            states == States::mirror_classes ? Mirror::identified : Mirror::distinct};
}

Triangulation start_of(const kernel::ExploreRequest& request) {
    namespace families = kernel::families;
    if (request.simple_only) return families::stacked(request.vertices, 1);
    if (request.genus == 0) return families::book(request.vertices);
    return families::surface_of_genus(request.genus, request.vertices, 1);
}

/// What the naive way knows of the states and the classes that a request asks for.
struct NaiveAnswer {
    NaiveGraphs states;
    NaiveGraphs classes;

    explicit NaiveAnswer(const kernel::ExploreRequest& request)
        : states(start_of(request), equality_of(request.states), request.simple_only),
          classes(start_of(request), {Labels::ignored, equality_of(request.states).mirror},
                  request.simple_only) {}
};

NaiveAnswer& naive_answer(const kernel::ExploreRequest& request) {
    static std::map<std::tuple<Index, Index, States, bool>, NaiveAnswer> answers;
    return answers
        .try_emplace({request.vertices, request.genus, request.states, request.simple_only},
                     request)
        .first->second;
}

/// The states as classes are different, closed under flips, and joined as naive ones are.
std::string classes_are_right(const Exploration& found, NaiveGraphs& naive) {
    const auto& classes = found.classes;
    std::map<NaiveGraphs::Place, std::size_t> number;
    std::vector<NaiveGraphs::Place> places;
    for (std::size_t s = 0; s < classes.size(); ++s) {
        const Triangulation surface = classes.surface(s);
        places.push_back(naive.place(surface));
        if (!number.emplace(places.back(), s).second) return "classes_differ: two do not";
        if (classes.find(surface) != s) return "classes_are_found_again: one is not";
    }
    for (std::size_t s = 0; s < classes.size(); ++s) {
        std::vector<std::uint32_t> row;
        for (const std::size_t next : naive.component(places[s].component).arcs[places[s].state]) {
            const auto place = number.find({places[s].component, next});
            if (place == number.end()) return "classes_are_closed_under_flips: they are not";
            row.push_back(static_cast<std::uint32_t>(place->second));
        }
        const auto arcs = classes.arcs.row(s);
        std::vector<std::uint32_t> listed(arcs.begin(), arcs.end());
        std::ranges::sort(row);
        std::ranges::sort(listed);
        if (row != listed) return "arcs_are_the_flips: not of class " + std::to_string(s);
    }
    return {};
}

/// Of a connected graph: states, arcs and distances are those of the naive way.
std::string numbers_are_right(const Exploration& found, NaiveGraphs& graphs) {
    const NaiveGraph& naive = graphs.component(0);
    std::size_t arcs = 0;
    for (const auto& row : naive.arcs)
        arcs += row.size();
    if (found.components != 1) {
        return found.states > naive.surfaces.size()
                   ? std::string()
                   : "components_are_counted: " + std::to_string(found.components);
    }
    if (found.states != naive.surfaces.size() || found.arcs != arcs) {
        return "states_and_arcs_are_counted: " + std::to_string(found.states) + " and " +
               std::to_string(found.arcs) + " instead of " + std::to_string(naive.surfaces.size()) +
               " and " + std::to_string(arcs);
    }
    if (!found.eccentricities) return {};
    const std::vector<std::size_t>& eccentricities = graphs.eccentricities();
    const auto [least, greatest] = std::ranges::minmax_element(eccentricities);
    if (found.eccentricities->radius != *least || found.eccentricities->diameter != *greatest) {
        return "radius_and_diameter_are_right: " + std::to_string(found.eccentricities->radius) +
               " and " + std::to_string(found.eccentricities->diameter) + " instead of " +
               std::to_string(*least) + " and " + std::to_string(*greatest);
    }
    const auto at_the_rim = static_cast<std::size_t>(std::ranges::count(eccentricities, *greatest));
    if (found.request.states != States::labelled &&
        (found.eccentricities->peripheral().size() != at_the_rim ||
         found.eccentricities->counts().back() != at_the_rim)) {
        return "peripheral_states_are_counted: " + std::to_string(at_the_rim) + " there are";
    }
    return {};
}

/// Of labelled states: as many at each distance as the naive way finds from the same surface.
std::string levels_are_right(const Exploration& found, NaiveGraphs& naive) {
    for (const kernel::LabelledLevels& of_class : found.levels) {
        const auto place = naive.place(found.classes.surface(of_class.source));
        if (of_class.states != levels(naive.component(place.component), place.state)) {
            return "levels_are_right: not from class " + std::to_string(of_class.source);
        }
    }
    return {};
}

/// The implicit graph's neighbours of one state.
std::string implicit_graph_agrees(const FlipGraphCase& graph, const NaiveGraph& naive) {
    const Equality equality = equality_of(graph.request.states);
    const kernel::FlipGraph implicit(equality, graph.request.simple_only);
    const std::size_t s = graph.seed % naive.surfaces.size();
    std::vector<std::size_t> row;
    for (const kernel::CanonicalCode& code :
         implicit.neighbours(implicit.state(naive.surfaces[s]))) {
        const auto place = naive.number.find(naive_code(surface_of(code), equality));
        if (place == naive.number.end()) return "neighbours_are_states: one is not";
        row.push_back(place->second);
    }
    std::ranges::sort(row);
    return row == naive.arcs[s] ? std::string() : "neighbours_are_the_flips: they are not";
}

/// What a search that may keep few states says of a pair at a known distance.
std::string search_is_right(const Triangulation& from, const Triangulation& to,
                            std::optional<std::size_t> distance,
                            const kernel::PathOptions& options) {
    const kernel::PathSearch search = find_path(from, to, options);
    const std::string words = std::string(name(search.outcome)) + ", " +
                              std::to_string(search.states) + " states, distance " +
                              (distance ? std::to_string(*distance) : "infinite");
    switch (search.outcome) {
        case PathOutcome::found: {
            const kernel::Replay followed = replay(*search.path);
            return distance && followed.is_complete() && search.path->flips.size() == *distance &&
                           same_labelled_surface(followed.surface, to)
                       ? std::string()
                       : "shortest_paths_are_found: " + words;
        }
        case PathOutcome::isolated:
        case PathOutcome::not_connected:
            return distance ? "surfaces_called_apart_are_apart: " + words : std::string();
        case PathOutcome::not_found:
        case PathOutcome::interrupted:
            return distance && static_cast<std::size_t>(search.least_length) > *distance
                       ? "least_lengths_are_bounds: " + words
                       : std::string();
        default:
            return "equal_sizes_are_not_refused: " + words;
    }
}

/// Paths from the start to a state at a known distance, and to any labelling of the start.
std::string paths_are_right(const FlipGraphCase& graph, const NaiveGraph& naive) {
    if (graph.request.states != States::labelled) return {};
    const Triangulation& from = naive.surfaces.front();
    kernel::RandomStream random(graph.seed);
    for (const Triangulation& to :
         {with_other_halfedges(naive.surfaces[graph.seed % naive.surfaces.size()], random),
          with_other_labels(from, random)}) {
        const auto place = naive.number.find(naive_code(to, equality_of(States::labelled)));
        const auto distance = place == naive.number.end()
                                  ? std::nullopt
                                  : std::optional(naive.distance[place->second]);
        for (const kernel::PathOptions& options :
             {kernel::PathOptions{.shortest = true},
              kernel::PathOptions{.shortest = true, .most_states = graph.seed % 97},
              kernel::PathOptions{.shortest = true, .interrupted = [] { return true; }}}) {
            if (auto wrong = search_is_right(from, to, distance, options); !wrong.empty()) {
                return wrong;
            }
        }
        const bool is_sphere = graph.request.genus == 0;
        const kernel::ConnectResult connected = connect(from, to);
        if (static_cast<bool>(connected) != is_sphere ||
            describe(connected.refusal).empty() != is_sphere) {
            return "spheres_are_connected: " + std::string(describe(connected.refusal));
        }
    }
    const Triangulation other = kernel::families::book(graph.request.vertices + 1);
    if (find_path(from, other).outcome != PathOutcome::ends_differ || connect(from, other)) {
        return "ends_of_other_sizes_are_refused: they are not";
    }
    return {};
}

/// Flips at random lead to states of the graph, the way that the flips say.
std::string random_flips_stay_in_the_graph(const FlipGraphCase& graph, const NaiveGraph& naive) {
    const Triangulation start = start_of(graph.request);
    Triangulation surface = start;
    const std::vector<Edge> flips =
        flip_at_random(surface, {.count = static_cast<std::int64_t>(graph.seed % 24),
                                 .seed = graph.seed,
                                 .simple = graph.request.simple_only});
    const kernel::Replay followed = replay(kernel::FlipLog{start, flips});
    if (!followed.is_complete() || !(followed.surface == surface) ||
        flips.size() > graph.seed % 24) {
        return "random_flips_are_logged: " + followed.reason;
    }
    return naive.number.contains(naive_code(surface, equality_of(graph.request.states)))
               ? std::string()
               : "random_flips_stay_in_the_graph: they do not";
}

/// A run that is stopped says so, and a run that is not has the same result. One input in four
/// stops its run, one has little memory for it.
std::string limits_are_kept(const FlipGraphCase& graph, const Exploration& found) {
    if (graph.seed % 2 != 0) return {};
    const bool is_asked = graph.seed / 2 % 2 == 0;
    std::uint64_t questions = graph.seed / 4 % 16;
    std::uint64_t reports = 0;
    try {
        const Exploration again = explore(
            graph.request, {.threads = 1,
                            .memory_bytes = is_asked ? ~std::uint64_t{0} : graph.seed << 10U,
                            .checkpoint_directory = {},
                            .progress = [&](const auto&) { ++reports; },
                            .interrupted = [&] { return is_asked && questions-- == 0; }});
        if (again.states != found.states || again.arcs != found.arcs || reports == 0) {
            return "runs_under_limits_have_the_same_result: not this one";
        }
    } catch (const kernel::ExplorationStopped& stopped) {
        if (std::string_view(stopped.what()).empty()) return "stopped_runs_say_why: no";
    }
    return {};
}

std::string unusable_requests_are_refused() {
    for (const kernel::ExploreRequest& request :
         {kernel::ExploreRequest{.vertices = 2}, kernel::ExploreRequest{.genus = -1},
          kernel::ExploreRequest{.vertices = 60},
          kernel::ExploreRequest{.vertices = 12, .states = States::labelled}}) {
        try {
            static_cast<void>(explore(request));
            return "unusable_requests_are_refused: this one is not";
        } catch (const std::invalid_argument&) {  // as it should be
        }
    }
    return {};
}

std::string drawing_has_every_class(const Exploration& found) {
    const std::string dot = written([&](std::ostream& out) {
        write_dot(out, found.classes, found.eccentricities ? &*found.eccentricities : nullptr);
    });
    return dot.starts_with("graph") || dot.starts_with("strict graph")
               ? std::string()
               : "drawings_are_graphs: " + dot.substr(0, dot.find('\n'));
}

std::vector<Seed> seeds() {
    std::vector<Seed> seeds;
    for (std::size_t size = 0; size < sizes.size(); ++size) {
        for (std::size_t effort = 0; effort < efforts.size(); ++effort) {
            const std::string name =
                "size_" + std::to_string(size) + "_effort_" + std::to_string(effort);
            InputBytes bytes{format_version};
            for (const std::size_t value : {size, effort, effort % 2, 5 * effort + 3})
                bytes.push_back(static_cast<std::uint8_t>(value));
            seeds.push_back({name, bytes});
        }
    }
    return seeds;
}

}  // namespace

FlipGraphCase decode_flip_graph(Input input) {
    Bytes bytes = Bytes::after_version(input.first(std::min(input.size(), layout.most_bytes())));
    const Size& size = sizes.at(bytes.byte() % sizes.size());
    FlipGraphCase graph;
    graph.request = {.vertices = size.vertices,
                     .genus = size.genus,
                     .states = size.states,
                     .simple_only = size.simple_only,
                     .distances = efforts.at(bytes.byte() % efforts.size())};
    graph.threads = 1 + bytes.byte() % 2;
    graph.seed = bytes.pair();
    return graph;
}

std::string flip_graph_objection(const FlipGraphCase& graph) {
    const Exploration found = explore(
        graph.request,
        {.threads = graph.threads, .checkpoint_directory = {}, .progress = {}, .interrupted = {}});
    if (found.is_complete() == false) return "explorations_of_few_vertices_are_complete: no";
    static const std::string unusable = unusable_requests_are_refused();
    NaiveAnswer& answer = naive_answer(graph.request);
    const NaiveGraph& naive = answer.states.component(0);
    for (const std::string& objection :
         {classes_are_right(found, answer.classes), numbers_are_right(found, answer.states),
          levels_are_right(found, answer.states), implicit_graph_agrees(graph, naive),
          paths_are_right(graph, naive), random_flips_stay_in_the_graph(graph, naive),
          limits_are_kept(graph, found), unusable, drawing_has_every_class(found)}) {
        if (!objection.empty()) return objection;
    }
    return {};
}

const Target flip_graph_target{
    .name = "flip_graph",
    .description =
        "an exploration of few vertices: states, arcs, distances and paths are those of "
        "a naive search",
    .layout = layout,
    .objection = [](Input input) { return flip_graph_objection(decode_flip_graph(input)); },
    .show =
        [](std::ostream& out, Input input) {
            constexpr std::array states{"classes", "mirror classes", "labelled"};
            constexpr std::array words{"none", "usual", "extremes", "all"};
            const auto [request, threads, seed] = decode_flip_graph(input);
            out << "V = " << request.vertices << ", genus " << request.genus << ", "
                << states.at(static_cast<std::size_t>(request.states))
                << (request.simple_only ? ", simple" : "")
                << ", distances: " << words.at(static_cast<std::size_t>(request.distances)) << ", "
                << threads << " threads, seed " << seed << '\n';
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
