#include "soup_builder.hpp"

#include "reading.hpp"

namespace tightflip::geometry {
namespace {

TEST(SoupBuilder, KeepsToTheLimitOnFaces) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 3 4\n";
    const MeshFileOptions at_limit{.triangulate_polygons = true, .max_faces = 4};
    const MeshFileOptions over_limit{.triangulate_polygons = true, .max_faces = 3};
    EXPECT_EQ(read_mesh(text, "a.obj", at_limit).triangles.size(), 4U);
    expect_refused({at_line(7, text, "more than 3 faces")}, "a.obj", over_limit);
}

TEST(SoupBuilder, KeepsToTheLimitOnVertices) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
    expect_refused({at_line(4, text, "more vertices than 1 faces have corners")}, "a.obj",
                   {.max_faces = 1});
    expect_refused({at_line(1, text, "more vertices than 0")}, "a.obj", {.max_faces = -5});
}

TEST(SoupBuilder, MakesNoRoomBeyondTheLimit) {
    const MeshFileOptions options{.max_faces = 10};
    SoupBuilder builder({"", "", options}, FileError::Unit::line, 0);
    builder.reserve(std::size_t{1} << 60, std::size_t{1} << 60);
    EXPECT_EQ(builder.point_count(), 0);
}

TEST(SoupBuilder, CallsVerticesByTheLabelsOfTheFormat) {
    const std::string obj = "v 0 0 0\nv 1 0 0\nf 1 2 3\n";
    const std::string off = "OFF\n2 1 0\n0 0 0\n1 0 0\n3 0 1 2\n";
    expect_refused({at_line(3, obj,
                            "vertex 3 does not exist: the file has 2 vertices, numbered "
                            "from 1")},
                   "a.obj", {});
    expect_refused({at_line(5, off,
                            "vertex 2 does not exist: the file has 2 vertices, numbered "
                            "from 0")},
                   "a.off", {});
}

}  // namespace
}  // namespace tightflip::geometry
