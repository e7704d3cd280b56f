#include "targets/halfedge_table.hpp"

#include "targets.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using kernel::RawTable;
using kernel::ViolationCode;

TEST(HalfedgeTableInput, IsVerticesAndTwoBytesAHalfedge) {
    const RawTable table = decode_table(InputBytes{1, 4, 0, 3, 12});
    EXPECT_EQ(table.vertex_count, 3);
    ASSERT_EQ(table.records.size(), 2U);
    EXPECT_EQ(table.records[0].next.id, -1);
    EXPECT_EQ(table.records[0].origin.id, 2);
    EXPECT_EQ(table.records[1].next.id, 11);
    EXPECT_EQ(table.records[1].origin.id, -1);
    EXPECT_EQ(decode_table(InputBytes(1000, 1)).records.size(), most_raw_halfedges);
}

TEST(HalfedgeTableInput, SaysWhatWasEncoded) {
    const auto book = kernel::families::book(6);
    const RawTable table = decode_table(encode_table(book));
    EXPECT_EQ(build(table.records, table.vertex_count).value(), book);
}

TEST(HalfedgeTableSeeds, ShowEveryViolationOfATable) {
    std::set<ViolationCode> codes;
    std::size_t valid = 0;
    for (const Seed& seed : halfedge_table_target.seeds()) {
        const RawTable table = decode_table(seed.bytes);
        const auto report = audit(table.records, table.vertex_count);
        valid += report.is_valid() ? 1 : 0;
        for (const auto& violation : report.violations)
            codes.insert(violation.code);
    }
    EXPECT_GE(valid, 30U);
    for (const ViolationCode code :
         {ViolationCode::halfedge_count_odd, ViolationCode::next_out_of_range,
          ViolationCode::next_cycle_not_triangle, ViolationCode::origin_out_of_range,
          ViolationCode::labels_disagree, ViolationCode::vertex_unused})
        EXPECT_TRUE(codes.contains(code)) << name(code);
}

TEST(HalfedgeTable, HoldsForDamagedTables) {
    kernel::RandomStream random(1);
    for (int k = 0; k < 300; ++k) {
        InputBytes bytes = encode_table(kernel::families::book(5));
        for (std::uint32_t n = random.below(3); n > 0; --n)
            bytes[1 + random.below(37)] = static_cast<std::uint8_t>(random.below(20));
        EXPECT_EQ(table_objection(decode_table(bytes)), "");
    }
}

}  // namespace
}  // namespace tightflip::fuzz
