#include "allocation_watch.hpp"

#include <new>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

TEST(AllocationWatch, SeesTheLargestAllocationSinceItsStart) {
    const std::vector<char> before(1 << 22);
    const AllocationWatch watch;
    const std::vector<char> large(1 << 20);
    const std::vector<char> small(1 << 10);
    EXPECT_EQ(watch.largest(), std::size_t{1} << 20U);
    EXPECT_NE(before.data(), large.data());
    EXPECT_NE(large.data(), small.data());
}

TEST(AllocationWatch, SeesWhatMayFail) {
    const AllocationWatch watch;
    void* const memory = operator new(5000, std::nothrow);
    EXPECT_EQ(watch.largest(), 5000U);
    operator delete(memory, std::nothrow);
}

TEST(AllocationWatch, ObjectsToMoreThanBytesAreWorth) {
    const AllocationWatch watch;
    EXPECT_EQ(watch.objection(0), "");
    const std::string large(AllocationWatch::most_in_any_case + 1, 'x');
    EXPECT_THAT(watch.objection(0), ::testing::StartsWith("memory_is_worth_the_bytes: "));
    EXPECT_EQ(watch.objection(1), "");
    EXPECT_EQ(large.front(), 'x');
}

}  // namespace
}  // namespace tightflip::fuzz
