#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random_flips.hpp>

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

bool is_simple(const Triangulation& surface) {
    return audit(surface).is_simple().value();
}

TEST(RandomFlips, AreDoneAsManyAsAskedForAndReturned) {
    for (const bool simple : {false, true}) {
        const Triangulation start = families::torus_grid(5, 4);
        Triangulation surface = start;
        const auto flips = flip_at_random(surface, {.count = 500, .seed = 3, .simple = simple});
        EXPECT_EQ(flips.size(), 500U);
        Triangulation replayed = start;
        for (const Edge e : flips)
            EXPECT_TRUE(replayed.flip(e));
        EXPECT_EQ(replayed, surface);
        EXPECT_EQ(is_simple(surface), simple);
        const std::set<Edge> different(flips.begin(), flips.end());
        EXPECT_EQ(different.size(), 60U);
    }
}

TEST(RandomFlips, OfASimpleGraphMakeNoParallelEdgeWhereAsked) {
    Triangulation surface = families::icosphere(1);
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
        for (int i = 0; i < 30; ++i) {
            flip_at_random(
                surface,
                {.count = 1, .seed = 30 * seed + static_cast<std::uint64_t>(i), .simple = true});
            ASSERT_TRUE(is_simple(surface));
        }
    }
}

TEST(RandomFlips, EveryEdgeIsAsLikely) {
    std::map<Edge, int> counts;
    for (std::uint64_t seed = 0; seed < 6000; ++seed) {
        Triangulation surface = families::octasphere(0);
        ++counts[flip_at_random(surface, {.count = 1, .seed = seed, .simple = true}).front()];
    }
    EXPECT_EQ(counts.size(), 12U);
    for (const auto& [edge, count] : counts)
        EXPECT_NEAR(count, 500, 110) << edge.id;  // five standard deviations
}

TEST(RandomFlips, OneSeedIsOneWalk) {
    const auto walk = [](std::uint64_t seed) {
        Triangulation surface = families::icosphere(1);
        return flip_at_random(surface, {.count = 20, .seed = seed});
    };
    EXPECT_EQ(walk(1), walk(1));
    EXPECT_NE(walk(1), walk(2));
}

// Two of the book's six edges can be flipped, so that all draws in a row miss now and then.
TEST(RandomFlips, GoOnWhereManyDrawsInARowMiss) {
    Triangulation book = families::book(4);
    EXPECT_EQ(flip_at_random(book, {.count = 1000, .seed = 1}).size(), 1000U);
}

TEST(RandomFlips, EndWhereThereIsNone) {
    Triangulation tetrahedron = families::tetrahedron();
    EXPECT_EQ(flip_at_random(tetrahedron, {.count = 5, .simple = true}).size(), 0U);
    EXPECT_EQ(flip_at_random(tetrahedron, {.count = 5}).size(), 5U);
    Triangulation two_faces = families::book(3);
    EXPECT_EQ(flip_at_random(two_faces, {.count = 5}).size(), 0U);
}

}  // namespace
}  // namespace tightflip::kernel
