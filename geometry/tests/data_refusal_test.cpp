#include <tightflip/geometry/data_refusal.hpp>

#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

TEST(DataRefusal, EveryFaultHasWordsOfItsOwn) {
    std::set<std::string> seen;
    for (int fault = 1; fault <= static_cast<int>(DataFault::contour_not_simple); ++fault) {
        const std::string text = message({static_cast<DataFault>(fault), {31, 47}});
        EXPECT_GT(text.size(), 10U) << fault;
        EXPECT_EQ(text.find('{'), std::string::npos) << text;
        EXPECT_TRUE(seen.insert(text).second) << text;
    }
    EXPECT_EQ(message({}), "");
    EXPECT_EQ(message({DataFault::coincident_points, {3, 12}}), "points 3 and 12 coincide");
}

TEST(Outcome, HoldsAResultOrThrowsTheMessage) {
    const Outcome<int> good(7);
    EXPECT_TRUE(good);
    EXPECT_EQ(good.value(), 7);
    const Outcome<int> bad(DataRefusal{DataFault::collinear_points});
    EXPECT_FALSE(bad);
    try {
        (void)bad.value();
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(error.what(), message(bad.refusal()));
    }
}

}  // namespace
}  // namespace tightflip::geometry
