#include "reading.hpp"
#include "samples.hpp"
#include <tightflip/geometry/file_place.hpp>
#include <tightflip/kernel/build.hpp>

namespace tightflip::geometry {
namespace {

using kernel::PlaceKind;
using kernel::Violation;
using kernel::ViolationCode;

TEST(FilePlace, NamesTheLineOfFacesSidesAndVertices) {
    const TriangleSoup soup = read_mesh(samples::obj(), "mesh.obj");
    EXPECT_EQ(where(soup, {.kind = PlaceKind::face, .place = 1}), "mesh.obj:8: face 1");
    EXPECT_EQ(where(soup, {.kind = PlaceKind::side, .place = 10}), "mesh.obj:10: face 3, side 1");
    EXPECT_EQ(where(soup, {.kind = PlaceKind::vertex, .place = 2}), "mesh.obj:4: vertex 2");
}

TEST(FilePlace, NamesTheByteInBinaryFiles) {
    const TriangleSoup soup = read_mesh(samples::stl_binary(), "mesh.stl");
    EXPECT_EQ(where(soup, {.kind = PlaceKind::side, .place = 4}),
              "mesh.stl: byte 134: face 1, side 1");
}

TEST(FilePlace, NamesTheFileAloneWhereNoPlaceIsMeant) {
    const TriangleSoup soup = read_mesh(samples::obj(), "mesh.obj");
    for (const Violation& violation :
         {Violation{.kind = PlaceKind::surface}, Violation{.kind = PlaceKind::halfedge, .place = 1},
          Violation{.kind = PlaceKind::edge, .place = 1},
          Violation{.kind = PlaceKind::face, .place = 4},
          Violation{.kind = PlaceKind::face, .place = -1},
          Violation{.kind = PlaceKind::vertex, .place = 4}}) {
        EXPECT_EQ(file_position(soup, violation), std::nullopt);
        EXPECT_EQ(where(soup, violation), "mesh.obj: " + kernel::where(violation));
    }
}

TEST(FilePlace, LeadsFromTheJudgeToTheLine) {
    // The last face is gone: its three neighbours have a side without a neighbour.
    const TriangleSoup soup =
        read_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n\nf 2 3 4\n", "mesh.obj");
    const auto built = kernel::build(soup.triangles, soup.vertex_count());
    ASSERT_FALSE(built);
    std::vector<std::string> places;
    for (const Violation& v : built.report.violations) {
        if (v.code == ViolationCode::side_unglued) places.push_back(where(soup, v));
    }
    EXPECT_THAT(places,
                testing::ElementsAre("mesh.obj:5: face 0, side 0", "mesh.obj:6: face 1, side 2",
                                     "mesh.obj:8: face 2, side 1"));
}

}  // namespace
}  // namespace tightflip::geometry
