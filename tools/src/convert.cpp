#include "command.hpp"
#include "surface_input.hpp"
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using geometry::SurfaceFormat;

struct Options {
    std::string file;
    std::string output_file;
    std::string format;
    geometry::MeshWriteOptions write;
    InputOptions input;
};

/// The kernel's own format has no points, and is written only where it is named.
constexpr std::string_view without_points = "tightflip-triangulation";

/// What the output does not keep of the surface; empty where it keeps all that can be kept.
std::string_view losses(std::string_view format, bool is_text) {
    if (format == "obj" || format == "off" || format == "ply") {
        return "edge numbers are not kept (tightflip-surface keeps them)";
    }
    if (format == without_points) return "points are not kept";
    if (format != "stl") return "";
    return is_text ? "STL keeps neither the order of vertices nor edge numbers"
                   : "coordinates are rounded to float (--ascii writes them exactly); STL keeps "
                     "neither the order of vertices nor edge numbers";
}

struct Written {
    kernel::Triangulation surface;
    std::string format;
};

Written write(const Options& options, const SurfaceInput& input) {
    if (options.format == without_points) {
        kernel::Triangulation surface = input.triangulation();
        kernel::write_file(options.output_file,
                           [&](std::ostream& out) { write_text(out, surface); });
        return {std::move(surface), options.format};
    }
    const geometry::Surface surface = input.surface();
    const auto format = options.format.empty() ? geometry::surface_format_of(options.output_file)
                                               : geometry::surface_format_named(options.format);
    write_surface_file(options.output_file, surface.view(), format, options.write);
    return {surface.triangulation(), std::string(name(*format))};
}

Exit convert(const Output& output, const Options& options) {
    const SurfaceInput input(options.file, options.input);
    const auto [surface, format] = write(options, input);
    const bool is_text = options.write.encoding == geometry::MeshEncoding::text;
    output.say(fmt::format("{}: {} as {} in {}: {} vertices, {} edges, {} faces, genus {}",
                           options.file, input.format(), format, options.output_file,
                           surface.vertex_count(), surface.edge_count(), surface.face_count(),
                           surface.genus()));
    input.say_repairs(output);
    if (const auto lost = losses(format, is_text); !lost.empty()) {
        output.say(fmt::format("  {}", lost));
    }
    Json json{{"file", options.file},
              {"format", input.format()},
              {"output", options.output_file},
              {"output_format", format},
              {"vertices", surface.vertex_count()},
              {"edges", surface.edge_count()},
              {"faces", surface.face_count()},
              {"genus", surface.genus()}};
    input.add_repairs(json);
    output.object(json);
    return Exit::holds;
}

}  // namespace

void add_convert(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "convert", "Write a surface in another format, mended where options ask for it");
    verb->add_option("FILE", options->file, "Surface or mesh")->required();
    verb->add_option("-o,--output", options->output_file, "File to write")
        ->check(file_name())
        ->required();
    verb->add_option(
            "--format", options->format,
            "Format to write (else by the extension of the output: .obj, .off, .ply, .stl, "
            "and .tfs or none for tightflip-surface)")
        ->check(CLI::IsMember(std::vector<std::string>{"tightflip-surface", "obj", "off", "ply",
                                                       "stl", std::string(without_points)}));
    verb->add_flag_callback(
        "--ascii", [options] { options->write.encoding = geometry::MeshEncoding::text; },
        "Write PLY and STL as text (else binary)");
    verb->add_flag("--gluing", options->write.always_glued_sides,
                   "Let PLY say which sides are glued even where there are no parallel edges");
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    options->input.add_repair(*verb);
    verb->callback([&output, &action, options] {
        action = [&output, options] {
            return for_each_input(output, {options->file},
                                  [&](const std::string&) { return convert(output, *options); });
        };
    });
}

}  // namespace tightflip::tools
