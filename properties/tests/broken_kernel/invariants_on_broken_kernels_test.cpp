// The constant-time checks of one flip object to each way in which it can be wrong.

#include "broken_flips.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/invariants.hpp>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using broken::BrokenKernel;
using enum ViolationCode;

CheckedFlip flip_under(broken::Flip flip, Triangulation surface) {
    const BrokenKernel broken({.flip = flip});
    return checked_flip(surface, {0});
}

TEST(CheckedFlipOnABrokenKernel, ObjectsToARefusalWithoutReason) {
    const CheckedFlip step = flip_under(broken::always_refused, kernel::families::octasphere(0));
    EXPECT_FALSE(step.done);
    EXPECT_EQ(step.code, refusal_unjustified);
}

TEST(CheckedFlipOnABrokenKernel, ObjectsToAnotherFlipThanTheOneAskedFor) {
    for (const auto flip : {broken::turned_backwards, broken::nothing_done}) {
        const CheckedFlip step = flip_under(flip, kernel::families::octasphere(0));
        EXPECT_TRUE(step.done);
        EXPECT_EQ(step.code, flip_not_as_defined);
    }
}

// The corners are those of the definition, with c = d.
TEST(CheckedFlipOnABrokenKernel, LooksAtTheTwoFacesThemselves) {
    const CheckedFlip step = flip_under(broken::never_refused, kernel::families::book(3));
    EXPECT_TRUE(step.done);
    EXPECT_EQ(step.code, corners_not_distinct);
}

}  // namespace
}  // namespace tightflip::properties
