#include <tightflip/kernel/label_words.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using Labels = std::vector<std::uint8_t>;

Labels identity(Index vertices) {
    Labels labels(static_cast<std::size_t>(vertices));
    std::iota(labels.begin(), labels.end(), std::uint8_t{0});
    return labels;
}

TEST(BitPermutation, TakesEachBitFromItsSource) {
    Labels source = identity(24);
    RandomStream random(1);
    random.shuffle(std::span(source));
    const BitPermutation permute(source);
    for (std::size_t b = 0; b < source.size(); ++b) {
        EXPECT_EQ(permute(LabelWord{1} << source[b]), LabelWord{1} << b);
    }
    EXPECT_EQ(permute(0b1011), permute(0b1000) | permute(0b0010) | permute(0b0001));
}

class LabelWordsTest : public ::testing::TestWithParam<Index> {};

TEST_P(LabelWordsTest, EveryLabellingHasABitOfItsOwnAndEveryBitALabelling) {
    const LabelWords words(GetParam());
    Labels labels = identity(GetParam());
    std::vector<LabelWord> met(words.size());
    do {
        const auto [word, bit] = words.place(labels);
        ASSERT_LT(word, words.size());
        ASSERT_EQ(bit & ~words.full(), 0U);
        ASSERT_EQ(met[word] & bit, 0U);
        met[word] |= bit;
    } while (std::ranges::next_permutation(labels).found);
    EXPECT_TRUE(std::ranges::all_of(met, [&](LabelWord w) { return w == words.full(); }));
}

TEST_P(LabelWordsTest, AMoveGoesWhereTheMovedLabelsStand) {
    const LabelWords words(GetParam());
    RandomStream random(7);
    for (int round = 0; round < 200; ++round) {
        Labels labels = identity(GetParam());
        Labels to = labels;
        random.shuffle(std::span(labels));
        random.shuffle(std::span(to));
        Labels moved(labels.size());
        for (std::size_t v = 0; v < to.size(); ++v)
            moved[to[v]] = labels[v];

        const auto before = words.place(labels);
        const auto after = words.place(moved);
        const std::size_t set = before.word / words.words_per_set();
        const auto move = words.move(set, to);
        EXPECT_EQ(move.set, after.word / words.words_per_set());
        EXPECT_EQ(move.word[before.word % words.words_per_set()],
                  after.word % words.words_per_set());
        EXPECT_EQ((*move.pull)(after.bit), before.bit);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LabelWordsTest, ::testing::Values(3, 4, 5, 6, 7, 8));

TEST(LabelWords, RefusesWhatNoMemoryHolds) {
    EXPECT_THROW(LabelWords(LabelWords::max_vertices + 1), std::invalid_argument);
}

}  // namespace
}  // namespace tightflip::kernel
