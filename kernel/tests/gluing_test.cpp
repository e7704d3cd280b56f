#include "printing.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/gluing.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

constexpr Index largest = std::numeric_limits<Index>::max();
constexpr Index smallest = std::numeric_limits<Index>::min();

TEST(SideGluing, IsUngluedUnlessItNamesASide) {
    EXPECT_FALSE(SideGluing().is_glued());
    EXPECT_TRUE(SideGluing::coherent(0).is_glued());
    EXPECT_TRUE(SideGluing::reversed(0).is_glued());
    EXPECT_EQ(SideGluing(), SideGluing());
    EXPECT_NE(SideGluing(), SideGluing::coherent(0));
}

TEST(SideGluing, KeepsSideAndDirectionOfEverySideThatCanExist) {
    for (const Index side : {0, 1, 2, 3, 1000, 3 * max_faces - 1}) {
        EXPECT_TRUE(SideGluing::coherent(side).is_glued());
        EXPECT_EQ(SideGluing::coherent(side).side(), side);
        EXPECT_FALSE(SideGluing::coherent(side).is_reversed());
        EXPECT_TRUE(SideGluing::reversed(side).is_glued());
        EXPECT_EQ(SideGluing::reversed(side).side(), side);
        EXPECT_TRUE(SideGluing::reversed(side).is_reversed());
        EXPECT_NE(SideGluing::coherent(side), SideGluing::reversed(side));
        EXPECT_NE(SideGluing::coherent(side), SideGluing::coherent(side + 1));
    }
}

TEST(SideGluing, StaysGluedToNoSideWhereTheSideCannotExist) {
    for (const Index side :
         {largest, largest - 1, Index{1} << 30, smallest, smallest + 1, -2, -1}) {
        for (const bool reversed : {false, true}) {
            const SideGluing gluing =
                reversed ? SideGluing::reversed(side) : SideGluing::coherent(side);
            EXPECT_TRUE(gluing.is_glued()) << side;
            EXPECT_EQ(gluing.is_reversed(), reversed) << side;
            EXPECT_TRUE(gluing.side() < 0 || gluing.side() >= 3 * max_faces) << side;
            EXPECT_EQ(gluing.side() < 0, side < 0) << side;
        }
    }
}

TEST(Gluing, NumbersTheSidesFaceByFace) {
    Index expected = 0;
    for (Index face = 0; face < 5; ++face) {
        for (int i = 0; i < 3; ++i, ++expected) {
            EXPECT_EQ(side_of(face, i), expected);
            EXPECT_EQ(face_of_side(expected), face);
            EXPECT_EQ(corner_of_side(expected), i);
        }
    }
}

TEST(Gluing, StartsWithCornersThatNameNothingAndSidesUnglued) {
    const GluedFace face;
    for (const Index corner : face.corners)
        EXPECT_EQ(corner, -1);
    for (const SideGluing side : face.sides)
        EXPECT_FALSE(side.is_glued());
}

TEST(Gluing, IsEqualWhereEveryEntryIs) {
    const Gluing tetrahedron = testing::tetrahedron();
    EXPECT_EQ(tetrahedron, testing::tetrahedron());
    Gluing other = tetrahedron;
    other.vertex_count = 5;
    EXPECT_NE(other, tetrahedron);
    other = tetrahedron;
    testing::invert_bit(other, 7);
    EXPECT_NE(other, tetrahedron);
    other = tetrahedron;
    other.faces[3].corners[1] = 0;
    EXPECT_NE(other, tetrahedron);
}

}  // namespace
}  // namespace tightflip::kernel
