#include "reading.hpp"
#include "samples.hpp"
#include <tightflip/geometry/file_place.hpp>
#include <tightflip/geometry/soup_gluing.hpp>

namespace tightflip::geometry {
namespace {

using kernel::ViolationCode;

/// The sphere of two faces with its gluing; the faces stand on lines 13 and 14.
std::string two_faces(const std::string& first = "3 5 4 3", const std::string& second = "3 2 1 0",
                      const std::string& type = "list uchar int") {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
           "property double z\nelement face 2\nproperty " +
           type +
           " glued_sides\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0\n1 0 0\n0 1 0\n" +
           first + " 3 0 1 2\n" + second + " 3 0 2 1\n";
}

TriangleSoup read(const std::string& text) {
    return read_mesh(std::string_view(text), "mesh.ply");
}

TEST(SoupGluing, IsWhatTheFileSays) {
    const TriangleSoup soup = read(two_faces());
    EXPECT_EQ(soup.glued_sides, (Triangles{{5, 4, 3}, {2, 1, 0}}));
    const kernel::FaceListReading reading = glue(soup);
    EXPECT_TRUE(audit(reading).is_valid());
    EXPECT_TRUE(reading.gluing.faces[0].sides[0] == kernel::SideGluing::coherent(5));
}

TEST(SoupGluing, IsThatOfTheCornersWhereTheFileSaysNothing) {
    const TriangleSoup soup = read_mesh(std::string_view(samples::obj()), "mesh.obj");
    EXPECT_TRUE(soup.glued_sides.empty());
    EXPECT_EQ(glue(soup).gluing, kernel::glue_faces(soup.triangles, soup.vertex_count()).gluing);
}

TEST(SoupGluing, TheSamplesSayWhatTheirCornersDo) {
    for (const std::string encoding : {"ascii", "binary_little_endian"}) {
        const TriangleSoup soup = read(samples::ply_glued(encoding));
        expect_tetrahedron(soup);
        EXPECT_EQ(glue(soup).gluing,
                  kernel::glue_faces(soup.triangles, soup.vertex_count()).gluing);
    }
}

TEST(SoupGluing, TellsReversedSidesByTheirLabels) {
    TriangleSoup soup = read(two_faces());
    soup.triangles[1] = {1, 2, 0};  // both faces in one direction
    soup.glued_sides = {{5, 3, 4}, {1, 2, 0}};
    const kernel::AuditReport report = audit(glue(soup));
    EXPECT_TRUE(report.is_valid());
    EXPECT_FALSE(report.coherently_stored);
}

TEST(SoupGluing, AListThatCannotBeIsRefusedWithItsPlace) {
    expect_refused(
        {
            at_line(14, two_faces("2 5 4"), "2 glued sides"),
            at_line(14, two_faces("4 5 4 3 3"), "4 glued sides"),
            at_line(14, two_faces("0"), "0 glued sides"),
            at_line(14, two_faces("3 6 4 3"), "glued to 6"),
            at_line(15, two_faces("3 5 4 3", "3 2 1 -2"), "glued to -2"),
            at_line(15, two_faces("3 5 4 3", "3 2 1 4000000000"), "glued to 4000000000"),
            at_line(14, two_faces("3 5 4 x"), "a glued side should be a whole number"),
            at_line(14, two_faces("4000000000 5 4 3"), "a glued side"),
            at_line(8, two_faces("3 5 4 3", "3 2 1 0", "list uchar double"), "must be integers"),
            at_line(8, two_faces("3 5 4 3", "3 2 1 0", "int"), "must be a list"),
            at_line(9,
                    two_faces("3 5 4 3", "3 2 1 0",
                              "list uchar int glued_sides\nproperty list uchar int"),
                    "twice"),
        },
        "mesh.ply", {});
}

TEST(SoupGluing, PolygonsCannotBeGlued) {
    std::string text = two_faces("3 5 4 3", "3 2 1 0");
    text.replace(text.rfind("3 0 2 1"), 7, "4 0 2 1 0");
    expect_refused({at_line(15, text, "only triangles can be glued")}, "mesh.ply",
                   {.triangulate_polygons = true});
}

TEST(SoupGluing, AListThatContradictsItselfIsForTheAudit) {
    struct Case {
        std::string text;
        ViolationCode code;
        std::uint64_t line;
    };
    for (const auto& [text, code, line] :
         std::vector<Case>{{two_faces("3 -1 4 3"), ViolationCode::side_unglued, 14},
                           {two_faces("3 0 4 3"), ViolationCode::side_glued_to_itself, 14},
                           {two_faces("3 4 4 3"), ViolationCode::gluing_not_involution, 14},
                           {two_faces("3 4 5 3", "3 2 0 1"), ViolationCode::labels_disagree, 14}}) {
        SCOPED_TRACE(text);
        const TriangleSoup soup = read(text);
        const kernel::AuditReport report = audit(glue(soup));
        ASSERT_TRUE(report.has(code));
        const auto found = std::ranges::find(report.violations, code, &kernel::Violation::code);
        EXPECT_EQ(file_position(soup, *found), line);
    }
}

TEST(SoupGluing, TheAuditCountsWhatAFaceListLeavesOpen) {
    TriangleSoup soup = read_mesh(std::string_view(samples::obj()), "mesh.obj");
    soup.triangles.push_back(soup.triangles.front());
    const kernel::AuditReport report = audit(glue(soup));
    EXPECT_TRUE(report.has(ViolationCode::edge_in_more_than_two_faces));
    EXPECT_EQ(report.violations.front().code, ViolationCode::side_unglued);
    const kernel::FaceListReading reading = glue(soup);
    EXPECT_EQ(std::ssize(reading.violations), 3);
    EXPECT_EQ(report.violation_count, kernel::audit(reading.gluing).violation_count + 3);
}

}  // namespace
}  // namespace tightflip::geometry
