#include "surface_input.hpp"

#include <charconv>

namespace tightflip::tools {
namespace {

geometry::SurfaceFileOptions file_options(const InputOptions& options) {
    geometry::RepairOptions repair = options.repair_all ? geometry::all_repairs : options.repair;
    if (!options.weld.empty()) {
        double distance = 0;
        std::from_chars(options.weld.data(), options.weld.data() + options.weld.size(), distance);
        repair.weld = distance;
    }
    return {.triangulate_polygons = options.triangulate,
            .reorient = options.reorient,
            .repair = repair};
}

}  // namespace

void InputOptions::add_triangulate(CLI::App& verb) {
    verb.add_flag("--triangulate", triangulate,
                  "Cut polygons of a mesh file into triangles (else they are refused)");
}

void InputOptions::add_reorient(CLI::App& verb) {
    verb.add_flag(
        "--reorient", reorient,
        "Turn faces of a mesh file over where they are not oriented alike (else refused)");
}

void InputOptions::add_repair(CLI::App& verb) {
    // The flag takes its value with '=' alone, so that it never takes a file's name for one.
    verb.add_flag("--weld{0}", weld,
                  "Make points of a mesh file one that are equal or, with --weld=DISTANCE, no "
                  "further apart")
        ->check(length());
    verb.add_flag("--drop-faces", repair.drop_faces,
                  "Drop faces of a mesh file that repeat a corner or another face");
    verb.add_flag("--drop-unused", repair.drop_unused,
                  "Drop vertices of a mesh file that no face has");
    verb.add_flag("--fill-holes", repair.fill_holes,
                  "Close the boundary of a mesh file with fans of new faces");
    verb.add_flag("--repair", repair_all,
                  "Do all four: --weld, --drop-faces, --drop-unused, --fill-holes");
}

SurfaceInput::SurfaceInput(const std::string& path, const InputOptions& options)
    : SurfaceFile(path, file_options(options)) {}

void SurfaceInput::say_repairs(const Output& output) const {
    if (!repairs()) return;
    for (const std::string& line : geometry::in_words(*repairs()))
        output.say("  repair: " + line);
}

void SurfaceInput::add_repairs(Json& json) const {
    if (!repairs()) return;
    json["repairs"] = {{"points_welded", repairs()->points_welded},
                       {"faces_repeating_corners", repairs()->faces_repeating_corners},
                       {"faces_repeating_faces", repairs()->faces_repeating_faces},
                       {"vertices_unused", repairs()->vertices_unused},
                       {"holes_filled", repairs()->holes_filled},
                       {"faces_added", repairs()->faces_added},
                       {"sides_left_open", repairs()->sides_left_open},
                       {"gluing_dropped", repairs()->gluing_dropped}};
}

}  // namespace tightflip::tools
