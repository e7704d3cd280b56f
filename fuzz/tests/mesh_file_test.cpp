#include "targets/mesh_file.hpp"

#include "mesh_samples.hpp"
#include "reading.hpp"
#include "targets.hpp"

#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using geometry::MeshFormat;

TEST(MeshFileInput, BeginsWithAByteForTheOptions) {
    EXPECT_FALSE(decode_mesh_options(0).format);
    EXPECT_EQ(decode_mesh_options(1).format, MeshFormat::obj);
    EXPECT_EQ(decode_mesh_options(4).format, MeshFormat::stl);
    EXPECT_FALSE(decode_mesh_options(4).triangulate_polygons);
    EXPECT_TRUE(decode_mesh_options(5).triangulate_polygons);
    EXPECT_TRUE(decode_mesh_options(9).faces_required);
    EXPECT_FALSE(decode_mesh_options(10).faces_required);
    for (std::uint8_t byte = 0; byte < 20; ++byte)
        EXPECT_EQ(encode_mesh_options(decode_mesh_options(byte)), byte);
    EXPECT_EQ(decode_mesh_options(20).format, decode_mesh_options(0).format);
}

TEST(MeshFileSeeds, AskForEveryFormatAndOption) {
    std::set<std::uint8_t> options;
    for (const Seed& seed : mesh_file_target.seeds()) {
        if (!seed.bytes.empty()) options.insert(seed.bytes.front());
    }
    for (const int byte : {0, 1, 2, 3, 4, 5, 10})
        EXPECT_TRUE(options.contains(static_cast<std::uint8_t>(byte))) << byte;
}

TEST(MeshFile, HoldsForFilesCutAnywhere) {
    for (const MeshSample& sample : mesh_samples()) {
        const std::size_t step = 1 + sample.bytes.size() / 40;
        for (std::size_t size = 0; size < sample.bytes.size(); size += step) {
            EXPECT_EQ(mesh_objection(std::string_view(sample.bytes).substr(0, size), {}), "")
                << sample.name << ", " << size << " bytes";
        }
    }
}

}  // namespace
}  // namespace tightflip::fuzz
