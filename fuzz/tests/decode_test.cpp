#include "decode.hpp"

#include "flip_script.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using properties::find_start_kind;
using properties::FlipCase;
using Bytes = std::vector<std::uint8_t>;

TEST(Decode, TakesKindSpareVerticesGenusSeedAndTwoBytesAnEdge) {
    const FlipCase flip_case = decode(Bytes{9, 2, 3, 200, 5, 0, 255, 255, 7});
    EXPECT_EQ(flip_case.kind, find_start_kind("genus"));
    EXPECT_EQ(flip_case.request.vertices, 5);
    EXPECT_EQ(flip_case.request.genus, 3);
    EXPECT_EQ(flip_case.request.seed, 200U);
    EXPECT_EQ(flip_case.picks, (std::vector<std::uint32_t>{5, 65535, 7}));
}

TEST(Decode, ReadsMissingBytesAsZero) {
    EXPECT_EQ(decode({}).log(), (kernel::FlipLog{kernel::families::tetrahedron(), {}}));
    EXPECT_EQ(decode(Bytes{1}).log().start, kernel::families::book(3));
    EXPECT_EQ(decode(Bytes{1, 2}).log().start, kernel::families::book(5));
}

TEST(Decode, TakesEveryByteModuloItsRange) {
    const FlipCase flip_case = decode(Bytes(6, 255));
    EXPECT_EQ(flip_case.kind, &properties::start_kinds()[255 % properties::start_kinds().size()]);
    const FlipCase torus = decode(Bytes{9, most_spare_vertices + 2, most_genus + 2});
    EXPECT_EQ(torus.request.vertices, 4);
    EXPECT_EQ(torus.request.genus, 1);
}

TEST(Decode, IgnoresWhatFollowsTheLastFlip) {
    EXPECT_EQ(decode(Bytes(10'000, 1)).picks.size(), most_flips);
}

TEST(Decode, GivesAValidCaseForEveryByteString) {
    kernel::RandomStream random(1);
    std::set<std::string_view> kinds;
    for (int k = 0; k < 400; ++k) {
        Bytes bytes(random.below(40));
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random.bits());
        const FlipCase flip_case = decode(bytes);
        kinds.insert(flip_case.kind->name);
        const kernel::FlipLog log = flip_case.log();
        ASSERT_TRUE(audit(log.start).is_valid());
        for (const kernel::Edge e : log.flips)
            ASSERT_TRUE(e.id >= 0 && e.id < log.start.edge_count());
        ASSERT_FALSE(first_broken_claim(log).has_value()) << describe(flip_case);
    }
    EXPECT_EQ(kinds.size(), properties::start_kinds().size());
}

}  // namespace
}  // namespace tightflip::fuzz
