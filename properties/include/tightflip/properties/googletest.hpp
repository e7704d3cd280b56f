/// \file
/// GoogleTest assertions on claims. Only includers of this header need GoogleTest.
///
/// \code
///     TEST(MyMesh, FlipsAsTheKernelDoes) {
///         EXPECT_HOLDS(my_claim, start, script) << "on a torus";
///     }
/// \endcode
#pragma once

#include <tightflip/properties/failing_case.hpp>

#include <gtest/gtest.h>

namespace tightflip::properties {

/// A name for the logs of the running test: "Suite.Test-1" for its first failure, and so on.
[[nodiscard]] inline std::string next_failure_name() {
    static int failures = 0;
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    const std::string name =
        test == nullptr ? "test" : std::string(test->test_suite_name()) + "." + test->name();
    return name + "-" + std::to_string(++failures);
}

/// Success where the claim holds; else the finding of the shortest script found that still fails,
/// that script in words, and where its log was written, or why it could not be.
template <class Start, ClaimOn<Start> Claim>
[[nodiscard]] ::testing::AssertionResult holds(std::string_view claim_text, const Claim& claim,
                                               const Start& start, FlipScript script) {
    const auto failing = failing_case(claim, start, std::move(script));
    if (!failing) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << claim_text << " does not hold "
                                         << written_and_in_words(next_failure_name(), *failing);
}

}  // namespace tightflip::properties

/// Fails where the claim does not hold of the script from the start, as `holds` says.
#define EXPECT_HOLDS(claim, start, script) \
    EXPECT_TRUE(::tightflip::properties::holds(#claim, claim, start, script))
/// The same, and leaves the test.
#define ASSERT_HOLDS(claim, start, script) \
    ASSERT_TRUE(::tightflip::properties::holds(#claim, claim, start, script))
