#include <tightflip/kernel/counting.hpp>

#include <array>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

TEST(Counting, RootedSpheresAreTheTermsOfTheEncyclopedia) {
    // OEIS A000309 from its second term on.
    const std::array<std::uint64_t, 9> terms{1, 4, 24, 176, 1456, 13056, 124032, 1230592, 12629760};
    for (std::size_t i = 0; i < terms.size(); ++i) {
        EXPECT_EQ(rooted_spheres(static_cast<Index>(i) + 3), terms[i]);
    }
}

TEST(Counting, RootedSimpleSpheresAreTheTermsOfTheEncyclopedia) {
    // OEIS A000256 from n = 0 on.
    const std::array<std::uint64_t, 8> terms{1, 1, 3, 13, 68, 399, 2530, 16965};
    for (std::size_t i = 0; i < terms.size(); ++i) {
        EXPECT_EQ(rooted_simple_spheres(static_cast<Index>(i) + 3), terms[i]);
    }
}

TEST(Counting, LabelsMultiplyByTheirPermutations) {
    const std::array<std::uint64_t, 6> labelled{8, 160, 5280, 244608, 14622720, 1071636480};
    for (std::size_t i = 0; i < labelled.size(); ++i) {
        const Index vertices = static_cast<Index>(i) + 4;
        EXPECT_EQ(
            labelled_from_rooted(rooted_spheres(vertices).value(), vertices, 6 * (vertices - 2)),
            labelled[i]);
    }
}

TEST(Counting, WhatDoesNotFitIsLeftOut) {
    EXPECT_EQ(factorial(20), 2432902008176640000U);
    EXPECT_EQ(factorial(21), std::nullopt);
    EXPECT_TRUE(rooted_spheres(20).has_value());
    EXPECT_EQ(rooted_spheres(40), std::nullopt);
    EXPECT_EQ(rooted_simple_spheres(40), std::nullopt);
    EXPECT_EQ(labelled_from_rooted(1'000'000, 20, 108), std::nullopt);
}

TEST(Counting, SmallFactorials) {
    EXPECT_EQ(factorial(0), 1U);
    EXPECT_EQ(factorial(1), 1U);
    EXPECT_EQ(factorial(5), 120U);
}

}  // namespace
}  // namespace tightflip::kernel
