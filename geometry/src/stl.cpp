#include "byte_order.hpp"
#include "formats.hpp"
#include "merge_equal_points.hpp"
#include "mesh_text.hpp"
#include "soup_builder.hpp"

#include <bit>
#include <utility>
#include <vector>

namespace tightflip::geometry {
namespace {

// Binary STL: 80 bytes of anything, the number of triangles, then 50 bytes each: the normal, three
// points and two bytes of attributes.
constexpr std::size_t header_size = 80;
constexpr std::size_t triangles_begin = 84;
constexpr std::size_t triangle_size = 50;
constexpr std::size_t normal_size = 12;

std::uint64_t binary_triangle_count(std::string_view bytes) {
    return load<std::uint32_t>(bytes, header_size, std::endian::little);
}

std::uint64_t binary_size(std::uint64_t triangle_count) {
    return triangles_begin + triangle_size * triangle_count;
}

bool has_binary_size(std::string_view bytes) {
    return bytes.size() >= triangles_begin &&
           bytes.size() == binary_size(binary_triangle_count(bytes));
}

/// A text begins with "solid". So do some binary files, but they have the size their count says.
bool is_text(std::string_view bytes) {
    if (has_binary_size(bytes)) return false;
    TextCursor cursor(bytes, "", bare_lines);
    return cursor.next_line() && lowered(cursor.word()) == "solid";
}

/// Adds a polygon with new points of its own, to be merged later.
void add_loose_polygon(SoupBuilder& builder, std::size_t corner_count, std::uint64_t position) {
    std::vector<std::int64_t> corners(corner_count);
    for (std::size_t i = 0; i < corner_count; ++i) {
        corners[i] = builder.point_count() - static_cast<std::int64_t>(corner_count - i);
    }
    builder.add_polygon(corners, position);
}

void expect(TextCursor& cursor, std::string_view word) {
    const std::string_view found = cursor.word(quoted(word));
    if (lowered(found) != word) {
        cursor.fail(quoted(word) + " should stand here, not " + quoted(found));
    }
}

/// facet normal, outer loop, vertices, endloop, endfacet; the word facet is taken already.
void read_facet(TextCursor& cursor, SoupBuilder& builder) {
    const std::uint64_t line = cursor.line();
    expect(cursor, "normal");
    for (int i = 0; i < 3; ++i)
        cursor.number("the normal's coordinate");
    cursor.require_end_of_line("the normal");
    cursor.require_line("'outer loop'");
    expect(cursor, "outer");
    expect(cursor, "loop");
    cursor.require_end_of_line("'outer loop'");
    std::size_t corners = 0;
    while (true) {
        cursor.require_line("a vertex or 'endloop'");
        if (lowered(cursor.peek()) != "vertex") break;
        cursor.word();
        const double x = cursor.number("the x coordinate");
        const double y = cursor.number("the y coordinate");
        const double z = cursor.number("the z coordinate");
        cursor.require_end_of_line("a vertex's coordinates");
        builder.add_point({x, y, z}, cursor.line());
        ++corners;
    }
    expect(cursor, "endloop");
    cursor.require_end_of_line("'endloop'");
    cursor.require_line("'endfacet'");
    expect(cursor, "endfacet");
    cursor.require_end_of_line("'endfacet'");
    add_loose_polygon(builder, corners, line);
}

TriangleSoup read_text(const MeshInput& input) {
    TextCursor cursor(input.bytes, std::string(input.source), bare_lines);
    SoupBuilder builder(input, FileError::Unit::line, 0);
    while (cursor.next_line()) {
        expect(cursor, "solid");  // the rest of the line is its name
        while (true) {
            cursor.require_line("'facet' or 'endsolid'");
            if (lowered(cursor.peek()) != "facet") break;
            cursor.word();
            read_facet(cursor, builder);
        }
        expect(cursor, "endsolid");
    }
    return std::move(builder).finish();
}

TriangleSoup read_binary(const MeshInput& input) {
    const std::string_view bytes = input.bytes;
    const auto fail = [&](std::uint64_t at, std::string reason) {
        throw FileError(std::string(input.source), FileError::Unit::byte, at, std::move(reason));
    };
    if (bytes.size() < triangles_begin) {
        fail(bytes.size(),
             "the file ends inside the 84 bytes that begin a binary STL file, and it "
             "is no text, which would begin with 'solid'");
    }
    const std::uint64_t count = binary_triangle_count(bytes);
    if (bytes.size() != binary_size(count)) {
        fail(header_size, "the header promises " + std::to_string(count) + " triangles, so " +
                              std::to_string(binary_size(count)) + " bytes, but the file has " +
                              std::to_string(bytes.size()) +
                              "; it is cut short or damaged, or no STL file");
    }
    SoupBuilder builder(input, FileError::Unit::byte, 0);
    builder.reserve(3 * count, count);
    for (std::size_t at = triangles_begin; at < bytes.size(); at += triangle_size) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t begin = at + normal_size + 12 * corner;
            Eigen::Vector3d point;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                point[static_cast<int>(axis)] =
                    load<float>(bytes, begin + 4 * axis, std::endian::little);
            }
            builder.add_point(point, begin);
        }
        add_loose_polygon(builder, 3, at);
    }
    return std::move(builder).finish();
}

}  // namespace

bool looks_like_stl(std::string_view bytes) {
    return has_binary_size(bytes) || is_text(bytes);
}

TriangleSoup read_stl(const MeshInput& input) {
    TriangleSoup soup = is_text(input.bytes) ? read_text(input) : read_binary(input);
    merge_equal_points(soup);
    return soup;
}

}  // namespace tightflip::geometry
