#include "reading.hpp"
#include "samples.hpp"
#include <tightflip/geometry/repair.hpp>
#include <tightflip/geometry/soup_gluing.hpp>

#include <limits>

namespace tightflip::geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TriangleSoup read_obj(const std::string& text) {
    return read_mesh(std::string_view(text), "mesh.obj");
}

TriangleSoup glued() {
    return read_mesh(std::string_view(samples::ply_glued("ascii")), "mesh.ply");
}

/// A tetrahedron with points of its own for each face.
std::string loose_tetrahedron(const std::string& epsilon) {
    std::string text;
    std::string faces;
    int count = 0;
    const std::array<std::string, 4> points{"0 0 0", "1 0 " + epsilon, "0 1 0", "0 0 1"};
    for (const auto& face : tetrahedron_faces) {
        faces += "f";
        for (const Index v : face) {
            text += "v " + points[static_cast<std::size_t>(v)] + "\n";
            faces += " " + std::to_string(++count);
        }
        faces += "\n";
    }
    return text + faces;
}

TEST(Repair, DoesNothingUnlessAsked) {
    TriangleSoup soup = read_obj(samples::obj() + "v 9 9 9\nf 1 1 2\nf 1 2 4\n");
    const TriangleSoup before = soup;
    EXPECT_EQ(repair(soup, {}), RepairReport{});
    EXPECT_EQ(soup.triangles, before.triangles);
    EXPECT_EQ(soup.points, before.points);
    EXPECT_FALSE(RepairOptions{}.any());
    EXPECT_TRUE(all_repairs.any());
}

TEST(Repair, WeldingMakesLooseFacesASurface) {
    TriangleSoup soup = read_obj(loose_tetrahedron("0"));
    EXPECT_FALSE(audit(glue(soup)).is_valid());
    const RepairReport report = repair(soup, {.weld = 0.0});
    EXPECT_EQ(report, RepairReport{.points_welded = 8});
    EXPECT_TRUE(audit(glue(soup)).is_valid());
    EXPECT_THAT(in_words(report), ElementsAre("8 points made one with others"));
}

TEST(Repair, WeldingWithinADistance) {
    TriangleSoup soup = read_obj(loose_tetrahedron("0.001"));
    soup.points[1] += Eigen::Vector3d(0, 0.001, 0);
    soup.points[4] += Eigen::Vector3d(0, 0.002, 0);
    EXPECT_LT(repair(soup, {.weld = 0.0}).points_welded, 8);
    EXPECT_FALSE(audit(glue(soup)).is_valid());
    (void)repair(soup, {.weld = 0.01});
    EXPECT_EQ(soup.vertex_count(), 4);
    EXPECT_TRUE(audit(glue(soup)).is_valid());
}

TEST(Repair, DistancesThatAreNoneAreRefused) {
    for (const double distance : {-1.0, std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity()}) {
        TriangleSoup soup = read_obj(samples::obj());
        EXPECT_THROW(repair(soup, {.weld = distance}), std::invalid_argument) << distance;
    }
}

TEST(Repair, DropsFacesThatRepeatACornerOrAFace) {
    std::string text = samples::obj() + "f 2 4 1\nf 4 2 1\nf 3 3 3\n";
    text.insert(text.find("f 1 3 2"), "f 1 1 2\n");
    TriangleSoup soup = read_obj(text);
    EXPECT_TRUE(audit(glue(soup)).has(kernel::ViolationCode::corners_not_distinct));
    const Positions positions(soup.triangle_positions.begin() + 1,
                              soup.triangle_positions.begin() + 5);
    const RepairReport report = repair(soup, {.drop_faces = true});
    EXPECT_EQ(report, (RepairReport{.faces_repeating_corners = 2, .faces_repeating_faces = 2}));
    EXPECT_EQ(soup.triangles, tetrahedron_faces);
    EXPECT_EQ(soup.triangle_positions, positions);
    EXPECT_THAT(in_words(report), ElementsAre("2 faces dropped that repeat a corner",
                                              "2 faces dropped that repeat others"));
}

TEST(Repair, TheSmallestSphereKeepsBothFaces) {
    TriangleSoup soup = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n");
    EXPECT_EQ(repair(soup, all_repairs), RepairReport{});
    EXPECT_TRUE(audit(glue(soup)).is_valid());
}

TEST(Repair, RefusesToDropAllFaces) {
    TriangleSoup soup = read_obj(samples::obj());
    try {
        repair(soup, {.weld = 10.0, .drop_faces = true});
        FAIL() << "was repaired";
    } catch (const FileError& error) {
        EXPECT_EQ(error.source(), "mesh.obj");
        EXPECT_THAT(error.reason(), HasSubstr("smaller distance"));
    }
}

TEST(Repair, DropsUnusedVerticesAndKeepsTheOrderOfTheOthers) {
    TriangleSoup soup = read_obj("v 7 7 7\n" + samples::obj() + "v 8 8 8\n");
    for (auto& triangle : soup.triangles) {
        for (Index& corner : triangle)
            ++corner;
    }
    const RepairReport report = repair(soup, {.drop_unused = true});
    EXPECT_EQ(report, RepairReport{.vertices_unused = 2});
    expect_tetrahedron(soup);
    EXPECT_EQ(soup.point_positions, (Positions{3, 4, 5, 6}));
    EXPECT_THAT(in_words(report), ElementsAre("2 vertices dropped that no face has"));
}

TEST(Repair, FillsHolesAfterTheRest) {
    TriangleSoup soup = read_obj(loose_tetrahedron("0") + "v 5 5 5\nf 1 1 2\n");
    soup.triangles.erase(soup.triangles.begin());
    soup.triangle_positions.erase(soup.triangle_positions.begin());
    const RepairReport report = repair(soup, all_repairs);
    EXPECT_EQ(report.holes_filled, 1);
    EXPECT_EQ(report.faces_added, 3);
    EXPECT_EQ(report.vertices_unused, 1);
    EXPECT_EQ(report.faces_repeating_corners, 1);
    EXPECT_TRUE(audit(glue(soup)).is_valid());
    EXPECT_EQ(soup.points.size(), soup.point_positions.size());
    EXPECT_EQ(soup.triangles.size(), soup.triangle_positions.size());
}

TEST(Repair, KeepsAGluingThatStillFitsAndDropsOneThatDoesNot) {
    TriangleSoup kept = glued();
    kept.points.insert(kept.points.begin(), {9, 9, 9});
    kept.point_positions.insert(kept.point_positions.begin(), 0);
    for (auto& triangle : kept.triangles) {
        for (Index& corner : triangle)
            ++corner;
    }
    EXPECT_EQ(repair(kept, all_repairs), RepairReport{.vertices_unused = 1});
    EXPECT_EQ(kept.glued_sides, glued().glued_sides);

    TriangleSoup dropped = glued();
    dropped.triangles.push_back({0, 0, 1});
    dropped.glued_sides.push_back({-1, -1, -1});
    dropped.triangle_positions.push_back(0);
    const RepairReport report = repair(dropped, {.drop_faces = true});
    EXPECT_EQ(report, (RepairReport{.faces_repeating_corners = 1, .gluing_dropped = true}));
    EXPECT_TRUE(dropped.glued_sides.empty());
    EXPECT_TRUE(audit(glue(dropped)).is_valid());
    EXPECT_THAT(in_words(report).back(), HasSubstr("gluing left out"));

    TriangleSoup welded = glued();
    welded.points[1] = welded.points[0];
    EXPECT_TRUE(repair(welded, {.weld = 0.0}).gluing_dropped);
}

TEST(Repair, SaysWhereThereWasNothingToDo) {
    TriangleSoup soup = read_obj(samples::obj());
    EXPECT_THAT(in_words(repair(soup, all_repairs)), ElementsAre("nothing to repair"));
    expect_tetrahedron(soup);
}

}  // namespace
}  // namespace tightflip::geometry
