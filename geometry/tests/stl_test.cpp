#include "reading.hpp"
#include "samples.hpp"

#include <cctype>
#include <cmath>
#include <limits>

namespace tightflip::geometry {
namespace {

using samples::packed;

TriangleSoup read(std::string_view text, MeshFileOptions options = {}) {
    return read_mesh(text, "mesh.stl", options);
}

void expect_inside_out_tetrahedron(const TriangleSoup& soup) {
    EXPECT_EQ(soup.points,
              (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}));
}

TEST(Stl, ReadsTextAndTheLinesItStoodOn) {
    const TriangleSoup soup = read(samples::stl_ascii());
    expect_inside_out_tetrahedron(soup);
    EXPECT_EQ(soup.unit, FileError::Unit::line);
    EXPECT_EQ(soup.point_positions, (Positions{4, 5, 6, 12}));
    EXPECT_EQ(soup.triangle_positions, (Positions{2, 9, 16, 23}));
}

TEST(Stl, ReadsBytesAndTheirPlace) {
    const TriangleSoup soup = read(samples::stl_binary());
    expect_inside_out_tetrahedron(soup);
    EXPECT_EQ(soup.unit, FileError::Unit::byte);
    EXPECT_EQ(soup.point_positions, (Positions{96, 108, 120, 134 + 12 + 12}));
    EXPECT_EQ(soup.triangle_positions, (Positions{84, 134, 184, 234}));
}

TEST(Stl, KnowsABinaryFileThatBeginsLikeAnother) {
    for (const std::string_view begin :
         {"solid x\nfacet normal 0 0 0", "OFF\n4 4 6\n", "ply\n", "v 0 0 0\n"}) {
        SCOPED_TRACE(begin);
        expect_inside_out_tetrahedron(read(samples::stl_binary(begin)));
    }
}

TEST(Stl, ReadsAnyCaseIndentationAndLineEnd) {
    std::string text;
    for (const char c : samples::stl_ascii()) {
        text += c == '\n' ? "\r\n\t " : std::string(1, static_cast<char>(std::toupper(c)));
    }
    expect_inside_out_tetrahedron(read(text));
}

std::string facet(const std::string& loop, const std::string& normal = "0 0 1") {
    return "facet normal " + normal + "\nouter loop\n" + loop + "endloop\nendfacet\n";
}
std::string solid(const std::string& facets) {
    return "solid\n" + facets + "endsolid\n";
}
const std::string loop = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";

TEST(Stl, ReadsSeveralSolidsAsOneSoup) {
    const auto soup = read(solid(facet(loop)) + solid("") + "\n" + solid(facet(loop)));
    EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}}));
}

TEST(Stl, TakesNoNoticeOfNormals) {
    EXPECT_EQ(read(solid(facet(loop, "nan -nan inf"))).triangles.size(), 1U);
}

TEST(Stl, MergesEqualCoordinatesAndTheTwoZeros) {
    const auto soup = read(solid(facet("vertex -0 1 0\nvertex 0.0 1e0 -0.0\nvertex 0 1 1e-300\n")));
    EXPECT_EQ(soup.triangles, (Triangles{{0, 0, 1}}));
    EXPECT_FALSE(std::signbit(soup.points[0][0]));
}

TEST(Stl, CutsPolygonsIntoFansWhenAsked) {
    const std::string text = solid(facet(loop + "vertex 5 5 5\n"));
    EXPECT_EQ(read(text, {.triangulate_polygons = true}).triangles,
              (Triangles{{0, 1, 2}, {0, 2, 3}}));
    expect_refused({at_line(2, text, "4 corners")}, "mesh.stl", {});
}

TEST(Stl, RefusesBadTextWithTheLineAndTheReason) {
    expect_refused(
        {
            as_a_whole(solid(""), "no faces"),
            at_line(1, "solid", "'facet' or 'endsolid'"),
            at_line(10, solid(facet(loop)) + "solid x", "'facet' or 'endsolid'"),
            at_line(10, solid(facet(loop)) + "rest", "'solid' should stand here, not 'rest'"),
            at_line(2, "solid\nfacette\n", "'facette'"),
            at_line(2, solid(facet(loop, "0 0")), "the normal"),
            at_line(2, solid(facet(loop, "0 0 up")), "'up'"),
            at_line(2, solid(facet(loop, "0 0 1 1")), "goes on with '1'"),
            at_line(2, "solid\nfacet normal 0 0 1\n", "'outer loop' should follow"),
            at_line(3, "solid\nfacet normal 0 0 1\nouter\n", "'loop'"),
            at_line(3, "solid\nfacet normal 0 0 1\nouter loop\n", "a vertex or 'endloop'"),
            at_line(2, solid(facet("")), "0 corners"),
            at_line(2, solid(facet("vertex 0 0 0\nvertex 1 0 0\n")), "2 corners"),
            at_line(4, solid(facet("vertex 0 0\n")), "the z coordinate"),
            at_line(4, solid(facet("vertex 0 0 0,5\n")), "'0,5'"),
            at_line(4, solid(facet("vertex 0 0 0 0\n")), "goes on with '0'"),
            at_line(5, solid(facet("vertex 0 0 0\nvertex nan 0 0\n")), "not finite"),
            at_line(4, solid(facet("corner 0 0 0\n")), "'endloop' should stand here, not 'corner'"),
            at_line(8, "solid\nfacet normal 0 0 1\nouter loop\n" + loop + "endloop\nendfacette\n",
                    "'endfacet' should stand here"),
        },
        "mesh.stl", {});
}

TEST(Stl, RefusesBadBytesWithTheirPlaceAndTheReason) {
    const std::string good = samples::stl_binary();
    const auto changed = [&](std::size_t at, std::string_view bytes) {
        return std::string(good).replace(at, bytes.size(), bytes);
    };
    expect_refused(
        {
            at_byte(80, good.substr(0, good.size() - 1), "284 bytes, but the file has 283"),
            at_byte(80, good + "\n", "but the file has 285"),
            at_byte(80, changed(80, packed(4000000000U)), "4000000000 triangles"),
            at_byte(80, changed(80, packed(0xffffffffU)), "214748364834 bytes"),
            at_byte(83, good.substr(0, 83), "84 bytes"),
            at_byte(4, "\x01\x02\x03\x04", "84 bytes"),
            at_byte(108, changed(112, packed(std::numeric_limits<float>::infinity())),
                    "not finite"),
            at_byte(96, changed(96, packed(std::numeric_limits<float>::quiet_NaN())), "not finite"),
            as_a_whole(std::string(84, '\0'), "no faces"),
        },
        "mesh.stl", {});
}

}  // namespace
}  // namespace tightflip::geometry
