#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

TEST(RandomStream, GivesThePublishedSequenceOfSplitMix64) {
    RandomStream random(1234567);
    const std::array<std::uint64_t, 5> published{6457827717110365317ULL, 3203168211198807973ULL,
                                                 9817491932198370423ULL, 4593380528125082431ULL,
                                                 16408922859458223821ULL};
    for (const std::uint64_t value : published)
        EXPECT_EQ(random.bits(), value);
}

static_assert(RandomStream(1234567).bits() == 6457827717110365317ULL);

TEST(RandomStream, ContinuesACopyFromTheSamePlaceOnItsOwn) {
    RandomStream original(7);
    original.bits();
    RandomStream copy = original;
    const std::uint64_t next = copy.bits();
    copy.bits();
    EXPECT_EQ(original.bits(), next);
}

TEST(RandomStream, TakesTheChoiceFromTheHighHalfOfAProduct) {
    // Worked by hand from the published words: the high 32 bits, times the bound, shifted by 32.
    // 6457827717110365317 = 0x599ed017'fb08fc85, and 0x599ed017 * 10 / 2^32 = 3.500...
    RandomStream random(1234567);
    EXPECT_EQ(random.below(10), 3U);
    // 3203168211198807973 = 0x2c73f084'58540fa5, and 0x2c73f084 * 1000 / 2^32 = 173.64...
    EXPECT_EQ(random.below(1000), 173U);
}

TEST(RandomStream, StaysBelowEveryBound) {
    RandomStream random(42);
    for (const std::uint32_t bound :
         {1U, 2U, 3U, 7U, 1000U, 0x80000000U, 0x80000001U, 0xc0000000U, 0xffffffffU}) {
        for (int i = 0; i < 2000; ++i)
            ASSERT_LT(random.below(bound), bound);
    }
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(random.below(1), 0U);
}

TEST(RandomStream, IsNotBiasedTowardsAnyValue) {
    RandomStream random(2024);
    for (const std::uint32_t bound : {2U, 3U, 6U, 10U, 100U}) {
        const double expected = 2000.0;
        std::vector<int> count(bound, 0);
        for (int i = 0; i < static_cast<int>(expected) * static_cast<int>(bound); ++i) {
            ++count[random.below(bound)];
        }
        double chi_square = 0.0;
        for (const int c : count)
            chi_square += (c - expected) * (c - expected) / expected;
        // Mean bound - 1, variance twice that: five standard deviations and a little for skewness.
        const double freedom = bound - 1.0;
        EXPECT_LT(chi_square, freedom + 5.0 * std::sqrt(2.0 * freedom) + 10.0) << bound;
    }
}

TEST(RandomStream, RejectsTheWordsThatWouldBiasALargeBound) {
    // Without rejection a bound of 3/4 of the range makes every third value twice as likely.
    RandomStream random(99);
    constexpr std::uint32_t bound = 0xc0000000U;
    std::array<int, 3> count{};
    constexpr int draws = 30000;
    for (int i = 0; i < draws; ++i)
        ++count[random.below(bound) % 3];
    for (const int c : count)
        EXPECT_NEAR(c, draws / 3, 500);
}

TEST(RandomStream, ShufflesIntoAPermutation) {
    RandomStream random(5);
    for (const std::size_t size : {0UL, 1UL, 2UL, 17UL, 1000UL}) {
        std::vector<int> items(size);
        std::iota(items.begin(), items.end(), 0);
        const std::vector<int> before = items;
        random.shuffle(std::span(items));
        EXPECT_THAT(items, ::testing::UnorderedElementsAreArray(before));
        if (size > 10) {
            EXPECT_NE(items, before);
        }
    }
}

TEST(RandomStream, ShufflesIntoEveryOrderEquallyOften) {
    RandomStream random(11);
    std::map<std::array<int, 4>, int> count;
    constexpr int draws = 24000;
    for (int i = 0; i < draws; ++i) {
        std::array<int, 4> items{0, 1, 2, 3};
        random.shuffle(std::span<int>(items));
        ++count[items];
    }
    ASSERT_EQ(count.size(), 24U);
    for (const auto& [order, times] : count)
        EXPECT_NEAR(times, draws / 24, 200);
}

TEST(Mix, IsInjectiveAndSpreadsEveryBit) {
    std::set<std::uint64_t> images;
    for (std::uint64_t i = 0; i < 10000; ++i)
        images.insert(mix(i));
    EXPECT_EQ(images.size(), 10000U);
    for (int bit = 0; bit < 64; ++bit) {
        int changed = 0;
        for (std::uint64_t i = 1; i <= 64; ++i) {
            const std::uint64_t word = i * 0x9e3779b97f4a7c15ULL;
            changed += __builtin_popcountll(mix(word) ^ mix(word ^ (1ULL << bit)));
        }
        EXPECT_NEAR(changed / 64.0, 32.0, 6.0) << bit;
    }
}

}  // namespace
}  // namespace tightflip::kernel
