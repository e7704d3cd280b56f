#include "reading.hpp"
#include "samples.hpp"

namespace tightflip::geometry {
namespace {

TriangleSoup read(std::string_view text, MeshFileOptions options = {}) {
    return read_mesh(text, "mesh.off", options);
}

const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

TEST(Off, ReadsFacesAndTheLinesTheyStoodOn) {
    const TriangleSoup soup = read(samples::off());
    expect_tetrahedron(soup);
    EXPECT_EQ(soup.unit, FileError::Unit::line);
    EXPECT_EQ(soup.point_positions, (Positions{3, 4, 5, 6}));
    EXPECT_EQ(soup.triangle_positions, (Positions{7, 8, 9, 10}));
}

TEST(Off, ReadsEveryFormOfTheHeader) {
    for (const std::string header :
         {"OFF\n4 4 6\n", "OFF\n4 4\n", "OFF 4 4 6\n", "OFF4 4 0\n", "4 4 0\n",
          "OFF # c\n#c\n\n4 4 0 # c\n", "# c\nOFF\n4 4 6\n", "OFF\r\n4 4 6\r\n"}) {
        SCOPED_TRACE(header);
        expect_tetrahedron(read(header + points + faces));
    }
}

TEST(Off, PassesOverExtraNumbersThatTheKeywordAnnounces) {
    for (const std::string keyword : {"COFF", "NOFF", "STOFF", "CNOFF", "STCNOFF"}) {
        SCOPED_TRACE(keyword);
        expect_tetrahedron(
            read(keyword + "\n4 4 6\n0 0 0 1 0 0\n1 0 0 .5 .5 .5 1\n0 1 0 1 2\n0 0 1\n" + faces));
    }
}

TEST(Off, PassesOverFaceColours) {
    expect_tetrahedron(read("OFF 4 4 6\n" + points +
                            "3 0 2 1 255 0 0\n3 0 1 3 .1 .2 .3 1\n3 1 2 3 7\n3 2 0 3 # c"));
}

TEST(Off, CutsPolygonsIntoFansWhenAsked) {
    const std::string text = "OFF\n4 1 0\n" + points + "4 3 2 1 0 9 9 9\n";
    EXPECT_EQ(read(text, {.triangulate_polygons = true}).triangles,
              (Triangles{{3, 2, 1}, {3, 1, 0}}));
    expect_refused({at_line(7, text, "4 corners")}, "mesh.off", {});
}

TEST(Off, RefusesBadFilesWithTheLineAndTheReason) {
    const std::string head = "OFF\n4 4 6\n";
    expect_refused(
        {
            as_a_whole("OFF\n4 0 0\n" + points, "no faces"),
            at_line(1, "OFF", "the file ends where the numbers"),
            at_line(1, "OFF\n", "the file ends where the numbers"),
            at_line(2, "OFF\n4\n" + points, "the number of faces"),
            at_line(2, "OFF\nfour 4 0\n" + points, "'four'"),
            at_line(2, "OFF\n4 4 6 1\n" + points, "goes on with '1'"),
            at_line(2, "OFF\n-4 4 6\n" + points, "negative: -4"),
            at_line(2, "OFF\n4 -1 6\n" + points, "negative"),
            at_line(2, "OFF\n4000000000 1 0\n" + points + faces, "4000000000 vertices"),
            at_line(2, "OFF\n4 4000000000 0\n" + points + faces, "4000000000 faces"),
            at_line(2, "OFF\n9223372036854775807 9223372036854775807 0\n", "do not fit"),
            at_line(2, "OFF\n4 99999999999999999999 0\n", "'99999999999999999999'"),
            at_line(6, "OFF\n5 0 0\n0 0 0  \n1 0 0  \n0 1 0\n0 0 1   \n",
                    "before vertex 4 of the 5"),
            at_line(9, head + points + "3 0 2 1\n3 0 1 3\n3 1 2 3  \n", "before face 3 of the 4"),
            at_line(10, head + points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0", "a corner"),
            at_line(11, head + points + faces + "3 0 1 2\n", "more lines follow"),
            at_line(7, head + points + "3 0 2 4\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
                    "vertex 4 does not exist: the file has 4 vertices, numbered from 0"),
            at_line(7, head + points + "3 0 2 -1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "vertex -1"),
            at_line(8, head + points + "3 0 2 1\n3 0 1 b\n", "'b'"),
            at_line(8, head + points + "3 0 2 1\n3 0 1 3z\n", "'3z'"),
            at_line(8, head + points + "3 0 2 1\n2 0 1  \n   ", "2 corners"),
            at_line(8, head + points + "3 0 2 1\n0 0 1  \n   ", "0 corners"),
            at_line(8, head + points + "3 0 2 1\n-3 0 1  \n   ", "negative: -3"),
            at_line(8, head + points + "3 0 2 1\n4000000000 0 1 2\n", "a corner"),
            at_line(8, head + points + "3 0 2 1\n3 0 2 1 1 1 1 1 1\n", "goes on with '1'"),
            at_line(3, head + "0 0 zero\n" + points + faces, "the z coordinate"),
            at_line(3, head + "0 0\n" + points + faces, "the z coordinate"),
            at_line(3, head + "0 nan 0\n" + points + faces, "vertex 0 is not finite"),
            at_line(3, head + "0 0 0 1 1 1\n" + points + faces, "NOFF"),
            at_line(3, "COFF\n4 4 6\n0 0 0 red\n" + points + faces, "'red'"),
            at_line(1, "4OFF\n4 4 6\n", "4OFF"),
            at_line(1, "nOFF 4\n4 4 6\n", "nOFF"),
            at_line(1, "OFF BINARY\n\1\2\3", "binary"),
            at_line(1, "\x89PNG\r\n\x1a\n", "\\x89PNG"),
        },
        "mesh.off", {});
}

}  // namespace
}  // namespace tightflip::geometry
