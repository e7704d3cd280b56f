#include "command.hpp"
#include "interrupt.hpp"
#include "optimise_course.hpp"
#include "report_page.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace tightflip::tools {
namespace {

using geometry::AllowedFlips;
using geometry::Energy;
using geometry::OptimiseEnd;
using geometry::StrategyResult;
using kernel::FlipLog;
using kernel::Triangulation;

std::string_view name(OptimiseEnd end) {
    switch (end) {
        case OptimiseEnd::local_minimum:
            return "local_minimum";
        case OptimiseEnd::flip_limit:
            return "flip_limit";
        case OptimiseEnd::time_limit:
            return "time_limit";
        case OptimiseEnd::stopped:
            return "interrupted";
    }
    return "";
}

/// A number or, for a criterion of several levels, an array. Measures that leave the range of
/// doubles are their largest (see ScaledPoints), and none in JSON.
Json energy_json(const Energy& energy, std::size_t levels) {
    Json json = Json::array();
    for (std::size_t level = 0; level < levels; ++level) {
        const double value = energy.levels.at(level);
        const bool is_known = std::abs(value) < std::numeric_limits<double>::max();
        json.push_back(is_known ? Json(value) : Json(nullptr));
    }
    return levels == 1 ? json.front() : json;
}

std::string energy_in_words(const Energy& energy, std::size_t levels) {
    std::string words = fmt::format("{:.9g}", energy.first());
    for (std::size_t level = 1; level < levels; ++level)
        words += fmt::format(", {:.9g}", energy.levels.at(level));
    return words;
}

Json part_json(const CoursePart& part) {
    const StrategyResult& result = part.result;
    return {{"criterion", part.criterion},
            {"strategy", geometry::info(result.used).name},
            {"initial", energy_json(result.before, part.levels)},
            {"final", energy_json(result.after, part.levels)},
            {"flips", result.flips.size()},
            {"evaluated", result.evaluated}};
}

/// What holds of the surface at the end.
struct Verdict {
    bool strictly_convex = false;
    bool convex = false;
    bool embedded = false;

    explicit Verdict(const geometry::SurfaceView& surface)
        : strictly_convex(geometry::is_convex_surface(surface)),
          convex(strictly_convex ||
                 geometry::is_convex_surface(surface, geometry::FlatEdges::admitted)),
          embedded(geometry::is_embedded(surface)) {}

    [[nodiscard]] std::string_view certificate() const {
        if (strictly_convex) return "convex";
        return convex ? "convex_up_to_flat_edges" : "none";
    }
};

Json course_json(const OptimiseRequest& options, const Course& course, const Verdict& verdict) {
    const Triangulation& t = course.surface.triangulation();
    Json json{{"file", options.file},
              {"vertices", t.vertex_count()},
              {"edges", t.edge_count()},
              {"genus", t.genus()}};
    json.update(part_json(course.parts.front()));
    if (course.parts.size() > 1) json["then"] = part_json(course.parts.back());
    json["seconds"] = course.seconds;
    json["converged"] = course.end() == OptimiseEnd::local_minimum;
    json["end"] = name(course.end());
    json["convex"] = verdict.convex;
    json["certificate"] = verdict.certificate();
    json["embedded"] = verdict.embedded;
    return json;
}

std::string in_words(const OptimiseRequest& options, const Course& course, const Verdict& verdict) {
    std::string words =
        fmt::format("{}: {} flips in {:.3g} s", options.file, course.flips.size(), course.seconds);
    for (const CoursePart& part : course.parts) {
        words += fmt::format("\n  {} {} -> {} by {}, {} flips, {} changes evaluated",
                             part.criterion, energy_in_words(part.result.before, part.levels),
                             energy_in_words(part.result.after, part.levels),
                             geometry::info(part.result.used).name, part.result.flips.size(),
                             part.result.evaluated);
    }
    words += fmt::format("\n  {}; {}, {}",
                         course.end() == OptimiseEnd::local_minimum
                             ? "no flip improves it"
                             : fmt::format("stopped early ({})", name(course.end())),
                         verdict.strictly_convex ? "certified convex"
                         : verdict.convex        ? "certified convex up to flat edges"
                                                 : "not convex",
                         verdict.embedded ? "embedded" : "not embedded");
    return words;
}

void write_trace(std::ostream& out, const Course& course) {
    out << "criterion,flips,energy\n";
    for (const CoursePart& part : course.parts) {
        for (const geometry::EnergyAt& at : part.result.trace)
            fmt::print(out, "\"{}\",{},{}\n", part.criterion, at.flips, at.energy.first());
    }
}

void write_page(const OptimiseRequest& options, const Course& course, const Json& json) {
    OptimisationReport page{.title = fmt::format("{}: {}", options.file, options.criterion),
                            .facts = {},
                            .before = course.start,
                            .flips = course.flips,
                            .series = {}};
    for (const auto& [key, value] : json.items()) {
        if (value.is_object()) continue;
        page.facts.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
    }
    for (const CoursePart& part : course.parts) {
        ReportSeries series{part.criterion, {}, {}};
        for (const geometry::EnergyAt& at : part.result.trace) {
            series.flips.push_back(at.flips);
            series.values.push_back(at.energy.first());
        }
        page.series.push_back(std::move(series));
    }
    write_report(options.report, page);
}

Exit optimise_file(const Output& output, const OptimiseRequest& options) {
    note_interrupts();
    const Course course = run_course(options);
    const Verdict verdict(course.surface.view());
    Json json = course_json(options, course, verdict);
    options.outputs.write(FlipLog{course.start.triangulation(), course.flips},
                          [&](const std::string& file) {
                              geometry::write_surface_file(file, course.surface.view());
                          });
    json["output"] = options.outputs.surface;
    if (!options.outputs.log.empty()) json["log"] = options.outputs.log;
    if (!options.trace.empty()) {
        kernel::write_file(options.trace, [&](std::ostream& out) { write_trace(out, course); });
        json["trace"] = options.trace;
    }
    if (!options.report.empty()) {
        write_page(options, course, json);
        json["report"] = options.report;
    }
    output.say(in_words(options, course, verdict));
    output.object(json);
    return course.end() == OptimiseEnd::local_minimum ? Exit::holds : Exit::undecided;
}

/// Names with their descriptions, a line each.
template <class Infos>
std::string in_lines(const Infos& infos) {
    std::string text;
    for (const auto& info : infos)
        text += fmt::format("\n  {}: {}", info.name, info.description);
    return text;
}

void add_search_options(CLI::App& verb, OptimiseRequest& options) {
    verb.add_option_function<std::string>(
            "--strategy",
            [&options](const std::string& word) {
                options.strategy = *geometry::strategy_by_name(word);
            },
            "How to search ('automatic'):" + in_lines(geometry::all_strategies()))
        ->check(CLI::Validator(
            [](std::string& word) {
                return geometry::strategy_by_name(word) ? "" : "no strategy '" + word + "'";
            },
            ""));
    verb.add_flag_callback(
        "--best", [&options] { options.search.order = geometry::FlipOrder::best; },
        "Of the flips that improve do the best next (else the one that waited longest)");
    auto* simple = verb.add_flag_callback(
        "--simple", [&options] { options.search.allowed = AllowedFlips::simple; },
        "Make no parallel edge");
    verb.add_flag_callback(
            "--embedded", [&options] { options.search.allowed = AllowedFlips::embedded; },
            "Keep an embedded surface embedded (linear time a flip)")
        ->excludes(simple);
    verb.add_option("--lock", options.locked, "Edges never to flip, e.g. 3,7")
        ->delimiter(',')
        ->check(whole_number());
    verb.add_option("--marked", options.marked,
                    "The vertex that closes a functional surface, and is no datum")
        ->check(whole_number());
    verb.add_option("--seed", options.search.seed,
                    "Shuffles the order of edges, and what a strategy draws (0: as numbered)")
        ->check(whole_number());
    verb.add_option("--max-flips", options.search.max_flips, "Stop after so many flips")
        ->check(whole_number());
    verb.add_option("--time", options.seconds, "Stop after that many seconds")->check(seconds());
}

}  // namespace

void add_optimise(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<OptimiseRequest>();
    CLI::App* verb = app.add_subcommand(
        "optimise", "Flip edges until a criterion is as small as can be (the paper's section 5)");
    verb->footer(
        "Where a limit or Ctrl-C stops it, the best so far is written, and the exit code "
        "is 3.\n\n" +
        app.get_footer());
    verb->add_option("FILE", options->file, "Surface or mesh with points")->required();
    verb->add_option(
        "--criterion", options->criterion,
        "What to minimise ('tight'); sums as in area+0.5*mean, ranks as in tight,mean:" +
            in_lines(geometry::all_criteria()));
    verb->add_option("--then", options->then,
                     "Afterwards minimise this one by plain local search from there");
    add_search_options(*verb, *options);
    verb->add_option("--resume", options->resume,
                     "Begin where this log, which starts from FILE, ends")
        ->check(file_name());
    verb->add_option("-o,--output", options->outputs.surface,
                     "Write the surface here, in the format of its extension (as make does)")
        ->check(file_name())
        ->required();
    verb->add_option("--log", options->outputs.log, "Write all flips from FILE on here")
        ->check(file_name());
    verb->add_flag("--binary", options->outputs.binary, "Write the log's binary form");
    verb->add_option("--trace", options->trace,
                     "Write the energy after each flip here, as CSV (of V vertices, after every "
                     "V^2 / 10^5 flips)")
        ->check(file_name());
    verb->add_option("--report", options->report,
                     "Write a web page into this directory: start and end in space, flip by flip")
        ->check(file_name());
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    options->input.add_repair(*verb);
    verb->callback([&output, &action, options] {
        const NamedFile log{"--log", options->outputs.log};
        const NamedFile trace{"--trace", options->trace};
        require_distinct({{"--output", options->outputs.surface}, log, trace});
        // An input is changed only where -o names it, and a log where it grows from --resume.
        require_distinct({{"FILE", options->file}, log, trace});
        require_distinct({{"--resume", options->resume}, trace});
        if (!options->report.empty() && !can_write_report()) {
            throw CLI::ValidationError("--report", std::string(how_to_get_reports));
        }
        action = [&output, options] {
            return for_each_input(output, {options->file}, [&](const std::string&) {
                return optimise_file(output, *options);
            });
        };
    });
}

}  // namespace tightflip::tools
