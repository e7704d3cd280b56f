#include "command.hpp"
#include "interrupt.hpp"
#include "kinds.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "surface_input.hpp"
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/campaign.hpp>

#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::Triangulation;
using properties::CampaignReport;

struct Options {
    std::vector<std::string> files;
    std::string kind = "genus";
    std::optional<kernel::Index> vertices;
    properties::StartRequest request{.vertices = 1000, .genus = 0, .seed = 0};
    std::uint64_t flips = 1'000'000;
    std::uint64_t audit_every = 0;
    std::optional<double> seconds;
    std::string log = "tightflip-violation.log";
    InputOptions input;
};

std::string_view verdict(const CampaignReport& report) {
    if (report.failure) return "violated";
    return report.stopped_early ? "undecided" : "holds";
}

Exit exit_of(const CampaignReport& report) {
    if (report.failure) return Exit::does_not_hold;
    return report.stopped_early ? Exit::undecided : Exit::holds;
}

Json campaign_json(const CampaignReport& report) {
    Json json{{"verdict", verdict(report)},
              {"flips_attempted", report.attempted},
              {"flips_done", report.done},
              {"refused", report.refused},
              {"audits", report.audits},
              {"violations", report.failure ? 1 : 0},
              {"seconds", report.seconds},
              {"flips_per_second",
               report.seconds > 0 ? static_cast<double>(report.done) / report.seconds : 0.0}};
    if (!report.failure) return json;
    const auto& failure = *report.failure;
    const PlaceInWords place = [](const kernel::Violation& v) { return kernel::where(v); };
    json["failure"] = {{"violation", to_json(failure.violation, place)},
                       {"attempt", failure.attempt},
                       {"log_vertices", failure.log.start.vertex_count()},
                       {"log_flips", failure.log.flips.size()},
                       {"log_violation", to_json(failure.shrunk.violation, place)}};
    return json;
}

std::string in_words(const std::string& name, const CampaignReport& report) {
    std::string text = fmt::format("{}: {}", name, verdict(report));
    text += fmt::format(
        "\n  {} flips attempted: {} done, {} refused (the new edge would be a loop)"
        "\n  checked after every flip in constant time, and by {} full audits"
        "\n  {:.2f} s, {:.1f} million flips a second",
        report.attempted, report.done, report.refused, report.audits, report.seconds,
        report.seconds > 0 ? static_cast<double>(report.done) / report.seconds / 1e6 : 0.0);
    if (report.stopped_early) text += "\n  stopped before all flips were made";
    if (report.failure) {
        const auto& [violation, attempt, log, shrunk] = *report.failure;
        text += fmt::format(
            "\n  violation after attempt {}: {} {}, {}: {}"
            "\n  shrunk to {} flips on {} vertices: {}",
            attempt, static_cast<int>(violation.code), kernel::name(violation.code),
            kernel::where(violation), kernel::message(violation), log.flips.size(),
            log.start.vertex_count(), properties::describe(shrunk));
    }
    return text;
}

/// The name for the log of one of several surfaces: "a.log", "a-2.log", "a-3.log".
std::string log_name(const std::string& first, std::size_t number) {
    if (number == 0) return first;
    const std::filesystem::path path(first);
    return (path.parent_path() /
            fmt::format("{}-{}{}", path.stem().string(), number + 1, path.extension().string()))
        .string();
}

CampaignReport run_with_bar(const Options& options, const std::string& name,
                            const Triangulation& start) {
    ProgressBar bar(name);
    properties::CampaignOptions campaign{.flips = options.flips,
                                         .seed = options.request.seed,
                                         .audit_every = options.audit_every,
                                         .interrupted = was_interrupted};
    campaign.progress = [&](const properties::CampaignProgress& p) {
        bar.show({.done = p.attempted, .total = p.total, .seconds = p.seconds});
    };
    if (options.seconds) campaign.time_limit = std::chrono::duration<double>(*options.seconds);
    return run_campaign(start, campaign);
}

Exit run_on(const Output& output, const Options& options, const std::string& name,
            const Triangulation& start, std::size_t number) {
    const CampaignReport report = run_with_bar(options, name, start);
    Json json{{"file", name},
              {"vertices", start.vertex_count()},
              {"genus", start.genus()},
              {"seed", options.request.seed}};
    json.update(campaign_json(report));
    std::string text = in_words(name, report);
    Exit exit = exit_of(report);
    if (report.failure) {
        const std::string log = log_name(options.log, number);
        try {
            kernel::write_file(log,
                               [&](std::ostream& out) { write_text(out, report.failure->log); });
            json["log"] = log;
            text +=
                fmt::format("\n  written to {}; show it again with: tightflip replay {}", log, log);
        } catch (const kernel::FileError& error) {  // what was found is worth more than its log
            Output::complain(error.what());
            json["error"] = error.what();
            exit = Exit::unusable;
        }
    }
    output.say(text);
    output.object(json);
    return exit;
}

/// Where no size is asked for, kinds that come in few sizes have the next below 1000 vertices.
Triangulation made(const Options& options) {
    const properties::StartKind& kind = kind_named(options.kind, options.request.genus);
    if (!options.vertices) return make_nearest(kind, options.request);
    properties::StartRequest request = options.request;
    request.vertices = *options.vertices;
    return kind.make(request);
}

Exit run(const Output& output, const Options& options) {
    note_interrupts();
    std::size_t number = 0;
    if (!options.files.empty()) {
        return for_each_input(output, options.files, [&](const std::string& file) {
            const Triangulation start = SurfaceInput(file, options.input).triangulation();
            return run_on(output, options, file, start, number++);
        });
    }
    return for_each_input(output, {options.kind}, [&](const std::string&) {
        const Triangulation start = made(options);
        const std::string name =
            fmt::format("{}({} vertices, genus {}, seed {})", options.kind, start.vertex_count(),
                        start.genus(), options.request.seed);
        return run_on(output, options, name, start, number);
    });
}

}  // namespace

void add_campaign(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "campaign", "Flip edges at random under audit: do flips keep the topology (Theorem 4.2)?");
    auto* files = verb->add_option("FILE", options->files,
                                   "Surfaces or meshes to start from (else one is made)");
    verb->add_option("--kind", options->kind, "Kind of surface to make ('genus')")->excludes(files);
    verb->add_option("--vertices", options->vertices, "Its number of vertices (1000)")
        ->check(whole_number(1))
        ->excludes(files);
    verb->add_option("--genus", options->request.genus, "Its genus (0)")
        ->check(whole_number())
        ->excludes(files);
    verb->add_option("--flips", options->flips, "Flips to attempt (1000000)")
        ->check(whole_number());
    verb->add_option("--seed", options->request.seed, "Seed of the random stream (0)")
        ->check(whole_number());
    verb->add_option("--audit-every", options->audit_every,
                     "Attempts between full audits (32 an edge)")
        ->check(whole_number(1));
    verb->add_option("--time", options->seconds, "Stop after that many seconds, undecided")
        ->check(seconds());
    verb->add_option("--log", options->log, "Where to write the log of a violation");
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    verb->callback([&output, &action, options] {
        action = [&output, options] { return run(output, *options); };
    });
}

}  // namespace tightflip::tools
