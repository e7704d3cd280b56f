#include "reading.hpp"
#include "samples.hpp"

#include <limits>

namespace tightflip::geometry {
namespace {

using samples::packed;

TriangleSoup read(std::string_view text, MeshFileOptions options = {}) {
    return read_mesh(text, "mesh.ply", options);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Ply, ReadsTextAndTheLinesItStoodOn) {
    const TriangleSoup soup = read(samples::ply_ascii());
    expect_tetrahedron(soup);
    EXPECT_EQ(soup.unit, FileError::Unit::line);
    EXPECT_EQ(soup.point_positions, (Positions{11, 12, 13, 14}));
    EXPECT_EQ(soup.triangle_positions, (Positions{15, 16, 17, 18}));
}

TEST(Ply, ReadsBothByteOrdersAndTheBytesTheyStoodAt) {
    for (const auto order : {std::endian::little, std::endian::big}) {
        const std::string bytes = samples::ply_binary(order);
        const TriangleSoup soup = read(bytes);
        expect_tetrahedron(soup);
        EXPECT_EQ(soup.unit, FileError::Unit::byte);
        const std::uint64_t end = bytes.size();
        EXPECT_EQ(soup.triangle_positions, (Positions{end - 52, end - 39, end - 26, end - 13}));
        EXPECT_EQ(soup.point_positions[3], end - 52 - 12);
    }
}

TEST(Ply, ReadsCarriageReturns) {
    std::string text;
    for (const char c : samples::ply_ascii())
        text += c == '\n' ? "\r\n" : std::string(1, c);
    expect_tetrahedron(read(text));
}

TEST(Ply, ReadsAHeaderWithCarriageReturnsBeforeBytes) {
    const std::string bytes = samples::ply_binary(std::endian::little);
    const std::size_t data = bytes.find("end_header\n") + 11;
    std::string header;
    for (const char c : bytes.substr(0, data))
        header += c == '\n' ? "\r\n" : std::string(1, c);
    expect_tetrahedron(read(header + bytes.substr(data)));
}

TEST(Ply, ReadsTheOtherNameOfTheCornerList) {
    expect_tetrahedron(read(replaced(samples::ply_ascii(), "vertex_indices", "vertex_index")));
}

/// Faces before vertices, every scalar type, lists to skip, an element nobody knows.
std::string intricate_header(std::string_view encoding) {
    return "ply\ncomment x\nformat " + std::string(encoding) +
           " 1.0\nobj_info y\nelement face 1\nproperty uchar flags\nproperty list ushort double "
           "texcoord\nproperty list int8 ushort vertex_index\nproperty float64 quality\n"
           "element oddity 2\nproperty list uint32 int16 things\nproperty short s\n"
           "element vertex 3\nproperty int8 z\nproperty list uchar uint l\nproperty double "
           "x\nproperty uint16 nx\nproperty int32 y\nproperty uint u\nelement edge "
           "0\nproperty int vertex1\nelement nothing 0\nend_header\n";
}

void expect_intricate(const TriangleSoup& soup) {
    EXPECT_EQ(soup.triangles, (Triangles{{2, 0, 1}}));
    EXPECT_EQ(soup.points,
              (std::vector<Eigen::Vector3d>{{0.5, -70000, -1}, {1e300, 2, 100}, {-3.25, 0, 0}}));
}

TEST(Ply, ReadsTextWithPropertiesInAnyOrder) {
    expect_intricate(read(intricate_header("ascii") + "7 2 .5 .25 3 2 0 1 1e9\n"
                                                      "3 -1 -2 -3 5\n"
                                                      "0 -6\n"
                                                      "-1 0 0.5 9 -70000 1\n"
                                                      "100 2 8 9 1e300 9 2 1\n"
                                                      "0 1 5 -3.25 9 0 1\n\n"));
}

TEST(Ply, ReadsBytesOfEveryTypeInAnyOrder) {
    for (const auto order : {std::endian::little, std::endian::big}) {
        const auto p = [&](auto value) { return packed(value, order); };
        std::string bytes = intricate_header(order == std::endian::little ? "binary_little_endian"
                                                                          : "binary_big_endian");
        bytes += p(std::uint8_t{7}) + p(std::uint16_t{2}) + p(.5) + p(.25);
        bytes += p(std::int8_t{3}) + p(std::uint16_t{2}) + p(std::uint16_t{0}) +
                 p(std::uint16_t{1}) + p(1e9);
        bytes += p(std::uint32_t{3}) + p(std::int16_t{-1}) + p(std::int16_t{-2}) +
                 p(std::int16_t{-3}) + p(std::int16_t{5});
        bytes += p(std::uint32_t{0}) + p(std::int16_t{-6});
        const auto vertex = [&](std::int8_t z, std::uint8_t list, double x, std::int32_t y) {
            bytes += p(z) + p(list);
            for (int i = 0; i < list; ++i)
                bytes += p(std::uint32_t{4000000000});
            bytes += p(x) + p(std::uint16_t{65535}) + p(y) + p(std::uint32_t{1});
        };
        vertex(-1, 0, 0.5, -70000);
        vertex(100, 2, 1e300, 2);
        vertex(0, 1, -3.25, 0);
        expect_intricate(read(bytes));
    }
}

TEST(Ply, CutsPolygonsIntoFansWhenAsked) {
    const std::string text = replaced(replaced(samples::ply_ascii(), "face 4", "face 1"),
                                      "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "4 3 2 1 0\n");
    EXPECT_EQ(read(text, {.triangulate_polygons = true}).triangles,
              (Triangles{{3, 2, 1}, {3, 1, 0}}));
    expect_refused({at_line(15, text, "4 corners")}, "mesh.ply", {});
}

TEST(Ply, RefusesBadHeadersWithTheLineAndTheReason) {
    const std::string good = samples::ply_ascii();
    const auto changed = [&](std::string_view from, std::string_view to) {
        return replaced(good, from, to);
    };
    expect_refused(
        {
            at_line(1, "plyx\n", "begins with a line 'ply'"),
            at_line(1, "\xde\xad\xbe\xef", "begins with a line 'ply'"),
            at_line(1, "ply", "up to end_header"),
            at_line(1, "ply x\n", "goes on with 'x'"),
            at_line(2, "ply\nformat ascii 1.0\n", "up to end_header"),
            at_line(2, changed("ascii", "ascii_art"), "'ascii_art'"),
            at_line(2, changed("1.0", "2.0"), "version '2.0'"),
            at_line(2, changed("ascii 1.0", "ascii"), "version"),
            at_line(3, changed("comment", "format ascii 1.0\ncomment"), "twice"),
            at_line(9, changed("format ascii 1.0\n", ""), "no line 'format'"),
            at_line(3, changed("comment", "remark"), "'remark'"),
            at_line(3, changed("comment of no weight", "property int q"), "before any element"),
            at_line(4, changed("vertex 4", "vertex"), "the number of rows"),
            at_line(4, changed("vertex 4", "vertex four"), "'four'"),
            at_line(4, changed("vertex 4", "vertex -4"), "negative"),
            at_line(4, changed("vertex 4", "vertex 4 4"), "goes on with '4'"),
            at_line(4, changed("vertex 4", "vertex 99999999999999999999"), "'9999999"),
            at_line(8, changed("face 4", "vertex 4"), "twice"),
            at_line(5, changed("float x", "quad x"), "'quad'"),
            at_line(5, changed("float x", "float"), "the name"),
            at_line(5, changed("float x", "list uchar float x"), "not a list"),
            at_line(6, changed("float y", "float x"), "twice"),
            at_line(9, changed("list uchar int", "list float int"), "must be an integer"),
            at_line(9, changed("list uchar int", "list uchar float"), "must be integers"),
            at_line(9, changed("list uchar int", "int"), "must be a list"),
            at_line(10, changed("end_header", "property list uchar int vertex_index\nend_header"),
                    "two names"),
            at_line(10, changed("float z", "float w"), "'z'"),
            at_line(10, changed("vertex_indices", "corners"), "'vertex_indices'"),
            at_line(10, changed("face", "tristrips"), "triangle strips"),
            at_line(10, changed("vertex 4", "vertex 4000000000"), "4000000000 rows of 'vertex'"),
            at_line(10, changed("vertex 4", "vertex 9223372036854775807"), "do not fit"),
            at_line(10, changed("face 4", "face 4000000000"), "4000000000 rows of 'face'"),
            at_line(11, changed("end_header", "element void 9\nend_header"), "no properties"),
            at_line(10,
                    replaced(samples::ply_binary(std::endian::big), "face 4", "face 4000000000"),
                    "do not fit"),
            at_line(10, samples::ply_header("binary_little_endian"), "cut short"),
        },
        "mesh.ply", {});
}

TEST(Ply, RefusesBadTextWithTheLineAndTheReason) {
    const std::string good = samples::ply_ascii();
    const auto changed = [&](std::string_view from, std::string_view to) {
        return replaced(good, from, to);
    };
    expect_refused(
        {
            at_line(12, changed("1 0 0\n", "1 0\n"), "a property"),
            at_line(12, changed("1 0 0\n", "1 0 0 0\n"), "goes on with '0'"),
            at_line(12, changed("1 0 0\n", "1 0 O\n"), "'O'"),
            at_line(12, changed("1 0 0\n", "1 inf 0\n"), "vertex 1 is not finite"),
            at_line(15, changed("3 0 2 1\n", "3 0 2\n"), "a corner"),
            at_line(15, changed("3 0 2 1\n", "3 0 2 1.0\n"), "'1.0'"),
            at_line(15, changed("3 0 2 1\n", "3 0 2 4\n"), "vertex 4 does not exist"),
            at_line(15, changed("3 0 2 1\n", "3 0 2 -1\n"), "vertex -1"),
            at_line(15, changed("3 0 2 1\n", "-3 0 2 1\n"), "negative"),
            at_line(15, changed("3 0 2 1\n", "2 0 2\n"), "2 corners"),
            at_line(15, changed("3 0 2 1\n", "4000000000 0 2 1\n"), "a corner"),
            at_line(17, changed("3 2 0 3\n", ""), "before row 3 of the 4 of 'face'"),
            at_line(19, good + "3 2 0 3\n", "more lines follow"),
        },
        "mesh.ply", {});
}

TEST(Ply, RefusesBadBytesWithTheirPlaceAndTheReason) {
    const std::string good = samples::ply_binary(std::endian::little);
    const std::uint64_t end = good.size();
    const auto changed = [&](std::size_t from_end, std::string_view bytes) {
        std::string text = good;
        return text.replace(end - from_end, bytes.size(), bytes);
    };
    const auto nan = packed(std::numeric_limits<float>::quiet_NaN());
    std::string negative_length = replaced(changed(52, "\xff"), "list uchar", "list char");
    const std::string cut = replaced(replaced(good.substr(0, end - 39), "face 4", "face 1"),
                                     "end_header", "property double quality\nend_header");
    expect_refused(
        {
            at_byte(end - 13, good.substr(0, end - 1), "3 entries does not fit in the 11 bytes"),
            at_byte(cut.size(), cut, "inside row 0 of the 1 of 'face'"),
            at_byte(cut.size(), cut + "half", "inside row 0 of the 1 of 'face'"),
            at_byte(end, good + "\n", "1 bytes follow"),
            at_byte(end - 13, changed(13, "\x02"), "2 corners"),
            at_byte(end - 13, changed(13, "\xff"), "255 entries"),
            at_byte(end - 52 - 1, negative_length, "negative length -1"),
            at_byte(end - 52, changed(51, packed(4)), "vertex 4 does not exist"),
            at_byte(end - 52, changed(51, packed(-1)), "vertex -1"),
            at_byte(end - 52 - 12, changed(52 + 4, nan), "vertex 3 is not finite"),
        },
        "mesh.ply", {});
}

TEST(Ply, RefusesCountsThatFitOneByOneButNotTogether) {
    const std::string header = replaced(samples::ply_header("ascii"), "face 4", "face 20");
    const auto lines = static_cast<std::uint64_t>(std::ranges::count(header, '\n'));
    const std::string text = header + "0 0 0\n0 0 1\n0 1 0\n1 0 0\n" + std::string(20, '0');
    expect_refused({at_line(lines, text, "20 rows of 'face', which do not fit in the 44 bytes")},
                   "mesh.ply", {});
}

TEST(Ply, RefusesAListLongerThanTheFileWithoutRoomForIt) {
    const std::string header =
        replaced(samples::ply_header("binary_little_endian"), "list uchar", "list uint");
    const std::string bytes =
        replaced(header, "face 4", "face 1") + std::string(48, '\0') + packed(0xffffffffU) + "abcd";
    expect_refused({at_byte(bytes.size() - 8, bytes, "4294967295 entries")}, "mesh.ply", {});
}

}  // namespace
}  // namespace tightflip::geometry
