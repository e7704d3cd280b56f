#include "mesh_text.hpp"
#include "soup_builder.hpp"
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/geometry/point_file.hpp>
#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/surface_text.hpp>

namespace tightflip::geometry {
namespace {

constexpr MeshFileOptions points_alone{.triangulate_polygons = true, .faces_required = false};

TriangleSoup read_bare_points(std::string_view bytes, const std::string& source) {
    TextCursor cursor(bytes, source, commented_lines);
    SoupBuilder builder({bytes, source, points_alone}, FileError::Unit::line, 0);
    while (cursor.next_line()) {
        const double x = cursor.number("the x coordinate (three coordinates a line)");
        const double y = cursor.number("the y coordinate");
        const double z = cursor.number("the z coordinate");
        cursor.require_end_of_line("a point's three coordinates");
        builder.add_point({x, y, z}, cursor.line());
    }
    return std::move(builder).finish();
}

}  // namespace

std::vector<Point> read_points(std::string_view bytes, const std::string& source) {
    if (is_surface_text(bytes)) return parse_surface(bytes, source).points;
    if (kernel::is_surface_text(bytes)) {
        throw FileError(source,
                        "this format has no coordinates; a mesh, tightflip-surface or a "
                        "text with three coordinates a line has");
    }
    const auto format = detect_mesh_format(bytes, source);
    MeshFileOptions options = points_alone;
    options.format = format;
    TriangleSoup soup =
        format ? read_mesh(bytes, source, options) : read_bare_points(bytes, source);
    if (soup.points.empty()) throw FileError(source, "the file has no points");
    return std::move(soup.points);
}

std::vector<Point> read_point_file(const std::filesystem::path& path) {
    return read_points(kernel::read_file(path), path.string());
}

}  // namespace tightflip::geometry
