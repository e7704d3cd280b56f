#include "command.hpp"
#include "flip_outputs.hpp"
#include "surface_input.hpp"
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/random_flips.hpp>

#include <algorithm>
#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::FlipLog;
using kernel::Triangulation;

struct Options {
    std::string file;
    std::string script;
    std::vector<kernel::Index> edges;
    kernel::RandomFlips random;
    FlipOutputs outputs;
    InputOptions input;
};

/// The flips to do, as a log that starts from the file's surface.
FlipLog planned(const Options& options, const SurfaceInput& input) {
    FlipLog log{input.triangulation(), {}};
    if (options.random.count > 0) {
        Triangulation surface = log.start;
        log.flips = flip_at_random(surface, options.random);
    }
    if (!options.script.empty()) {
        FlipLog script = kernel::parse_flip_log(kernel::read_file(options.script), options.script);
        if (script.start != log.start) {
            throw kernel::FileError(options.script, "this log starts from another surface than " +
                                                        options.file +
                                                        " (or one numbered differently)");
        }
        log.flips = std::move(script.flips);
    }
    for (const kernel::Index e : options.edges)
        log.flips.push_back({e});
    return log;
}

bool has_points(const SurfaceInput& input) {
    return input.format() != "tightflip-triangulation" && input.format() != "tightflip-gluing";
}

/// The surface, with the points that the input has.
void write_surface(const std::string& file, const SurfaceInput& input, const Triangulation& t) {
    if (has_points(input)) {
        const geometry::Surface start = input.surface();
        return geometry::write_surface_file(file, {t.table(), start.points()});
    }
    kernel::write_file(file, [&](std::ostream& out) { write_text(out, t); });
}

Exit flip(const Output& output, const Options& options) {
    const SurfaceInput input(options.file, options.input);
    const FlipLog log = planned(options, input);
    const kernel::Replay result = replay(log);
    const std::size_t asked =
        std::max(log.flips.size(), static_cast<std::size_t>(options.random.count));
    Json json{{"file", options.file},
              {"complete", result.done == asked},
              {"flips_done", result.done},
              {"flips", asked}};
    if (result.done < asked) {
        const std::string reason =
            fmt::format("flip {} of {}: {}", result.done + 1, asked,
                        result.is_complete() ? "no edge can be flipped" : result.reason);
        json["reason"] = reason;
        output.say(fmt::format("{}: stopped at {}; nothing was written", options.file, reason));
        output.object(json);
        return Exit::does_not_hold;
    }
    options.outputs.write(
        log, [&](const std::string& file) { write_surface(file, input, result.surface); });
    if (!options.outputs.surface.empty()) json["output"] = options.outputs.surface;
    if (!options.outputs.log.empty()) json["log"] = options.outputs.log;
    output.say(fmt::format("{}: {} flips done", options.file, result.done));
    output.object(json);
    return Exit::holds;
}

}  // namespace

void add_flip(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        app.add_subcommand("flip", "Flip edges of a surface by a log, by number or at random");
    verb->add_option("FILE", options->file, "Surface or mesh")->required();
    auto* script = verb->add_option("--script", options->script, "Flip log that starts from FILE");
    auto* edges = verb->add_option("--edges", options->edges, "Edges to flip, in order, e.g. 3,7,3")
                      ->delimiter(',')
                      ->check(whole_number());
    script->excludes(edges);
    auto* random = verb->add_option("--random", options->random.count,
                                    "Flip so many edges, drawn from those that can be flipped")
                       ->check(whole_number(1))
                       ->excludes(script)
                       ->excludes(edges);
    verb->add_option("--seed", options->random.seed, "Seed of the random stream (0)")
        ->check(whole_number())
        ->needs(random);
    verb->add_flag("--simple", options->random.simple, "Make no parallel edge")->needs(random);
    verb->add_option("-o,--output", options->outputs.surface,
                     "Write the flipped surface here, with the points of a FILE that has some in "
                     "the format of its extension (as make does)")
        ->check(file_name());
    verb->add_option("--log", options->outputs.log, "Write the flips as a log here")
        ->check(file_name());
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    verb->callback([&output, &action, options] {
        if (options->script.empty() && options->edges.empty() && options->random.count == 0) {
            throw CLI::RequiredError("--script, --edges or --random");
        }
        require_distinct({{"--output", options->outputs.surface}, {"--log", options->outputs.log}});
        action = [&output, options] {
            return for_each_input(output, {options->file},
                                  [&](const std::string&) { return flip(output, *options); });
        };
    });
}

}  // namespace tightflip::tools
