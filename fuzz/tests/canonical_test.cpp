#include "targets/canonical.hpp"

#include "renumbering.hpp"
#include "targets.hpp"
#include <tightflip/kernel/families.hpp>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using kernel::Equality;
using kernel::Labels;
using kernel::Mirror;

TEST(CanonicalInput, IsAStartASeedAndFlips) {
    const CanonicalCase surfaces = decode_canonical(InputBytes{1, 0, 0, 0, 0, 9, 3, 0});
    EXPECT_EQ(surfaces.surface, kernel::families::tetrahedron());
    EXPECT_EQ(surfaces.seed, 9U);
    auto flipped = surfaces.surface;
    ASSERT_TRUE(flipped.flip({3}));
    EXPECT_EQ(surfaces.other, flipped);
    EXPECT_EQ(decode_canonical({}).other, kernel::families::tetrahedron());
}

TEST(IsomorphismsByWalks, AreThePlatonicGroups) {
    constexpr Equality turned{Labels::ignored, Mirror::distinct};
    constexpr Equality reflected{Labels::ignored, Mirror::identified};
    constexpr Equality labelled{Labels::kept, Mirror::distinct};
    const auto tetrahedron = kernel::families::tetrahedron();
    const auto icosahedron = kernel::families::icosphere(0);
    EXPECT_EQ(isomorphisms_by_walks(tetrahedron, tetrahedron, turned), 12U);
    EXPECT_EQ(isomorphisms_by_walks(tetrahedron, tetrahedron, reflected), 24U);
    EXPECT_EQ(isomorphisms_by_walks(tetrahedron, tetrahedron, labelled), 1U);
    EXPECT_EQ(isomorphisms_by_walks(icosahedron, icosahedron, turned), 60U);
    EXPECT_EQ(isomorphisms_by_walks(tetrahedron, mirrored(tetrahedron), labelled), 0U);
    EXPECT_EQ(isomorphisms_by_walks(tetrahedron, icosahedron, turned), 0U);
}

TEST(CanonicalSeeds, HaveEqualAndDifferentPairsAndSymmetries) {
    int equal = 0;
    int different = 0;
    std::size_t symmetries = 1;
    for (const Seed& seed : canonical_target.seeds()) {
        const CanonicalCase surfaces = decode_canonical(seed.bytes);
        ++(isomorphisms_by_walks(surfaces.surface, surfaces.other, {}) > 0 ? equal : different);
        symmetries =
            std::max(symmetries, isomorphisms_by_walks(surfaces.surface, surfaces.surface, {}));
    }
    EXPECT_GE(equal, 15);
    EXPECT_GE(different, 15);
    EXPECT_EQ(symmetries, 60U);
}

}  // namespace
}  // namespace tightflip::fuzz
