#include "command.hpp"
#include "interrupt.hpp"
#include "surface_input.hpp"
#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/find_path.hpp>
#include <tightflip/kernel/shorten.hpp>

#include <chrono>
#include <cmath>
#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::FlipLog;
using kernel::PathOutcome;
using kernel::PathSearch;
using kernel::Triangulation;

struct Options {
    std::string from;
    std::string to;
    std::string log_file;
    bool shorten = false;
    kernel::PathOptions search;
    bool binary = false;
    InputOptions input;
};

/// What came of the search, and what it took.
struct Result {
    PathSearch search;
    kernel::Index vertices = 0;
    kernel::Index genus = 0;
    std::size_t flips_found = 0;  ///< before the path was shortened
    double seconds = 0;
};

Result find(const Options& options) {
    const Triangulation from = SurfaceInput(options.from, options.input).triangulation();
    const Triangulation to = SurfaceInput(options.to, options.input).triangulation();
    const auto begin = std::chrono::steady_clock::now();
    Result result{find_path(from, to, options.search), from.vertex_count(), from.genus()};
    if (result.search.outcome == PathOutcome::ends_differ) {
        throw kernel::FileError(
            options.to,
            fmt::format("no path from {}: {} ({} vertices and genus {} there, {} "
                        "and {} here)",
                        options.from, describe(result.search.outcome), from.vertex_count(),
                        from.genus(), to.vertex_count(), to.genus()));
    }
    if (auto& path = result.search.path) {
        result.flips_found = path->flips.size();
        if (options.shorten) path = kernel::shorten(*std::move(path));
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    result.seconds = took.count();
    return result;
}

Exit report_path(const Output& output, const Options& options, const Result& result, Json json) {
    const FlipLog& log = *result.search.path;
    kernel::write_file(options.log_file, [&](std::ostream& out) {
        if (options.binary) return write_binary(out, log);
        write_text(out, log);
    });
    const auto flips = static_cast<double>(log.flips.size());
    json["flips"] = log.flips.size();
    if (result.genus == 0) json["bound"] = kernel::connect_bound(result.vertices);
    json["flips_per_v_log2_v"] = flips / (result.vertices * std::log2(result.vertices));
    json["output"] = options.log_file;
    if (options.shorten) json["flips_constructed"] = result.flips_found;
    output.say(fmt::format(
        "{}: {} flips from {} to {}{}, {:.3g} s", options.log_file, log.flips.size(), options.from,
        options.to, options.shorten ? fmt::format(" (constructed: {})", result.flips_found) : "",
        result.seconds));
    output.object(json);
    return Exit::holds;
}

Exit report_no_path(const Output& output, const Options& options, const Result& result, Json json) {
    const PathSearch& search = result.search;
    const bool is_decided =
        search.outcome == PathOutcome::isolated || search.outcome == PathOutcome::not_connected;
    std::string words = fmt::format("{} to {}: {}; {} surfaces seen", options.from, options.to,
                                    describe(search.outcome), search.states);
    if (!is_decided) {
        json["verdict"] = name(PathOutcome::not_found);
        json["least_flips"] = search.least_length;
        words += fmt::format(", a path has at least {} flips", search.least_length);
    }
    output.say(words);
    output.object(json);
    return is_decided ? Exit::does_not_hold : Exit::undecided;
}

Exit path(const Output& output, const Options& options) {
    const Result result = find(options);
    const Json json{{"from", options.from},
                    {"to", options.to},
                    {"verdict", name(result.search.outcome)},
                    {"vertices", result.vertices},
                    {"genus", result.genus},
                    {"states", result.search.states},
                    {"seconds", result.seconds}};
    const auto report = result.search ? report_path : report_no_path;
    return report(output, options, result, json);
}

}  // namespace

void add_path(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        app.add_subcommand("path", "Find flips from one labelled surface to another (Theorem 4.3)");
    verb->footer(
        "Vertices keep their labels: vertex 5 of FROM ends as vertex 5 of TO, whatever their "
        "coordinates.\nSpheres are connected by construction; for other surfaces, and with "
        "--shortest, all that few\nflips lead to is searched.\n\n" +
        app.get_footer());
    verb->add_option("FROM", options->from, "Surface or mesh to start from")->required();
    verb->add_option("TO", options->to, "Surface or mesh to end in")->required();
    verb->add_flag("--shorten", options->shorten,
                   "Cancel flips that undo each other and take short ways round pentagons");
    verb->add_flag("--shortest", options->search.shortest,
                   "Search for a path as short as any: for few vertices, or ends that are near");
    verb->add_option("--limit", options->search.most_states,
                     "Give up a search when so many surfaces have been seen (20000000)")
        ->check(whole_number(1));
    verb->add_option("-o,--output", options->log_file, "Flip log to write")
        ->check(file_name())
        ->required();
    verb->add_flag("--binary", options->binary,
                   "Write the log's binary form, the smaller and faster one for long paths");
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    verb->callback([&output, &action, options] {
        action = [&output, options] {
            note_interrupts();
            options->search.interrupted = was_interrupted;
            return for_each_input(output, {options->from},
                                  [&](const std::string&) { return path(output, *options); });
        };
    });
}

}  // namespace tightflip::tools
