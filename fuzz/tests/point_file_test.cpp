#include "targets/point_file.hpp"

#include "mesh_samples.hpp"
#include "reading.hpp"
#include "targets.hpp"
#include <tightflip/geometry/point_file.hpp>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

TEST(PointFileSeeds, HaveBarePointsMeshesAndSurfaces) {
    int bare = 0;
    int meshes = 0;
    for (const Seed& seed : point_file_target.seeds()) {
        if (seed.bytes.size() < 2) continue;
        const std::string_view text = as_text(seed.bytes).substr(1);
        try {
            static_cast<void>(geometry::read_points(text, "points"));
            ++(seed.name.starts_with("bare") ? bare : meshes);
        } catch (const kernel::FileError&) {  // as it should be
        }
    }
    EXPECT_EQ(bare, 2);
    EXPECT_GE(meshes, 30);
}

TEST(PointFile, HoldsForFilesCutAnywhereUnderAnyName) {
    for (const MeshSample& sample : mesh_samples()) {
        const std::size_t step = 1 + sample.bytes.size() / 20;
        for (std::size_t size = 0; size < sample.bytes.size(); size += step) {
            for (const char* const name : {"points", "points.obj", "points.stl"})
                EXPECT_EQ(
                    point_file_objection(std::string_view(sample.bytes).substr(0, size), name), "");
        }
    }
}

}  // namespace
}  // namespace tightflip::fuzz
