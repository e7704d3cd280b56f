#include "mesh_samples.hpp"

#include <tightflip/geometry/mesh_file.hpp>

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

TEST(MeshSamples, AreReadAndRefusedInEveryFormat) {
    struct Counts {
        int read = 0;
        int refused = 0;
    };
    std::map<std::string, Counts> counts;
    std::set<std::string> reasons;
    for (const auto& [name, format, bytes] : mesh_samples()) {
        try {
            static_cast<void>(geometry::read_mesh(bytes, "mesh." + format));
            ++counts[format].read;
        } catch (const kernel::FileError& error) {
            ++counts[format].refused;
            reasons.insert(error.reason());
        }
    }
    EXPECT_EQ(counts.size(), 4U);
    for (const auto& [format, of_format] : counts) {
        EXPECT_GE(of_format.read, 3) << format;
        EXPECT_GE(of_format.refused, 5) << format;
    }
    EXPECT_GE(reasons.size(), 35U);
}

}  // namespace
}  // namespace tightflip::fuzz
