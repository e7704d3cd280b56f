#include "mesh_text.hpp"
#include <tightflip/geometry/file_place.hpp>
#include <tightflip/geometry/soup_gluing.hpp>
#include <tightflip/geometry/surface_file.hpp>
#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/flip_log.hpp>

#include <algorithm>
#include <array>

namespace tightflip::geometry {
namespace {

using kernel::Violation;
using kernel::ViolationCode;

/// What mends a mesh that is no closed surface.
struct Remedy {
    ViolationCode code;
    std::string_view words;
};
/// What causes others comes first.
constexpr std::array<Remedy, 4> remedies{
    {{ViolationCode::corners_not_distinct, "--drop-faces drops faces that repeat a corner"},
     {ViolationCode::edge_in_more_than_two_faces,
      "--drop-faces drops faces that repeat others; PLY with glued_sides and the tightflip formats "
      "can say which sides are glued"},
     {ViolationCode::side_unglued,
      "--fill-holes closes boundaries; --weld joins sides whose ends stand at the same points"},
     {ViolationCode::vertex_unused, "--drop-unused drops vertices that no face has"}}};

std::string remedy_for(const kernel::AuditReport& report) {
    for (const Remedy& remedy : remedies) {
        if (report.has(remedy.code)) return "; " + std::string(remedy.words);
    }
    return {};
}

struct FormatName {
    SurfaceFormat format;
    std::string_view name;
    std::string_view extension;
    std::optional<MeshFormat> mesh;
};
constexpr std::array<FormatName, 5> format_names{
    {{SurfaceFormat::tightflip_surface, "tightflip-surface", ".tfs", {}},
     {SurfaceFormat::obj, "obj", ".obj", MeshFormat::obj},
     {SurfaceFormat::off, "off", ".off", MeshFormat::off},
     {SurfaceFormat::ply, "ply", ".ply", MeshFormat::ply},
     {SurfaceFormat::stl, "stl", ".stl", MeshFormat::stl}}};

const FormatName& entry(SurfaceFormat format) {
    return *std::ranges::find(format_names, format, &FormatName::format);
}

SurfaceFormat format_or_refusal(const std::filesystem::path& path) {
    if (const auto format = surface_format_of(path)) return *format;
    throw FileError(path.string(),
                    "its extension names no format to write; .obj, .off, .ply, .stl and .tfs do, "
                    "or name the format (--format)");
}

}  // namespace

SurfaceFile::SurfaceFile(const std::filesystem::path& path, const SurfaceFileOptions& options)
    : path_(path.string()), options_(options) {
    read(kernel::read_file(path));
}

void SurfaceFile::read(const std::string& bytes) {
    if (kernel::is_flip_log(bytes)) {
        throw FileError(path_, "this is a flip log, not a surface; use 'tightflip replay'");
    }
    if (is_surface_text(bytes)) {
        RawSurface surface = parse_surface(bytes, path_);
        format_ = name(SurfaceFormat::tightflip_surface);
        content_ = kernel::RawSurface(std::move(surface.table));
        points_ = std::move(surface.points);
    } else if (kernel::is_surface_text(bytes)) {
        kernel::RawSurface surface = kernel::parse_surface(bytes, path_);
        format_ = std::holds_alternative<kernel::Gluing>(surface) ? "tightflip-gluing"
                                                                  : "tightflip-triangulation";
        content_ = std::move(surface);
    } else {
        read_mesh_bytes(bytes);
    }
}

void SurfaceFile::read_mesh_bytes(const std::string& bytes) {
    const auto format = detect_mesh_format(bytes, path_);
    if (!format && !bytes.empty()) {
        throw FileError(path_,
                        "this is neither a tightflip format nor, by its content or its name's "
                        "extension, an OBJ, OFF, PLY or STL file");
    }
    TriangleSoup soup = read_mesh(
        bytes, path_, {.format = format, .triangulate_polygons = options_.triangulate_polygons});
    format_ = name(*format);
    if (options_.repair.any()) repairs_ = repair(soup, options_.repair);
    kernel::FaceListReading reading = glue(soup);
    content_ = Mesh{std::move(soup), std::move(reading)};
}

kernel::AuditReport SurfaceFile::audit() const {
    if (const auto* surface = std::get_if<kernel::RawSurface>(&content_)) {
        return kernel::audit(*surface);
    }
    return geometry::audit(std::get<Mesh>(content_).reading);
}

std::string SurfaceFile::where(const Violation& violation) const {
    const auto* mesh = std::get_if<Mesh>(&content_);
    return mesh != nullptr ? geometry::where(mesh->soup, violation) : kernel::where(violation);
}

Triangulation SurfaceFile::triangulation() const {
    const kernel::AuditReport report = audit();
    const auto* mesh = std::get_if<Mesh>(&content_);
    if (!report.is_valid()) {
        const Violation& first = report.violations.front();
        const auto position = mesh != nullptr ? file_position(mesh->soup, first) : std::nullopt;
        throw FileError(path_, position ? mesh->soup.unit : FileError::Unit::none,
                        position.value_or(0),
                        kernel::where(first) + ": " + message(first) +
                            (mesh != nullptr ? remedy_for(report) : "") +
                            " ('tightflip check' lists all violations)");
    }
    if (mesh == nullptr) return build(std::get<kernel::RawSurface>(content_)).value();
    if (!report.coherently_stored && !options_.reorient) {
        throw FileError(path_,
                        "its faces are not oriented alike; give --reorient to turn some over");
    }
    return build(mesh->reading.gluing).value();
}

Surface SurfaceFile::surface() const {
    const auto* mesh = std::get_if<Mesh>(&content_);
    if (mesh == nullptr && !points_) {
        throw FileError(path_, format_ + " has no coordinates; a mesh or tightflip-surface has");
    }
    return {triangulation(), mesh != nullptr ? mesh->soup.points : *points_};
}

kernel::RawTable SurfaceFile::table() const {
    if (const auto* surface = std::get_if<kernel::RawSurface>(&content_)) {
        if (const auto* table = std::get_if<kernel::RawTable>(surface)) return *table;
    }
    const Triangulation built = triangulation();
    return {.vertex_count = built.vertex_count(),
            .records = {built.table().begin(), built.table().end()}};
}

Surface read_surface_file(const std::filesystem::path& path, const SurfaceFileOptions& options) {
    return SurfaceFile(path, options).surface();
}

std::string_view name(SurfaceFormat format) {
    return entry(format).name;
}

std::optional<SurfaceFormat> surface_format_named(std::string_view name) {
    const auto* found = std::ranges::find(format_names, name, &FormatName::name);
    if (found == format_names.end()) return std::nullopt;
    return found->format;
}

std::optional<SurfaceFormat> surface_format_of(const std::filesystem::path& path) {
    const std::string extension = lowered(path.extension().string());
    if (extension.empty()) return SurfaceFormat::tightflip_surface;
    const auto* found = std::ranges::find(format_names, extension, &FormatName::extension);
    if (found == format_names.end()) return std::nullopt;
    return found->format;
}

void write_surface_file(const std::filesystem::path& path, const SurfaceView& surface,
                        std::optional<SurfaceFormat> format, const MeshWriteOptions& options) {
    const auto mesh = entry(format ? *format : format_or_refusal(path)).mesh;
    if (mesh) {
        const auto obstacle = obstacle_to_writing(surface, *mesh, options.encoding);
        if (obstacle) throw FileError(path.string(), *obstacle);
    }
    kernel::write_file(path, [&](std::ostream& out) {
        mesh ? write_mesh(out, surface, *mesh, options) : write_text(out, surface);
    });
}

}  // namespace tightflip::geometry
