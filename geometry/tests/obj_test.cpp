#include "reading.hpp"
#include "samples.hpp"

namespace tightflip::geometry {
namespace {

TriangleSoup read(std::string_view text, MeshFileOptions options = {}) {
    return read_mesh(text, "mesh.obj", options);
}

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Obj, ReadsFacesAndTheLinesTheyStoodOn) {
    const TriangleSoup soup = read(samples::obj());
    expect_tetrahedron(soup);
    EXPECT_EQ(soup.unit, FileError::Unit::line);
    EXPECT_EQ(soup.point_positions, (Positions{2, 3, 4, 5}));
    EXPECT_EQ(soup.triangle_positions, (Positions{7, 8, 9, 10}));
    EXPECT_EQ(soup.source, "mesh.obj");
}

TEST(Obj, ReadsEveryFormOfACorner) {
    for (const std::string corners :
         {"1 2 3", "1/7 2/8 3/9", "1//7 2//8 3//9", "1/4/7 2/5/8 3/6/9", "-3 -2 -1", "-3/1 2//1 -1",
          "+1 +2 +3", "1/-1/-1 2/-1/-1 3/-1/-1"}) {
        EXPECT_EQ(read(three_points + "f " + corners).triangles, (Triangles{{0, 1, 2}})) << corners;
    }
}

TEST(Obj, CountsRelativeCornersFromWhereTheyStand) {
    const auto soup = read(three_points + "f -1 -2 -3\nv 0 0 1\nf -1 -2 -3\n");
    EXPECT_EQ(soup.triangles, (Triangles{{2, 1, 0}, {3, 2, 1}}));
}

TEST(Obj, AllowsFacesBeforeTheirVertices) {
    EXPECT_EQ(read("f 1 2 3\n" + three_points).triangles, (Triangles{{0, 1, 2}}));
}

TEST(Obj, PassesRepeatedCornersOnToTheJudge) {
    EXPECT_EQ(read(three_points + "f 1 2 2\n").triangles, (Triangles{{0, 1, 1}}));
}

TEST(Obj, JoinsContinuedLinesAndStillCountsThem) {
    for (const std::string end : {"\n", "\r\n"}) {
        const auto soup =
            read("v 0 0\\" + end + "0" + end + "v 1 0 0" + end + "v 0 1 0" + end + "vn 0 \\" + end +
                 " 0 1" + end + "f 1\\" + end + " 2 \\" + end + "3" + end + "f 3 2 1");
        EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 2}, {2, 1, 0}}));
        EXPECT_EQ(soup.triangle_positions, (Positions{7, 10}));
    }
}

TEST(Obj, ReadsCarriageReturnsCommentsAndStatementsOfNoWeight) {
    const auto soup = read(
        "mtllib a b.mtl\r\no x\r\n\tv 0 0 0 # first \\\r\nv 1 0 0 1.0\r\nv 0 1 0 .5 .5 .5\r\n"
        "v 0 0 1 1 .5 .5 .5\r\nvt 0 0\r\nvn 0 0 1\r\ns off\r\nusemtl m\r\ng a b\r\n#f 9 9 9\r\n"
        "f 1 2 3#last\r\nl 1 2\r\n");
    EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(soup.points.size(), 4U);
}

TEST(Obj, ReadsNumbersInEveryUsualForm) {
    const auto soup = read("v 1e-3 -.5 +2.\nv -1E+2 1e0 0.1\nv 0 1 0\nf 1 2 3");
    EXPECT_EQ(soup.points[0], Eigen::Vector3d(0.001, -0.5, 2));
    EXPECT_EQ(soup.points[1], Eigen::Vector3d(-100, 1, 0.1));
}

TEST(Obj, CutsPolygonsIntoFansWhenAsked) {
    const std::string text = three_points + "v 0 0 1\nv 1 1 1\nf 5 4 3 2 1\nf 1 2 3\n";
    const auto soup = read(text, {.triangulate_polygons = true});
    EXPECT_EQ(soup.triangles, (Triangles{{4, 3, 2}, {4, 2, 1}, {4, 1, 0}, {0, 1, 2}}));
    EXPECT_EQ(soup.triangle_positions, (Positions{6, 6, 6, 7}));
    expect_refused({at_line(6, text, "5 corners"), at_line(6, text, "triangulate_polygons")},
                   "mesh.obj", {});
}

TEST(Obj, RefusesBadFilesWithTheLineAndTheReason) {
    const std::string& p = three_points;
    expect_refused(
        {
            as_a_whole(p, "no faces"),
            as_a_whole("# nothing\n", "no faces"),
            at_line(4, p + "f 1 2 4\n", "vertex 4 does not exist: the file has 3"),
            at_line(4, p + "f 1 2 99999999999\n", "99999999999 does not exist"),
            at_line(4, p + "f 1 2 99999999999999999999999\n", "'99999999999999999999999'"),
            at_line(4, p + "f 1 2 9223372036854775807\n", "does not exist"),
            at_line(4, p + "f 1 2 -9223372036854775808\n", "3 vertices so far"),
            at_line(5, p + "f 1 2 3\nf 1 2 -4\n", "before the first of 3"),
            at_line(4, p + "f 0 1 2\n", "'0' is not of the form"),
            at_line(4, p + "f 1 2x 3\n", "'2x'"),
            at_line(4, p + "f 1 2.5 3\n", "'2.5'"),
            at_line(4, p + "f 1 2/ 3\n", "'2/'"),
            at_line(4, p + "f 1 2/1/ 3\n", "'2/1/'"),
            at_line(4, p + "f 1 2// 3\n", "'2//'"),
            at_line(4, p + "f 1 2/a 3\n", "'2/a'"),
            at_line(4, p + "f 1 2/1/0 3\n", "'2/1/0'"),
            at_line(4, p + "f 1 2/1/1/1 3\n", "'2/1/1/1'"),
            at_line(4, p + "f 1 /2 3\n", "'/2'"),
            at_line(4, p + "f\n", "0 corners"),
            at_line(4, p + "f 1\n", "1 corners"),
            at_line(4, p + "f 1 2\n", "2 corners"),
            at_line(2, "v 0 0 0\nv 1 zero 0\n", "the y coordinate"),
            at_line(2, "v 0 0 0\nv 1 zero 0\n", "'zero'"),
            at_line(2, "v 0 0 0\nv 1 0\n", "the z coordinate"),
            at_line(1, "v 1 0 0x\n", "'0x'"),
            at_line(1, "v 1 0 0x10\n", "'0x10'"),
            at_line(1, "v 1 0 1,5\n", "'1,5'"),
            at_line(1, "v 1 0 +-1\n", "'+-1'"),
            at_line(1, "v 1 0 0 1 1 1 1 1\n", "goes on with '1'"),
            at_line(1, "v 1 0 0 red\n", "'red'"),
            at_line(2, "v 0 0 0\nv nan 0 0\n", "vertex 2 is not finite"),
            at_line(2, "v 0 0 0\nv 0 inf 0\n", "not finite"),
            at_line(2, "v 0 0 0\nv 0 0 -INF\n", "not finite"),
            at_line(1, "v 0 0 1e999\n", "range of a double"),
            at_line(4, p + "surf 0 1 0 1 1 2 3\n", "'surf'"),
            at_line(4, p + "call other.obj\n", "'call'"),
            at_line(1,
                    "\x7f"
                    "ELF\x02\x01\x01\n",
                    "\\x7fELF\\x02"),
            at_line(1, std::string("\0\0\0\0\n", 5), "\\x00"),
            at_line(1, std::string(1000, '\xff'), "..."),
        },
        "mesh.obj", {.triangulate_polygons = true});
}

}  // namespace
}  // namespace tightflip::geometry
