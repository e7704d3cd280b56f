#include "seed_surfaces.hpp"

#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

TEST(SeedSurfaces, AreValidSmallAndOfManyKinds) {
    std::set<kernel::Index> genera;
    bool is_any_simple = false;
    bool has_any_degree_two = false;
    for (const auto& [name, surface] : seed_surfaces()) {
        const kernel::AuditReport report = audit(surface);
        EXPECT_TRUE(report.is_valid()) << name;
        EXPECT_LE(surface.face_count(), 36) << name;
        genera.insert(surface.genus());
        is_any_simple |= report.is_simple().value();
        has_any_degree_two |= report.degrees->degree_two_vertices > 0;
    }
    EXPECT_EQ(genera, (std::set<kernel::Index>{0, 1, 2, 3}));
    EXPECT_TRUE(is_any_simple);
    EXPECT_TRUE(has_any_degree_two);
}

}  // namespace
}  // namespace tightflip::fuzz
