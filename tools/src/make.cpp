#include "command.hpp"
#include "kinds.hpp"
#include <tightflip/geometry/surface_file.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

struct Options {
    std::string kind;
    std::optional<kernel::Index> vertices;
    properties::StartRequest request;
    std::string file;
};

kernel::Triangulation write_start(Options options) {
    const properties::StartKind& kind = kind_named(options.kind, options.request.genus);
    options.request.vertices =
        options.vertices.value_or(kind.least_vertices(options.request.genus));
    kernel::Triangulation surface = kind.make(options.request);
    kernel::write_file(options.file, [&](std::ostream& out) { kernel::write_text(out, surface); });
    return surface;
}

kernel::Triangulation write_data_set(const Options& options, const geometry::DataSet& set) {
    const geometry::Surface surface =
        set.make({.vertices = options.vertices.value_or(set.default_vertices),
                  .seed = options.request.seed});
    write_surface_file(options.file, surface.view());
    return surface.triangulation();
}

Exit make(const Output& output, const Options& options) {
    const geometry::DataSet* set = data_set_named(options.kind, options.request.genus);
    const kernel::Triangulation surface =
        set != nullptr ? write_data_set(options, *set) : write_start(options);
    output.say(fmt::format("{}: {} vertices, {} edges, {} faces, genus {}", options.file,
                           surface.vertex_count(), surface.edge_count(), surface.face_count(),
                           surface.genus()));
    output.object({{"file", options.file},
                   {"kind", options.kind},
                   {"vertices", surface.vertex_count()},
                   {"edges", surface.edge_count()},
                   {"faces", surface.face_count()},
                   {"genus", surface.genus()},
                   {"seed", options.request.seed}});
    return Exit::holds;
}

}  // namespace

void add_make(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("make", "Make a surface and write it to a file");
    verb->add_option("KIND", options->kind, kinds_in_words())->required();
    verb->add_option("--vertices", options->vertices,
                     "Number of vertices (least the kind has; of data with points, a usual one)")
        ->check(whole_number());
    verb->add_option("--genus", options->request.genus, "Genus (0)")->check(whole_number());
    verb->add_option("--seed", options->request.seed, "Seed of the random stream (0)")
        ->check(whole_number());
    verb->add_option(
            "-o,--output", options->file,
            "File to write; data with points in the format of its extension (.obj, .off, .ply, "
            ".stl; .tfs or none: tightflip-surface)")
        ->check(file_name())
        ->required();
    verb->callback([&output, &action, options] {
        action = [&output, options] {
            return for_each_input(output, {options->file},
                                  [&](const std::string&) { return make(output, *options); });
        };
    });
}

}  // namespace tightflip::tools
