#include "command.hpp"
#include "report.hpp"
#include "surface_input.hpp"
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/properties/generators.hpp>

#include <map>
#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::Index;
using kernel::Triangulation;

struct Options {
    std::vector<std::string> files;
    InputOptions input;
};

/// About the program: its kinds of surfaces, its data sets and its violation codes.
Exit describe_program(const Output& output) {
    Json kinds = Json::array();
    output.say("tightflip " TIGHTFLIP_VERSION "\n\nkinds of surfaces:");
    for (const properties::StartKind& kind : properties::start_kinds()) {
        output.say(fmt::format("  {:<13} {}", kind.name, kind.description));
        kinds.push_back({{"name", kind.name}, {"description", kind.description}});
    }
    Json data_sets = Json::array();
    output.say("\ndata sets, surfaces with points:");
    for (const geometry::DataSet& set : geometry::all_data_sets()) {
        output.say(fmt::format("  {:<17} {}", set.name, set.description));
        data_sets.push_back({{"name", set.name},
                             {"description", set.description},
                             {"default_vertices", set.default_vertices},
                             {"marked_vertex", set.has_marked_vertex}});
    }
    Json codes = Json::array();
    output.say("\nviolation codes:");
    for (const kernel::ViolationCode code : kernel::all_violation_codes()) {
        output.say(fmt::format("  {} {}\n      {}", static_cast<int>(code), kernel::name(code),
                               kernel::describe(code)));
        codes.push_back({{"code", static_cast<int>(code)},
                         {"name", kernel::name(code)},
                         {"description", kernel::describe(code)}});
    }
    output.object({{"version", TIGHTFLIP_VERSION},
                   {"kinds", kinds},
                   {"data_sets", data_sets},
                   {"codes", codes}});
    return Exit::holds;
}

std::map<Index, Index> degree_histogram(const Triangulation& surface) {
    std::vector<Index> degree(static_cast<std::size_t>(surface.vertex_count()), 0);
    for (const auto& record : surface.table())
        ++degree[static_cast<std::size_t>(record.origin.id)];
    std::map<Index, Index> histogram;
    for (const Index d : degree)
        ++histogram[d];
    return histogram;
}

Exit describe_surface(const Output& output, const Options& options, const std::string& file) {
    const SurfaceInput input(file, options.input);
    const Triangulation surface = input.triangulation();
    const kernel::AuditReport report = input.audit();
    Index flippable = 0;
    for (Index e = 0; e < surface.edge_count(); ++e)
        flippable += surface.can_flip({e}) ? 1 : 0;
    output.say(fmt::format(
        "{}: {} in {}\n  {} vertices, {} edges ({} flippable), {} faces\n  {} pairs of vertices "
        "joined by parallel edges\n  vertices by degree:",
        file, surface_in_words(report.topology), input.format(), surface.vertex_count(),
        surface.edge_count(), flippable, surface.face_count(),
        report.parallels->pairs_joined_twice));
    Json by_degree = Json::object();
    for (const auto& [degree, count] : degree_histogram(surface)) {
        output.say(fmt::format("    {:>5}: {}", degree, count));
        by_degree[std::to_string(degree)] = count;
    }
    input.say_repairs(output);
    Json json{{"file", file}, {"format", input.format()}};
    json.update(to_json(report, [&](const kernel::Violation& v) { return input.where(v); }));
    json["flippable_edges"] = flippable;
    json["vertices_by_degree"] = by_degree;
    input.add_repairs(json);
    output.object(json);
    return Exit::holds;
}

}  // namespace

void add_info(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "info", "Describe valid surfaces; without a file, the program's kinds and codes");
    verb->add_option("FILE", options->files, "Surfaces or meshes");
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    options->input.add_repair(*verb);
    verb->callback([&output, &action, options] {
        action = [&output, options] {
            if (options->files.empty()) return describe_program(output);
            return for_each_input(output, options->files, [&](const std::string& file) {
                return describe_surface(output, *options, file);
            });
        };
    });
}

}  // namespace tightflip::tools
