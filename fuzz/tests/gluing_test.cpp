#include "targets/gluing.hpp"

#include "targets.hpp"
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using kernel::Gluing;
using kernel::SideGluing;
using kernel::ViolationCode;

Gluing tetrahedron() {
    const auto surface = kernel::families::tetrahedron();
    return read_table(surface.table(), 4).gluing;
}

TEST(GluingInput, IsVerticesAndSixBytesAFace) {
    const Gluing gluing = decode_gluing(InputBytes{1, 5, 0, 1, 4, 0, 1, 4, 7});
    EXPECT_EQ(gluing.vertex_count, 4);
    ASSERT_EQ(gluing.faces.size(), 2U);  // of the second only a corner is there
    EXPECT_EQ(gluing.faces[0].corners, (std::array<kernel::Index, 3>{-1, 0, 3}));
    EXPECT_EQ(gluing.faces[0].sides[0], SideGluing());
    EXPECT_EQ(gluing.faces[0].sides[1], SideGluing::coherent(-1));
    EXPECT_EQ(gluing.faces[0].sides[2], SideGluing::reversed(0));
    EXPECT_EQ(gluing.faces[1].corners, (std::array<kernel::Index, 3>{6, -1, -1}));
    EXPECT_EQ(decode_gluing(InputBytes(1000, 1)).faces.size(), most_glued_faces);
    EXPECT_EQ(decode_gluing({}).vertex_count, -1);
}

TEST(GluingInput, SaysWhatWasEncoded) {
    for (const Seed& seed : gluing_target.seeds())
        EXPECT_EQ(encode_gluing(decode_gluing(seed.bytes)), seed.bytes) << seed.name;
    EXPECT_EQ(decode_gluing(encode_gluing(tetrahedron())), tetrahedron());
}

TEST(GluingSeeds, ShowEveryViolationOfAGluing) {
    std::set<ViolationCode> codes;
    std::size_t valid = 0;
    for (const Seed& seed : gluing_target.seeds()) {
        const auto report = audit(decode_gluing(seed.bytes));
        valid += report.is_valid() ? 1 : 0;
        for (const auto& violation : report.violations)
            codes.insert(violation.code);
    }
    EXPECT_GE(valid, 40U);
    for (const ViolationCode code : kernel::all_violation_codes()) {
        const auto number = static_cast<int>(code);
        // 11x are of halfedge tables, 204 and 205 of face lists, 90x and 91x of flips.
        if (number >= 900 || number / 10 == 11 || number == 204 || number == 205) continue;
        EXPECT_TRUE(codes.contains(code)) << name(code);
    }
}

TEST(Rearranged, IsAnotherTableOfTheSameSurface) {
    const Gluing before = tetrahedron();
    bool turned = false;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Gluing after = rearranged(before, seed);
        const auto report = audit(after);
        EXPECT_TRUE(report.is_valid()) << seed;
        turned |= !report.coherently_stored;
    }
    EXPECT_TRUE(turned);
    EXPECT_NE(rearranged(before, 1), before);
}

TEST(Heaps, AgreeWithTheAuditOnDamagedTables) {
    kernel::RandomStream random(1);
    std::size_t valid = 0;
    for (int k = 0; k < 500; ++k) {
        InputBytes bytes = encode_gluing(tetrahedron());
        for (std::uint32_t n = random.below(3); n > 0; --n)
            bytes[2 + random.below(24)] = static_cast<std::uint8_t>(random.below(27));
        const Gluing gluing = decode_gluing(bytes);
        EXPECT_EQ(judge_by_heaps(gluing).is_allowed, audit(gluing).is_valid());
        valid += judge_by_heaps(gluing).is_allowed ? 1 : 0;
    }
    EXPECT_GT(valid, 100U);
    EXPECT_LT(valid, 400U);
}

TEST(Heaps, KnowTheEulerCharacteristicAndWhatIsNotAllowed) {
    EXPECT_EQ(judge_by_heaps(tetrahedron()).euler_characteristic, 2);
    for (const Seed& seed : gluing_target.seeds()) {
        const std::set<std::string> refused{"loop",
                                            "projective_plane",
                                            "two_tetrahedra",
                                            "triangle_alone",
                                            "two_unused_vertices",
                                            "two_tetrahedra_at_a_vertex",
                                            "three_neighbours_coincide"};
        const HeapJudgement judgement = judge_by_heaps(decode_gluing(seed.bytes));
        if (refused.contains(seed.name)) {
            EXPECT_FALSE(judgement.is_allowed) << seed.name;
        }
        if (seed.name == "genus_three") {
            EXPECT_EQ(judgement.euler_characteristic, -4);
        }
    }
}

}  // namespace
}  // namespace tightflip::fuzz
