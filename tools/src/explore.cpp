#include "command.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include <tightflip/kernel/explore.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/flip_graph_dot.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tightflip::tools {
namespace {

using kernel::DistanceEffort;
using kernel::Exploration;
using kernel::States;

/// More classes make no picture, only a large file.
constexpr std::size_t most_classes_drawn = 5000;
/// As many peripheral classes are listed; all are counted.
constexpr std::size_t most_peripheral_listed = 16;

struct Options {
    kernel::ExploreRequest request;
    kernel::ExplorationLimits limits;
    bool labelled = false;
    bool mirror = false;
    bool no_distances = false;
    bool diameter = false;
    bool eccentricities = false;
    std::string dot_file;
};

/// Most of what the machine has; a machine that begins to swap is of no use.
std::uint64_t usual_memory() {
    const auto pages = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES));
    const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGE_SIZE));
    return pages * page / 10 * 8;
}

std::uint64_t peak_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

std::string_view name(States states) {
    switch (states) {
        case States::classes:
            return "classes";
        case States::mirror_classes:
            return "mirror_classes";
        case States::labelled:
            return "labelled";
    }
    return "";
}

std::string in_words(const kernel::ExploreRequest& request) {
    static const std::map<States, std::string_view> kinds{
        {States::classes, "classes"},
        {States::mirror_classes, "classes with mirror images identified"},
        {States::labelled, "labelled triangulations"}};
    return fmt::format("{}{} with {} vertices, genus {}", request.simple_only ? "simple " : "",
                       kinds.at(request.states), request.vertices, request.genus);
}

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

std::string code_in_words(std::span<const std::uint8_t> code) {
    return fmt::format("{}", fmt::join(code, " "));
}

/// One bar for each stage of the run.
class StageBars {
public:
    void show(const kernel::ExplorationProgress& progress) {
        if (stage_ != progress.stage) {
            bar_.reset();
            bar_.emplace(progress.stage);
            stage_ = progress.stage;
        }
        bar_->show({progress.done, progress.expected, progress.seconds, progress.done_before});
    }

private:
    std::string stage_;
    std::optional<ProgressBar> bar_;
};

Json distances_json(const Exploration& result) {
    Json json{{"radius", nullptr}, {"diameter", nullptr}};
    if (!result.levels.empty()) json["states_at_distance"] = result.levels.front().states;
    if (!result.eccentricities) return json;
    const kernel::Eccentricities& found = *result.eccentricities;
    const auto peripheral = found.peripheral();
    std::vector<std::string> codes;
    for (const std::uint32_t state : peripheral) {
        if (codes.size() == most_peripheral_listed) break;
        codes.push_back(code_in_words(result.classes.code(state)));
    }
    json["radius"] = found.radius;
    json["diameter"] = found.diameter;
    json["peripheral_classes"] = peripheral.size();
    json["peripheral_codes"] = codes;
    json["eccentricities"] = found.counts();
    json["searches"] = found.searches;
    return json;
}

Json exploration_json(const Exploration& result) {
    const kernel::ExploreRequest& request = result.request;
    Json json{{"vertices", request.vertices},
              {"genus", request.genus},
              {"kind", name(request.states)},
              {"simple", request.simple_only},
              {"states", result.states},
              {"arcs", result.arcs},
              {"components", result.components},
              {"expected_states", or_null(result.expected.states)},
              {"classes", result.classes.size()},
              {"rooted", result.rooted},
              {"expected_rooted", or_null(result.expected.rooted)},
              {"complete", or_null(result.is_complete())},
              {"min_degree", result.min_degree},
              {"max_degree", result.max_degree}};
    json.update(distances_json(result));
    const double exploring = result.exploring_seconds;
    json["seconds"] = exploring + result.distance_seconds;
    json["exploring_seconds"] = exploring;
    json["states_per_second"] =
        exploring > 0 ? static_cast<double>(result.states) / exploring : 0.0;
    json["peak_bytes"] = peak_bytes();
    return json;
}

std::string completeness(const Exploration& result) {
    const auto complete = result.is_complete();
    if (!complete) return "how many there are is not known without flips";
    return *complete
               ? fmt::format("all there are: {} rooted, as counted without flips", result.rooted)
               : fmt::format("NOT all there are: {} rooted of {}", result.rooted,
                             *result.expected.rooted);
}

std::string in_words(const Exploration& result) {
    std::string text = fmt::format(
        "{}: {}\n  {}\n  {} arcs (legal flips), {} to {} a state; {}", in_words(result.request),
        result.states, completeness(result), result.arcs, result.min_degree, result.max_degree,
        result.components == 1 ? "connected" : fmt::format("{} components", result.components));
    if (result.eccentricities) {
        const kernel::Eccentricities& found = *result.eccentricities;
        text +=
            fmt::format("\n  radius {}, diameter {}, {} peripheral classes ({} searches)",
                        found.radius, found.diameter, found.peripheral().size(), found.searches);
    }
    if (!result.levels.empty()) {
        text += fmt::format("\n  at distance 0, 1, 2, ... from a start: {}",
                            fmt::join(result.levels.front().states, " "));
    }
    text += fmt::format("\n  {:.2f} s for states and arcs, {:.2f} s for distances, {} MiB",
                        result.exploring_seconds, result.distance_seconds, peak_bytes() >> 20);
    return text;
}

Exploration run_with_bars(const Options& options) {
    StageBars bars;
    kernel::ExplorationLimits limits = options.limits;
    limits.interrupted = was_interrupted;
    limits.progress = [&bars](const kernel::ExplorationProgress& p) { bars.show(p); };
    if (!limits.checkpoint_directory.empty()) {
        std::filesystem::create_directories(limits.checkpoint_directory);
    }
    return kernel::explore(options.request, limits);
}

void draw(const Exploration& result, const std::string& file) {
    if (result.classes.size() > most_classes_drawn) {
        throw std::invalid_argument(
            fmt::format("{} classes are too many to draw (at most {}); leave --dot out",
                        result.classes.size(), most_classes_drawn));
    }
    kernel::write_file(file, [&](std::ostream& out) {
        write_dot(out, result.classes, result.eccentricities ? &*result.eccentricities : nullptr);
    });
}

Exit explore(const Output& output, const Options& options) {
    note_interrupts();
    try {
        const Exploration result = run_with_bars(options);
        Json json = exploration_json(result);
        std::string text = in_words(result);
        if (!options.dot_file.empty()) {
            draw(result, options.dot_file);
            json["dot"] = options.dot_file;
            text += fmt::format("\n  drawn to {}; show it with: dot -Tsvg {}", options.dot_file,
                                options.dot_file);
        }
        output.say(text);
        output.object(json);
        return result.is_complete() == false ? Exit::does_not_hold : Exit::holds;
    } catch (const kernel::ExplorationStopped& stopped) {
        if (stopped.reason() != kernel::ExplorationStopped::Reason::interrupted) throw;
        Output::complain(stopped.what());
        output.object({{"vertices", options.request.vertices},
                       {"genus", options.request.genus},
                       {"kind", name(options.request.states)},
                       {"verdict", "undecided"},
                       {"reason", stopped.what()}});
        return Exit::undecided;
    }
}

/// Flags that say the same in a request.
void settle(Options& options) {
    options.request.states = options.labelled ? States::labelled
                             : options.mirror ? States::mirror_classes
                                              : States::classes;
    options.request.distances = options.no_distances     ? DistanceEffort::none
                                : options.eccentricities ? DistanceEffort::all
                                : options.diameter       ? DistanceEffort::extremes
                                                         : DistanceEffort::usual;
}

}  // namespace

void add_explore(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    options->limits.memory_bytes = usual_memory();
    CLI::App* verb = app.add_subcommand(
        "explore",
        "Find all triangulations of a size by flips: is their flip graph connected "
        "(Theorem 4.3)?");
    verb->add_option("--vertices", options->request.vertices, "Number of vertices")
        ->required()
        ->check(whole_number());
    verb->add_option("--genus", options->request.genus, "Genus (0)")->check(whole_number());
    auto* labelled = verb->add_flag("--labelled", options->labelled,
                                    "States are labelled triangulations (else classes)");
    verb->add_flag("--mirror", options->mirror, "Mirror images are one class")->excludes(labelled);
    verb->add_flag("--simple", options->request.simple_only,
                   "Only simple graphs, and flips that keep them so");
    auto* none =
        verb->add_flag("--no-distances", options->no_distances, "Leave out radius and diameter");
    auto* diameter = verb->add_flag("--diameter", options->diameter,
                                    "Radius and diameter, however long that takes")
                         ->excludes(none);
    verb->add_flag("--eccentricities", options->eccentricities,
                   "The eccentricity of every class, however long that takes")
        ->excludes(none)
        ->excludes(diameter);
    verb->add_option("--checkpoint", options->limits.checkpoint_directory,
                     "Keep the state of the run in this directory, and go on from there");
    verb->add_option("--checkpoint-every", options->limits.checkpoint_seconds,
                     "Seconds between checkpoints (5)")
        ->check(seconds());
    verb->add_option("--memory", options->limits.memory_bytes,
                     "Most memory to use, e.g. 600M or 2G (80 % of the machine's)")
        ->transform(CLI::AsSizeValue(false));
    verb->add_option("--threads", options->limits.threads, "Threads (all the machine has)")
        ->check(whole_number(1));
    verb->add_option(
        "--dot", options->dot_file,
        fmt::format("Draw the classes as a Graphviz file (up to {})", most_classes_drawn));
    verb->callback([&output, &action, options] {
        settle(*options);
        action = [&output, options] {
            return for_each_input(output, {in_words(options->request)},
                                  [&](const std::string&) { return explore(output, *options); });
        };
    });
}

}  // namespace tightflip::tools
