#include "reading.hpp"
#include "samples.hpp"
#include <tightflip/geometry/point_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

const std::vector<Point> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(PointFile, ReadsThreeCoordinatesALine) {
    EXPECT_EQ(read_points("# x y z\n0 0 0\r\n1 0 0 # one\n\n0 +1 0\n0 0 1e0", "points.xyz"),
              corners);
}

TEST(PointFile, ReadsMeshesWithAndWithoutFaces) {
    EXPECT_EQ(read_points(samples::obj(), "mesh.obj"), corners);
    EXPECT_EQ(read_points("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", "points"), corners);
    EXPECT_EQ(read_points("OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "points"), corners);
    EXPECT_EQ(read_points("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\n", "mesh.obj"), corners);
}

TEST(PointFile, SaysWhereItIsDamaged) {
    const auto refused = [](const std::string& text, const std::string& name, std::uint64_t line,
                            const std::string& word) {
        try {
            (void)read_points(text, name);
            ADD_FAILURE() << text << " was read";
        } catch (const FileError& error) {
            EXPECT_EQ(error.position(), line) << error.what();
            EXPECT_THAT(error.what(), testing::HasSubstr(word));
        }
    };
    refused("0 0 0\n1 0\n", "points.xyz", 2, "z coordinate");
    refused("0 0 0\n1 0 0 0\n", "points.xyz", 2, "three coordinates");
    refused("0 0 0\n1 0 x\n", "points.xyz", 2, "z coordinate");
    refused("0 0 0\n1 0 inf\n", "points.xyz", 2, "finite");
    refused("v 0 0 0\nf 1 2 3\n", "mesh.obj", 2, "does not exist");
    refused("", "points.xyz", 0, "no points");
    refused("# nothing\n", "points.xyz", 0, "no points");
    refused("OFF\n0 0 0\n", "points.off", 0, "no points");
    refused("tightflip-triangulation 1\n", "a", 0, "no coordinates");
}

}  // namespace
}  // namespace tightflip::geometry
