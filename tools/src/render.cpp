#include "command.hpp"
#include "png.hpp"
#include "surface_input.hpp"
#include <tightflip/geometry/drawing.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using geometry::DrawingStyle;
using geometry::VertexColouring;

struct Options {
    std::string file;
    std::string output_file;
    geometry::DrawingOptions drawing;
    InputOptions input;
};

/// Takes "AZIMUTH,ELEVATION"; false where it is something else.
bool read_view(const std::string& text, geometry::DrawingOptions& drawing) {
    const char* const end = text.data() + text.size();
    const auto [comma, first] = std::from_chars(text.data(), end, drawing.azimuth);
    if (first != std::errc{} || comma == end || *comma != ',') return false;
    const auto [stopped, second] = std::from_chars(comma + 1, end, drawing.elevation);
    return second == std::errc{} && stopped == end && std::isfinite(drawing.azimuth) &&
           std::abs(drawing.elevation) <= 90;
}

/// An option that takes one of some words.
template <class Value>
CLI::Option* add_choice(CLI::App& verb, const std::string& option, Value& value,
                        const std::map<std::string, Value>& words, const std::string& description) {
    return verb
        .add_option_function<std::string>(
            option, [&value, words](const std::string& word) { value = words.at(word); },
            description)
        ->check(CLI::IsMember(words));
}

bool has_extension(const std::string& name, std::string_view extension) {
    return CLI::detail::to_lower(std::filesystem::path(name).extension().string()) == extension;
}

std::string picture_of(const geometry::Surface& surface, const Options& options) {
    std::ostringstream svg;
    geometry::write_svg(svg, surface.view(), options.drawing);
    return has_extension(options.output_file, ".png") ? png_of(svg.str()) : svg.str();
}

Exit render(const Output& output, const Options& options) {
    const SurfaceInput input(options.file, options.input);
    const geometry::Surface surface = input.surface();
    const kernel::Triangulation& t = surface.triangulation();
    const std::string picture = picture_of(surface, options);
    kernel::write_file(options.output_file, [&](std::ostream& out) { out << picture; });
    output.say(fmt::format("{}: {} vertices, {} edges, {} faces, drawn in {}", options.file,
                           t.vertex_count(), t.edge_count(), t.face_count(), options.output_file));
    output.object({{"file", options.file},
                   {"vertices", t.vertex_count()},
                   {"edges", t.edge_count()},
                   {"faces", t.face_count()},
                   {"azimuth", options.drawing.azimuth},
                   {"elevation", options.drawing.elevation},
                   {"size", options.drawing.size},
                   {"output", options.output_file}});
    return Exit::holds;
}

}  // namespace

void add_render(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    geometry::DrawingOptions& drawing = options->drawing;
    CLI::App* verb = app.add_subcommand("render", "Draw a surface as SVG or PNG");
    verb->add_option("FILE", options->file, "Surface or mesh with points")->required();
    verb->add_option("-o,--output", options->output_file, "Picture to write, .svg or .png")
        ->check(file_name())
        ->required();
    verb->add_option_function<std::string>(
            "--view",
            [&drawing](const std::string& text) {
                if (!read_view(text, drawing)) {
                    throw CLI::ValidationError(
                        "--view", fmt::format("'{}' is no AZIMUTH,ELEVATION in degrees with an "
                                              "elevation of -90 to 90",
                                              text));
                }
            },
            "Where to look from: degrees about the z axis, degrees above the xy plane")
        ->default_str("30,20");
    add_choice(*verb, "--style", drawing.style,
               {{"shaded", DrawingStyle::shaded}, {"wireframe", DrawingStyle::wireframe}},
               "shaded, or wireframe with hidden lines dashed")
        ->default_str("shaded");
    add_choice(*verb, "--colour", drawing.colouring,
               {{"type", VertexColouring::type},
                {"curvature", VertexColouring::curvature},
                {"none", VertexColouring::none}},
               "What vertices show: type (convex, saddle, mixed, flat), curvature (the angle "
               "deficit) or none")
        ->default_str("type");
    const CLI::Option* hidden =
        verb->add_flag("--hidden-edges,!--no-hidden-edges", drawing.hidden_edges,
                       "Hidden edges dashed (else only in a wireframe), or not");
    verb->add_option("--size", drawing.size, "Width in pixels")
        ->check(CLI::Range(100, 10000))
        ->capture_default_str();
    verb->add_option("--title", drawing.title, "Title above the picture");
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    verb->callback([&output, &action, options, hidden] {
        if (!has_extension(options->output_file, ".svg") &&
            !has_extension(options->output_file, ".png")) {
            throw CLI::ValidationError(
                "--output", fmt::format("'{}' must end in .svg or .png", options->output_file));
        }
        if (hidden->count() == 0) {
            options->drawing.hidden_edges = options->drawing.style == DrawingStyle::wireframe;
        }
        action = [&output, options] {
            return for_each_input(output, {options->file},
                                  [&](const std::string&) { return render(output, *options); });
        };
    });
}

}  // namespace tightflip::tools
