#include "formats.hpp"
#include "mesh_text.hpp"
#include "soup_builder.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace tightflip::geometry {
namespace {

/// Statements that change neither a vertex nor a face. What is in no table may do so, and is
/// refused: free-form curves and surfaces, or `call`, which reads another file.
constexpr std::array<std::string_view, 19> ignored{
    "vt",       "vn",       "vp",     "p",          "l",        "g",      "o",
    "s",        "mg",       "usemtl", "mtllib",     "usemap",   "maplib", "bevel",
    "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj"};

bool is_ignored(std::string_view statement) {
    return std::ranges::find(ignored, statement) != ignored.end();
}

/// `v x y z`, then a weight or a colour or both, which say nothing about the surface.
void read_vertex(TextCursor& cursor, SoupBuilder& builder) {
    Eigen::Vector3d point;
    for (const auto& [axis, expected] :
         {std::pair{0, "the x coordinate"}, std::pair{1, "the y coordinate"},
          std::pair{2, "the z coordinate"}}) {
        point[axis] = cursor.number(expected);
    }
    for (int extra = 0; extra < 4 && !cursor.peek().empty(); ++extra) {
        cursor.number("a weight or colour");
    }
    cursor.require_end_of_line("a vertex's coordinates, weight and colour");
    builder.add_point(point, cursor.line());
}

/// One of the references in v, v/vt, v//vn and v/vt/vn: a number that is not zero.
std::int64_t reference(TextCursor& cursor, std::string_view corner, std::string_view part) {
    const std::int64_t label = cursor.parse_integer(part).value_or(0);
    if (label == 0) {
        cursor.fail("the corner " + quoted(corner) +
                    " is not of the form v, v/vt, v//vn or v/vt/vn with numbers from 1, or from -1 "
                    "down for the latest");
    }
    return label;
}

/// The vertex of a corner, counted from 0.
std::int64_t corner_vertex(TextCursor& cursor, std::string_view corner,
                           const SoupBuilder& builder) {
    const std::size_t slash = std::min(corner.find('/'), corner.size());
    const std::int64_t label = reference(cursor, corner, corner.substr(0, slash));
    if (slash < corner.size()) {
        const std::string_view rest = corner.substr(slash + 1);
        const std::size_t second = std::min(rest.find('/'), rest.size());
        if (second != 0) (void)reference(cursor, corner, rest.substr(0, second));
        if (second == 0 || second < rest.size()) {
            (void)reference(cursor, corner, rest.substr(std::min(second + 1, rest.size())));
        }
    }
    if (label > 0) return label - 1;
    if (label < -builder.point_count()) {
        cursor.fail("the relative vertex " + quoted(corner) + " reaches back before the first of " +
                    std::to_string(builder.point_count()) + " vertices so far");
    }
    return builder.point_count() + label;
}

}  // namespace

bool looks_like_obj(std::string_view bytes) {
    TextCursor cursor(bytes, "", continued_lines);
    if (!cursor.next_line()) return false;
    const std::string_view statement = cursor.word();
    return statement == "v" || statement == "f" || is_ignored(statement);
}

TriangleSoup read_obj(const MeshInput& input) {
    TextCursor cursor(input.bytes, std::string(input.source), continued_lines);
    SoupBuilder builder(input, FileError::Unit::line, 1);
    std::vector<std::int64_t> corners;
    while (cursor.next_line()) {
        const std::uint64_t line = cursor.line();
        const std::string_view statement = cursor.word();
        if (statement == "v") {
            read_vertex(cursor, builder);
        } else if (statement == "f") {
            corners.clear();
            for (auto corner = cursor.word(); !corner.empty(); corner = cursor.word()) {
                corners.push_back(corner_vertex(cursor, corner, builder));
            }
            builder.add_polygon(corners, line);
        } else if (!is_ignored(statement)) {
            cursor.fail(quoted(statement) +
                        " is not a statement of an OBJ file of polygons; remove it, or export the "
                        "mesh as polygons");
        }
    }
    return std::move(builder).finish();
}

}  // namespace tightflip::geometry
