/// \file
/// Well-known models, where they are at hand: the counts of their collection and their topology.
#include "reading.hpp"
#include <tightflip/geometry/file_place.hpp>
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/build.hpp>

#include <filesystem>

namespace tightflip::geometry {
namespace {

std::filesystem::path model(const std::string& name) {
    return std::filesystem::path(TIGHTFLIP_MESHES) / name;
}

struct Expected {
    std::string name;
    std::size_t vertices;
    std::size_t faces;
    Index genus;
};

class ClosedModel : public testing::TestWithParam<Expected> {};

TEST_P(ClosedModel, IsTheSurfaceItIsKnownFor) {
    const auto& [name, vertices, faces, genus] = GetParam();
    if (!exists(model(name))) GTEST_SKIP() << model(name) << " is not here";
    const TriangleSoup soup = read_mesh_file(model(name));
    EXPECT_EQ(soup.points.size(), vertices);
    EXPECT_EQ(soup.triangles.size(), faces);
    const auto reading = kernel::glue_faces(soup.triangles, soup.vertex_count());
    EXPECT_TRUE(reading.violations.empty());
    const auto report = kernel::audit(reading.gluing);
    EXPECT_TRUE(report.is_valid());
    EXPECT_EQ(report.topology.genus, genus);
}

INSTANTIATE_TEST_SUITE_P(Models, ClosedModel,
                         testing::Values(Expected{"spot.obj", 2930, 5856, 0},
                                         Expected{"fandisk.obj", 6475, 12946, 0},
                                         Expected{"rocker-arm.obj", 10044, 20088, 1}),
                         [](const auto& test) {
                             return test.param.name.substr(0, test.param.name.find_first_of(".-"));
                         });

TEST(Models, CowIsPinchedAtAVertex) {
    if (!exists(model("cow.obj"))) GTEST_SKIP() << model("cow.obj") << " is not here";
    const TriangleSoup soup = read_mesh_file(model("cow.obj"));
    EXPECT_EQ(soup.points.size(), 2903U);
    EXPECT_EQ(soup.triangles.size(), 5804U);
    const auto reading = kernel::glue_faces(soup.triangles, soup.vertex_count());
    const auto report = kernel::audit(reading.gluing);
    EXPECT_TRUE(report.has(kernel::ViolationCode::vertex_with_several_fans));
    EXPECT_EQ(report.topology.euler_characteristic, 1);
    for (const auto& violation : report.violations) {
        EXPECT_TRUE(file_position(soup, violation)) << where(soup, violation);
    }
}

TEST(Models, SuzanneIsRefusedForItsQuadsUnlessTheyAreCut) {
    const auto path = model("suzanne.obj");
    if (!exists(path)) GTEST_SKIP() << path << " is not here";
    try {
        (void)read_mesh_file(path);
        ADD_FAILURE() << "was read";
    } catch (const FileError& error) {
        EXPECT_EQ(error.unit(), FileError::Unit::line);
        EXPECT_GT(error.position(), 507U);  // the vertices come first
        EXPECT_THAT(error.what(), testing::HasSubstr("suzanne.obj:"));
        EXPECT_THAT(error.reason(), testing::HasSubstr("triangulate_polygons"));
    }
    const TriangleSoup soup = read_mesh_file(path, {.triangulate_polygons = true});
    EXPECT_EQ(soup.points.size(), 507U);
    EXPECT_GT(soup.triangles.size(), 500U);
    EXPECT_LE(soup.triangles.size(), 1000U);
}

}  // namespace
}  // namespace tightflip::geometry
