#include "mesh_text.hpp"

#include <string>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

TEST(MeshText, LowersAsciiLettersAlone) {
    EXPECT_EQ(lowered("EndSolid_@[`{ 09AZaz"), "endsolid_@[`{ 09azaz");
    EXPECT_EQ(lowered("\xc4\xd6\x80\xff"), "\xc4\xd6\x80\xff");
    EXPECT_EQ(lowered(std::string("\0A", 2)), std::string("\0a", 2));
    EXPECT_EQ(lowered(""), "");
}

}  // namespace
}  // namespace tightflip::geometry
