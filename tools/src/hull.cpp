#include "command.hpp"
#include "flip_outputs.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/convexify.hpp>
#include <tightflip/geometry/point_file.hpp>
#include <tightflip/geometry/surface_file.hpp>
#include <tightflip/kernel/families.hpp>

#include <chrono>
#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using geometry::ConvexifyEnd;
using geometry::ConvexifyResult;
using geometry::Point;

struct Options {
    std::string file;
    FlipOutputs outputs;
    std::uint64_t seed = 1;
    std::optional<double> seconds;
    bool leave_out = false;
};

/// The points, without those inside the hull and without copies where that is asked for.
std::vector<Point> chosen_points(const Options& options) {
    std::vector<Point> points = geometry::read_point_file(options.file);
    if (!options.leave_out) return points;
    const auto hull = geometry::convex_hull(points);
    if (!hull) return points;  // convexify will say why
    std::vector<bool> stays(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        stays[i] = hull.value().positions[i] != geometry::HullPosition::inside;
    for (const auto& [copy, first] : hull.value().coincident)
        stays[static_cast<std::size_t>(copy)] = false;
    std::vector<Point> chosen;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (stays[i]) chosen.push_back(points[i]);
    }
    return chosen;
}

ConvexifyResult convexify_with_bar(const Options& options, kernel::Triangulation& surface,
                                   geometry::Points points) {
    ProgressBar bar(options.file);
    const auto begin = std::chrono::steady_clock::now();
    geometry::ConvexifyOptions how{.concave_edges_first = false, .seed = options.seed};
    if (options.seconds) how.max_time = std::chrono::duration<double>(*options.seconds);
    how.keep_going = [&](std::int64_t flips) {
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        bar.show({.done = static_cast<std::uint64_t>(flips), .seconds = time.count()});
        return !was_interrupted();
    };
    return geometry::convexify(surface, points, how);
}

Exit exit_of(ConvexifyEnd end) {
    switch (end) {
        case ConvexifyEnd::convex:
            return Exit::holds;
        case ConvexifyEnd::unfit_data:
            return Exit::does_not_hold;
        case ConvexifyEnd::flip_limit:
        case ConvexifyEnd::time_limit:
        case ConvexifyEnd::stopped:
            return Exit::undecided;
        case ConvexifyEnd::not_a_sphere:
        case ConvexifyEnd::not_reached:
            break;
    }
    return Exit::unusable;
}

std::string remedy(const ConvexifyResult& result) {
    const bool may_leave_out = result.data.fault == geometry::DataFault::interior_point ||
                               result.data.fault == geometry::DataFault::coincident_points;
    return may_leave_out ? "; --leave-out drops points inside the hull, and copies" : "";
}

Exit hull(const Output& output, const Options& options) {
    note_interrupts();
    const std::vector<Point> points = chosen_points(options);
    Json json{{"file", options.file}, {"vertices", points.size()}};
    if (points.size() < 4) {
        const std::string reason = "there are too few points: a solid has four at least";
        json["reason"] = reason;
        output.say(fmt::format("{}: {}", options.file, reason));
        output.object(json);
        return Exit::does_not_hold;
    }
    const kernel::Triangulation start =
        kernel::families::book(static_cast<kernel::Index>(points.size()));
    kernel::Triangulation surface = start;
    const auto begin = std::chrono::steady_clock::now();
    const ConvexifyResult result = convexify_with_bar(options, surface, points);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    json["convex"] = bool(result);
    json["seconds"] = time.count();
    if (!result) {
        const std::string reason = message(result) + remedy(result);
        json["reason"] = reason;
        output.say(fmt::format("{}: {}; nothing was written", options.file, reason));
        output.object(json);
        return exit_of(result.end);
    }
    const geometry::SurfaceView view{surface.table(), points};
    const bool is_strict = bool(geometry::is_convex_surface(view));
    options.outputs.write(kernel::FlipLog{start, result.flips}, [&](const std::string& file) {
        geometry::write_surface_file(file, view);
    });
    if (!options.outputs.log.empty()) json["log"] = options.outputs.log;
    json["edges"] = surface.edge_count();
    json["faces"] = surface.face_count();
    json["certificate"] = is_strict ? "convex" : "convex_up_to_flat_edges";
    json["flips"] = result.flips.size();
    json["concave_flips"] = result.concave_flips;
    json["output"] = options.outputs.surface;
    output.say(fmt::format(
        "{}: the hull of {} points, {} faces, certified {}\n  {} flips from a book, {} of them of "
        "concave edges, {:.3g} s",
        options.outputs.surface, points.size(), surface.face_count(),
        is_strict ? "strictly convex" : "convex up to flat edges", result.flips.size(),
        result.concave_flips, time.count()));
    output.object(json);
    return Exit::holds;
}

}  // namespace

void add_hull(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "hull", "Find the convex hull of points by flips alone, with the log as a certificate");
    verb->add_option("POINTS", options->file,
                     "Mesh, surface, or text with three coordinates a line; only the points count")
        ->required();
    verb->add_option("-o,--output", options->outputs.surface,
                     "Write the hull here, in the format of its extension (as make does)")
        ->check(file_name())
        ->required();
    verb->add_option("--log", options->outputs.log, "Write the flips from the start, a book, here")
        ->check(file_name());
    verb->add_flag("--binary", options->outputs.binary, "Write the log's binary form");
    verb->add_flag("--leave-out", options->leave_out,
                   "Leave out points inside the hull, and copies (else refused)");
    verb->add_option("--seed", options->seed, "Chooses the direction of the sweep (1)")
        ->check(whole_number());
    verb->add_option("--time", options->seconds, "Stop after that many seconds, undecided")
        ->check(seconds());
    verb->callback([&output, &action, options] {
        require_distinct({{"--output", options->outputs.surface}, {"--log", options->outputs.log}});
        require_distinct({{"POINTS", options->file}, {"--log", options->outputs.log}});
        action = [&output, options] {
            return for_each_input(output, {options->file},
                                  [&](const std::string&) { return hull(output, *options); });
        };
    });
}

}  // namespace tightflip::tools
