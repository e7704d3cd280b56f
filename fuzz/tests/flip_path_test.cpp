#include "targets/flip_path.hpp"

#include "targets.hpp"
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(FlipPath, IsSizeTwoStartsAndTheirFlips) {
    const PathCase ends = decode_path_case(
        InputBytes{1, 6, 0, 9, 0, 1, 7, 3, /* flips */ 0, 5, 0, 1, 255, 255, 2, 7});
    EXPECT_EQ(ends.from.vertex_count(), 10);
    EXPECT_EQ(ends.to.vertex_count(), 10);
    EXPECT_THAT(ends.words,
                StartsWith("V = 10; from: book, seed 9, labels 0, flips 5 (refused) 7 (refused);"));
    EXPECT_THAT(ends.words, HasSubstr("; to: random, seed 7, labels 3, flips 15"));  // mod 24
}

TEST(FlipPath, MissingBytesCountAsZero) {
    const PathCase ends = decode_path_case({});
    EXPECT_EQ(ends.from, ends.to);
    EXPECT_EQ(ends.from.vertex_count(), least_path_vertices);
    EXPECT_EQ(decode_path_case(InputBytes{1, 36}).to.vertex_count(), most_path_vertices);
    EXPECT_EQ(decode_path_case(InputBytes{1, 37}).to.vertex_count(), least_path_vertices);
}

TEST(FlipPath, HasAtMostSoManyFlips) {
    const PathCase longest = decode_path_case(InputBytes(path_layout.most_bytes(), 1));
    EXPECT_EQ(decode_path_case(InputBytes(path_layout.most_bytes() + 9, 1)).words, longest.words);
}

TEST(FlipPath, HoldsForEveryByteString) {
    kernel::RandomStream random(1);
    std::set<kernel::Index> sizes;
    for (int k = 0; k < 300; ++k) {
        InputBytes bytes(random.below(60));
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random.bits());
        const PathCase ends = decode_path_case(bytes);
        ASSERT_EQ(ends.from.vertex_count(), ends.to.vertex_count());
        ASSERT_EQ(ends.from.genus() + ends.to.genus(), 0);
        ASSERT_EQ(path_objection(ends), "") << ends.words;
        sizes.insert(ends.from.vertex_count());
    }
    EXPECT_EQ(*sizes.begin(), least_path_vertices);
    EXPECT_GT(sizes.size(), 25U);
}

TEST(FlipPath, ObjectsToEndsThatDoNotConnect) {
    PathCase ends = decode_path_case(InputBytes{1, 6});
    ends.to = decode_path_case(InputBytes{1, 7}).to;
    EXPECT_THAT(path_objection(ends), StartsWith("connect: "));
}

TEST(FlipPath, TheSeedsHaveEqualEndsBooksAndFewAndManyVertices) {
    std::set<kernel::Index> sizes;
    bool equal_ends = false;
    bool two_books = false;
    for (const Seed& seed : flip_path_target.seeds()) {
        const PathCase ends = decode_path_case(seed.bytes);
        sizes.insert(ends.from.vertex_count());
        equal_ends |= same_labelled_surface(ends.from, ends.to);
        two_books |= ends.words.find("from: book") != std::string::npos &&
                     ends.words.find("to: book") != std::string::npos &&
                     ends.from.vertex_count() > 20;
    }
    EXPECT_TRUE(equal_ends);
    EXPECT_TRUE(two_books);
    EXPECT_EQ(*sizes.begin(), least_path_vertices);
    EXPECT_EQ(*sizes.rbegin(), most_path_vertices);
}

}  // namespace
}  // namespace tightflip::fuzz
