#include "face_list.hpp"

#include "shapes.hpp"
#include <tightflip/kernel/gluing.hpp>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

TEST(FaceList, TheCornersFollowTheFaces) {
    for (const Triangulation& surface : all_families()) {
        const auto corners = corners_of_faces(surface.table());
        const std::vector<Halfedge> faces = surface.faces();
        ASSERT_EQ(corners.size(), faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            EXPECT_EQ(corners[f][0], surface.origin(faces[f]).id);
            EXPECT_EQ(corners[f][1], surface.target(faces[f]).id);
            EXPECT_EQ(corners[f][2], surface.opposite(faces[f]).id);
        }
    }
}

TEST(FaceList, CornersAndGluedSidesMakeTheSurface) {
    for (const Triangulation& surface : all_families()) {
        const auto corners = corners_of_faces(surface.table());
        const auto glued = glued_sides_of_faces(surface.table());
        kernel::Gluing gluing{.vertex_count = surface.vertex_count(), .faces = {}};
        for (std::size_t f = 0; f < corners.size(); ++f) {
            kernel::GluedFace& face = gluing.faces.emplace_back();
            face.corners = corners[f];
            for (std::size_t i = 0; i < 3; ++i)
                face.sides[i] = kernel::SideGluing::coherent(glued[f][i]);
        }
        const auto built = kernel::build(gluing);
        ASSERT_TRUE(built);
        EXPECT_EQ(built.value().euler_characteristic(), surface.euler_characteristic());
    }
}

TEST(FaceList, ParallelEdgesAreFoundWhereTheAuditCountsThem) {
    for (const Triangulation& surface : all_families()) {
        const auto ends = parallel_edges(surface.table());
        EXPECT_EQ(ends.has_value(),
                  kernel::audit(surface).parallels.value().pairs_joined_twice > 0);
        if (!ends) continue;
        int joining = 0;
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            joining += surface.origin(Halfedge{h}) == ends->first &&
                       surface.target(Halfedge{h}) == ends->second;
        }
        EXPECT_GE(joining, 2);
    }
}

}  // namespace
}  // namespace tightflip::geometry
