#include "script_input.hpp"

#include "targets/flip_script.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using properties::find_start_kind;
using properties::FlipCase;

TEST(ScriptInput, IsVersionKindSpareVerticesGenusSeedAndTwoBytesAnEdge) {
    const FlipCase flip_case = decode_script(InputBytes{1, 9, 2, 3, 21, 5, 0, 255, 255, 7});
    EXPECT_EQ(flip_case.kind, find_start_kind("genus"));
    EXPECT_EQ(flip_case.request.vertices, 5);
    EXPECT_EQ(flip_case.request.genus, 3);
    EXPECT_EQ(flip_case.request.seed, 21 % start_seeds);
    EXPECT_EQ(flip_case.picks, (std::vector<std::uint32_t>{5, 65535, 7}));
}

TEST(ScriptInput, MissingBytesCountAsZero) {
    const kernel::FlipLog tetrahedron{kernel::families::tetrahedron(), {}};
    EXPECT_EQ(decode_script({}).log(), tetrahedron);
    EXPECT_EQ(decode_script(InputBytes{1}).log(), tetrahedron);
    EXPECT_EQ(decode_script(InputBytes{1, 1}).log().start, kernel::families::book(3));
    EXPECT_EQ(decode_script(InputBytes{1, 1, 2}).log().start, kernel::families::book(5));
}

TEST(ScriptInput, EveryByteCountsModuloItsRange) {
    const auto kinds = properties::start_kinds();
    const FlipCase flip_case = decode_script(InputBytes(7, 255));
    EXPECT_EQ(flip_case.kind, &kinds[255 % kinds.size()]);
    const FlipCase torus = decode_script(InputBytes{1, 9, most_spare_vertices + 2, most_genus + 2});
    EXPECT_EQ(torus.request.vertices, 4);
    EXPECT_EQ(torus.request.genus, 1);
}

TEST(ScriptInput, WhatFollowsTheLastFlipIsIgnored) {
    EXPECT_EQ(decode_script(InputBytes(10'000, 1)).picks.size(), most_flips);
    EXPECT_EQ(decode_script(InputBytes(script_layout.most_bytes(), 1)).picks.size(), most_flips);
}

TEST(ScriptInput, IsReadAsItIsPutTogether) {
    const FlipCase flip_case = decode_script(script_input({"random", 7, 2, 9}, {3, 40000}));
    EXPECT_EQ(flip_case.kind, find_start_kind("random"));
    EXPECT_EQ(flip_case.request.vertices, 10);
    EXPECT_EQ(flip_case.request.genus, 2);
    EXPECT_EQ(flip_case.request.seed, 9U);
    EXPECT_EQ(flip_case.picks, (std::vector<std::uint32_t>{3, 40000}));
    EXPECT_THROW(static_cast<void>(script_input({"no such kind"})), std::invalid_argument);
}

TEST(ScriptInput, StartsAreKeptApart) {
    for (const StartBytes& start : {StartBytes{"random", 2, 1, 3},
                                    {"random", 2, 1, 4},
                                    {"random", 2, 2, 3},
                                    {"random", 3, 1, 3},
                                    {"genus", 2, 1, 3},
                                    {"random", 2, 1, 3}}) {
        const FlipCase flip_case = decode_script(script_input(start));
        EXPECT_EQ(start_of(flip_case), flip_case.start());
        EXPECT_EQ(&start_of(flip_case), &start_of(decode_script(script_input(start))));
    }
}

TEST(ScriptInput, EveryByteStringIsAValidCase) {
    kernel::RandomStream random(1);
    std::set<std::string_view> kinds;
    for (int k = 0; k < 400; ++k) {
        InputBytes bytes(random.below(40));
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random.bits());
        const FlipCase flip_case = decode_script(bytes);
        kinds.insert(flip_case.kind->name);
        const kernel::FlipLog log = flip_case.log();
        ASSERT_TRUE(audit(log.start).is_valid());
        for (const kernel::Edge e : log.flips)
            ASSERT_TRUE(e.id >= 0 && e.id < log.start.edge_count());
        EXPECT_EQ(script_of(flip_case), log.flips);
        ASSERT_EQ(script_objection(flip_case), "") << describe(flip_case);
    }
    EXPECT_EQ(kinds.size(), properties::start_kinds().size());
}

}  // namespace
}  // namespace tightflip::fuzz
