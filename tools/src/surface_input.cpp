#include "surface_input.hpp"

#include <tightflip/geometry/file_place.hpp>
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/flip_log.hpp>

#include <algorithm>

namespace tightflip::tools {

using kernel::AuditReport;
using kernel::FileError;
using kernel::Violation;

void InputOptions::add_triangulate(CLI::App& verb) {
    verb.add_flag("--triangulate", triangulate,
                  "Cut polygons of a mesh file into triangles (else they are refused)");
}

void InputOptions::add_reorient(CLI::App& verb) {
    verb.add_flag(
        "--reorient", reorient,
        "Turn faces of a mesh file over where they are not oriented alike (else refused)");
}

SurfaceInput::SurfaceInput(const std::string& path, const InputOptions& options)
    : path_(path), options_(options) {
    const std::string bytes = kernel::read_file(path);
    if (kernel::is_flip_log(bytes)) {
        throw FileError(path, "this is a flip log, not a surface; use 'tightflip replay'");
    }
    if (kernel::is_surface_text(bytes)) {
        kernel::RawSurface surface = kernel::parse_surface(bytes, path);
        format_ = std::holds_alternative<kernel::Gluing>(surface) ? "tightflip-gluing"
                                                                  : "tightflip-triangulation";
        content_ = std::move(surface);
        return;
    }
    const auto format = geometry::detect_mesh_format(bytes, path);
    if (!format && !bytes.empty()) {
        throw FileError(path,
                        "this is neither a tightflip format nor, by its content or its name's "
                        "extension, an OBJ, OFF, PLY or STL file");
    }
    geometry::TriangleSoup soup = geometry::read_mesh(
        bytes, path, {.format = format, .triangulate_polygons = options.triangulate});
    format_ = geometry::name(*format);
    kernel::FaceListReading reading = kernel::glue_faces(soup.triangles, soup.vertex_count());
    content_ = Mesh{std::move(soup), std::move(reading)};
}

AuditReport SurfaceInput::audit() const {
    if (const auto* surface = std::get_if<kernel::RawSurface>(&content_)) {
        return kernel::audit(*surface);
    }
    const auto& reading = std::get<Mesh>(content_).reading;
    AuditReport report = kernel::audit(reading.gluing);
    report.violation_count += static_cast<std::int64_t>(reading.violations.size());
    const auto kept = std::min(static_cast<std::int64_t>(reading.violations.size()),
                               kernel::AuditOptions{}.max_per_code);
    report.violations.insert(report.violations.begin(), reading.violations.begin(),
                             reading.violations.begin() + kept);
    std::ranges::stable_sort(report.violations, kernel::precedes);
    return report;
}

std::string SurfaceInput::where(const Violation& violation) const {
    const auto* mesh = std::get_if<Mesh>(&content_);
    return mesh != nullptr ? geometry::where(mesh->soup, violation) : kernel::where(violation);
}

kernel::Triangulation SurfaceInput::triangulation() const {
    AuditReport report = audit();
    if (!report.is_valid()) {
        const Violation& first = report.violations.front();
        const auto* mesh = std::get_if<Mesh>(&content_);
        const auto position = mesh != nullptr ? file_position(mesh->soup, first) : std::nullopt;
        throw FileError(path_, position ? mesh->soup.unit : FileError::Unit::none,
                        position.value_or(0),
                        kernel::where(first) + ": " + message(first) +
                            " ('tightflip check' lists all violations)");
    }
    if (const auto* surface = std::get_if<kernel::RawSurface>(&content_)) {
        return build(*surface).value();
    }
    if (!report.coherently_stored && !options_.reorient) {
        throw FileError(path_,
                        "its faces are not oriented alike; give --reorient to turn some over");
    }
    return build(std::get<Mesh>(content_).reading.gluing).value();
}

kernel::RawTable SurfaceInput::table() const {
    if (const auto* surface = std::get_if<kernel::RawSurface>(&content_)) {
        if (const auto* table = std::get_if<kernel::RawTable>(surface)) return *table;
    }
    const kernel::Triangulation built = triangulation();
    return {.vertex_count = built.vertex_count(),
            .records = {built.table().begin(), built.table().end()}};
}

}  // namespace tightflip::tools
