#include "formats.hpp"
#include "mesh_text.hpp"
#include "soup_builder.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace tightflip::geometry {
namespace {

/// The keyword: [ST][C][N][4][n]OFF.
struct Keyword {
    std::size_t size = 0;          ///< bytes; 0 where there is none
    bool extra_numbers = false;    ///< texture coordinates, colour or normal follow a vertex
    bool other_dimension = false;  ///< points of another dimension than 3
};

Keyword keyword_of(std::string_view word) {
    Keyword keyword;
    const auto takes = [&](std::string_view part) {
        const bool found = word.substr(keyword.size).starts_with(part);
        if (found) keyword.size += part.size();
        return found;
    };
    for (const std::string_view part : {"ST", "C", "N"})
        keyword.extra_numbers |= takes(part);
    for (const std::string_view part : {"4", "n"})
        keyword.other_dimension |= takes(part);
    return takes("OFF") ? keyword : Keyword{};
}

struct Header {
    Keyword keyword;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
};

/// The keyword, which is optional, and the counts, on its line or on the next.
Header read_header(TextCursor& cursor) {
    Header header;
    cursor.require_line("the keyword OFF");
    header.keyword = keyword_of(cursor.peek());
    cursor.skip_bytes(header.keyword.size);
    if (header.keyword.other_dimension) {
        cursor.fail("points of another dimension than three (4OFF, nOFF) are not read");
    }
    if (cursor.peek() == "BINARY") {
        cursor.fail("the binary variant of OFF is not read; export the file as text, or as PLY");
    }
    if (cursor.peek().empty()) cursor.require_line("the numbers of vertices and faces");
    header.vertices = cursor.count("the number of vertices");
    header.faces = cursor.count("the number of faces");
    if (!cursor.peek().empty()) cursor.count("the number of edges");
    cursor.require_end_of_line("the numbers of vertices, faces and edges");
    return header;
}

/// A line of a face has at least "3 0 0 0" or, refused later, "0"; a vertex has "0 0 0".
void refuse_impossible_counts(const TextCursor& cursor, const Header& header,
                              std::size_t bytes_left) {
    // The last line needs no line feed.
    const std::uint64_t most_vertices = (bytes_left + 1) / 6;
    if (header.vertices > most_vertices ||
        header.faces > (bytes_left + 1 - 6 * header.vertices) / 2) {
        cursor.fail("the header promises " + std::to_string(header.vertices) + " vertices and " +
                    std::to_string(header.faces) + " faces, which do not fit in the " +
                    std::to_string(bytes_left) +
                    " bytes that follow; the file is cut short or its "
                    "header damaged");
    }
}

void require_row(TextCursor& cursor, const char* what, std::uint64_t i, std::uint64_t count) {
    if (cursor.next_line()) return;
    cursor.fail("the file ends before " + std::string(what) + " " + std::to_string(i) + " of the " +
                std::to_string(count) + " that its header promises");
}

void read_vertices(TextCursor& cursor, const Header& header, SoupBuilder& builder) {
    for (std::uint64_t v = 0; v < header.vertices; ++v) {
        require_row(cursor, "vertex", v, header.vertices);
        const double x = cursor.number("the x coordinate");
        const double y = cursor.number("the y coordinate");
        const double z = cursor.number("the z coordinate");
        while (header.keyword.extra_numbers && !cursor.peek().empty()) {
            cursor.number("a normal, colour or texture coordinate");
        }
        cursor.require_end_of_line(
            "three coordinates; normals, colours and texture coordinates need NOFF, COFF or STOFF");
        builder.add_point({x, y, z}, cursor.line());
    }
}

void read_faces(TextCursor& cursor, const Header& header, SoupBuilder& builder) {
    constexpr int most_colour_numbers = 4;
    std::vector<std::int64_t> corners;
    for (std::uint64_t f = 0; f < header.faces; ++f) {
        require_row(cursor, "face", f, header.faces);
        const std::uint64_t n = cursor.count("the number of corners");
        corners.clear();
        for (std::uint64_t i = 0; i < n; ++i) {
            corners.push_back(cursor.integer("a corner"));
        }
        for (int i = 0; i < most_colour_numbers && !cursor.peek().empty(); ++i) {
            cursor.number("a colour");
        }
        cursor.require_end_of_line("the corners and colour of a face");
        builder.add_polygon(corners, cursor.line());
    }
}

}  // namespace

bool looks_like_off(std::string_view bytes) {
    TextCursor cursor(bytes, "", commented_lines);
    return cursor.next_line() && keyword_of(cursor.peek()).size > 0;
}

TriangleSoup read_off(const MeshInput& input) {
    TextCursor cursor(input.bytes, std::string(input.source), commented_lines);
    SoupBuilder builder(input, FileError::Unit::line, 0);
    const Header header = read_header(cursor);
    refuse_impossible_counts(cursor, header, input.bytes.size() - cursor.after_line());
    builder.reserve(header.vertices, header.faces);
    read_vertices(cursor, header, builder);
    read_faces(cursor, header, builder);
    if (cursor.next_line()) {
        cursor.fail("more lines follow than the header's " + std::to_string(header.vertices) +
                    " vertices and " + std::to_string(header.faces) + " faces; correct its counts");
    }
    return std::move(builder).finish();
}

}  // namespace tightflip::geometry
