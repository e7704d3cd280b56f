#include "command.hpp"
#include "surface_input.hpp"
#include <tightflip/geometry/general_position.hpp>
#include <tightflip/geometry/pinch_points.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/geometry/surface_values.hpp>
#include <tightflip/geometry/value_names.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using geometry::GeneralPosition;
using geometry::SurfaceMeasures;
using geometry::SurfaceView;

/// A table of values: where to write it, and how.
struct Table {
    const char* option;
    const char* key;
    const char* description;
    void (*write)(std::ostream& out, const SurfaceView& surface);
};
constexpr std::array<Table, 3> tables{
    {{"--vertices-csv", "vertices_csv", "Write the values at vertices here, as CSV",
      geometry::write_vertices_csv},
     {"--edges-csv", "edges_csv", "Write the values at edges here, as CSV",
      geometry::write_edges_csv},
     {"--ply", "ply", "Write the surface here as PLY, the values at vertices as properties",
      geometry::write_ply_with_values}}};

struct Options {
    std::vector<std::string> files;
    std::array<std::string, tables.size()> outputs;  // a name for each table asked for
    std::int64_t most_intersections = 10'000'000;
    InputOptions input;

    [[nodiscard]] bool writes() const {
        return std::ranges::any_of(outputs, [](const std::string& name) { return !name.empty(); });
    }
};

/// JSON has no infinity.
Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// All that is measured of a surface.
struct Findings {
    SurfaceMeasures measures;
    std::size_t pinch_points;
    geometry::SelfIntersections intersections;
    GeneralPosition position;

    Findings(const SurfaceView& surface, std::int64_t most_intersections)
        : measures(geometry::measure(surface)),
          pinch_points(geometry::pinch_points(surface).size()),
          intersections(geometry::find_self_intersections(surface, 0, most_intersections)),
          position(geometry::general_position(surface)) {}
};

std::string_view name(geometry::PositionScope scope) {
    return scope == geometry::PositionScope::all_points ? "all_points" : "flips";
}

/// Adds a count for each name of an enumeration, under "convex_vertices" and the like.
template <class Names, class Counts>
void add_counts(Json& json, const Names& names, const Counts& counts, std::string_view of) {
    for (std::size_t i = 0; i < names.size(); ++i)
        json[fmt::format("{}_{}", names.at(i), of)] = counts.at(i);
}

void add(Json& json, const Findings& found) {
    const SurfaceMeasures& m = found.measures;
    json["total_curvature"] = finite(m.total_curvature);
    json["total_positive_curvature"] = finite(m.total_positive_curvature);
    json["total_absolute_curvature"] = finite(m.total_absolute_curvature);
    json["mean_absolute_curvature"] = finite(m.mean_absolute_curvature);
    json["mean_absolute_curvature_weighted"] = finite(m.mean_absolute_curvature_weighted);
    json["integral_mean_curvature"] = finite(m.integral_mean_curvature);
    json["area"] = finite(m.area);
    json["volume"] = finite(m.volume);
    add_counts(json, geometry::vertex_type_names, m.vertex_types, "vertices");
    add_counts(json, geometry::edge_shape_names, m.edge_shapes, "edges");
    json["pinch_points"] = found.pinch_points;
    json["local_self_intersections"] = found.intersections.local_count;
    json["global_self_intersections"] = found.intersections.global_count;
    json["self_intersections_complete"] = found.intersections.is_complete;
    json["embedded"] = found.intersections.is_embedded();
    json["general_position"] = found.position.holds();
    json["general_position_scope"] = name(found.position.scope);
    json["coincident_pairs"] = found.position.coincident.count;
    json["collinear_triples"] = found.position.collinear.count;
    json["coplanar_quadruples"] = found.position.coplanar.count;
}

template <class Names, class Counts>
std::string counts_in_words(const Names& names, const Counts& counts) {
    std::string words;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (counts.at(i) == 0) continue;
        words += fmt::format("{}{} {}", words.empty() ? "" : ", ", counts.at(i), names.at(i));
    }
    return words;
}

std::string position_in_words(const GeneralPosition& position) {
    const std::string_view looked_at = position.scope == geometry::PositionScope::all_points
                                           ? "of all points"
                                           : "of those that flips meet";
    if (position.holds()) return fmt::format("in general position ({})", looked_at);
    return fmt::format(
        "not in general position ({}): {} coincident pairs, {} collinear triples, {} coplanar "
        "quadruples",
        looked_at, position.coincident.count, position.collinear.count, position.coplanar.count);
}

std::string in_words(const Findings& found) {
    const SurfaceMeasures& m = found.measures;
    return fmt::format(
        "  total curvature {:.9g}, absolute {:.9g}\n"
        "  mean absolute curvature {:.9g}, by lengths {:.9g}\n"
        "  area {:.9g}, volume {:.9g}\n"
        "  vertices: {}\n  edges: {}\n"
        "  {}: {}{} local and {} global self-intersections, {} pinch points\n  {}",
        m.total_curvature, m.total_absolute_curvature, m.mean_absolute_curvature,
        m.mean_absolute_curvature_weighted, m.area, m.volume,
        counts_in_words(geometry::vertex_type_names, m.vertex_types),
        counts_in_words(geometry::edge_shape_names, m.edge_shapes),
        found.intersections.is_embedded() ? "embedded" : "not embedded",
        found.intersections.is_complete ? "" : "at least ", found.intersections.local_count,
        found.intersections.global_count, found.pinch_points, position_in_words(found.position));
}

Exit measure_file(const Output& output, const Options& options, const std::string& file) {
    const SurfaceInput input(file, options.input);
    const geometry::Surface surface = input.surface();
    const kernel::Triangulation& t = surface.triangulation();
    const Findings found(surface.view(), options.most_intersections);
    Json json{{"file", file},
              {"format", input.format()},
              {"vertices", t.vertex_count()},
              {"edges", t.edge_count()},
              {"faces", t.face_count()},
              {"genus", t.genus()}};
    add(json, found);
    for (std::size_t i = 0; i < tables.size(); ++i) {
        if (options.outputs.at(i).empty()) continue;
        kernel::write_file(options.outputs.at(i),
                           [&](std::ostream& out) { tables.at(i).write(out, surface.view()); });
        json[tables.at(i).key] = options.outputs.at(i);
    }
    output.say(fmt::format("{}: {} vertices, {} edges, {} faces, genus {}\n{}", file,
                           t.vertex_count(), t.edge_count(), t.face_count(), t.genus(),
                           in_words(found)));
    output.object(json);
    return Exit::holds;
}

}  // namespace

void add_measure(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "measure", "Measure surfaces in space: curvatures, area, volume, self-intersections");
    verb->add_option("FILE", options->files, "Surfaces or meshes with points")->required();
    for (std::size_t i = 0; i < tables.size(); ++i) {
        verb->add_option(tables.at(i).option, options->outputs.at(i), tables.at(i).description);
    }
    verb->add_option("--max-intersections", options->most_intersections,
                     "Count so many pairs of faces that meet and no more")
        ->check(whole_number(1))
        ->capture_default_str();
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    verb->callback([&output, &action, options] {
        if (options->files.size() > 1 && options->writes()) {
            throw CLI::ValidationError("FILE", "must be one where values are written");
        }
        for (std::size_t i = 0; i < tables.size(); ++i) {
            std::error_code none;  // files that do not exist are not the same
            if (std::filesystem::equivalent(options->files.front(), options->outputs.at(i), none)) {
                throw CLI::ValidationError(tables.at(i).option,
                                           "must be another file than the surface");
            }
            for (std::size_t j = 0; j < i; ++j) {
                if (!options->outputs.at(i).empty() &&
                    options->outputs.at(i) == options->outputs.at(j)) {
                    throw CLI::ValidationError(
                        tables.at(i).option,
                        fmt::format("must be another file than {}", tables.at(j).option));
                }
            }
        }
        action = [&output, options] {
            return for_each_input(output, options->files, [&](const std::string& file) {
                return measure_file(output, *options, file);
            });
        };
    });
}

}  // namespace tightflip::tools
