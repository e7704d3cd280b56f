#include "renumbering.hpp"

#include "seed_surfaces.hpp"
#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using kernel::Labels;
using kernel::Mirror;

TEST(Renumbering, OfHalfedgesKeepsTheLabelledSurface) {
    kernel::RandomStream random(1);
    bool changed = false;
    for (const auto& [name, surface] : seed_surfaces()) {
        const auto other = with_other_halfedges(surface, random);
        EXPECT_TRUE(same_labelled_surface(surface, other)) << name;
        changed |= !(surface == other);
    }
    EXPECT_TRUE(changed);
}

TEST(Renumbering, OfLabelsKeepsTheSurfaceAndItsHalfedges) {
    kernel::RandomStream random(1);
    bool changed = false;
    for (const auto& [name, surface] : seed_surfaces()) {
        const auto other = with_other_labels(surface, random);
        EXPECT_EQ(canonical_code(surface, {}), canonical_code(other, {})) << name;
        for (kernel::Halfedge h{0}; h.id < surface.halfedge_count(); ++h.id)
            EXPECT_EQ(surface.next(h), other.next(h));
        changed |= !same_labelled_surface(surface, other);
    }
    EXPECT_TRUE(changed);
}

TEST(Mirrored, IsTheMirrorImageAndTwiceTheSame) {
    bool has_another_hand = false;
    for (const auto& [name, surface] : seed_surfaces()) {
        const auto other = mirrored(surface);
        EXPECT_EQ(mirrored(other), surface) << name;
        EXPECT_EQ(canonical_code(surface, {Labels::kept, Mirror::identified}),
                  canonical_code(other, {Labels::kept, Mirror::identified}))
            << name;
        has_another_hand |= canonical_code(surface, {}) != canonical_code(other, {});
    }
    EXPECT_TRUE(has_another_hand);
}

}  // namespace
}  // namespace tightflip::fuzz
