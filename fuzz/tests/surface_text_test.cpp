#include "targets/surface_text.hpp"

#include "reading.hpp"
#include "targets.hpp"
#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

TEST(SurfaceTextSeeds, AreReadAndRefusedForManyReasons) {
    int tables = 0;
    int gluings = 0;
    int surfaces = 0;
    std::set<std::string> reasons;
    for (const Seed& seed : surface_text_target.seeds()) {
        const std::string_view text = as_text(seed.bytes);
        try {
            if (geometry::is_surface_text(text)) {
                static_cast<void>(geometry::parse_surface(text, "s"));
                ++surfaces;
            } else {
                const kernel::RawSurface surface = kernel::parse_surface(text, "s");
                ++(surface.index() == 0 ? tables : gluings);
            }
        } catch (const kernel::FileError& error) {
            reasons.insert(error.reason());
        }
    }
    EXPECT_GE(tables, 40);
    EXPECT_GE(gluings, 40);
    EXPECT_GE(surfaces, 3);
    EXPECT_GE(reasons.size(), 20U);
}

TEST(SurfaceText, HoldsForTextsCutAnywhere) {
    for (const Seed& seed : surface_text_target.seeds()) {
        if (!seed.name.starts_with("surface") && !seed.name.ends_with("tetrahedron")) continue;
        for (std::size_t size = 0; size < seed.bytes.size(); ++size)
            EXPECT_EQ(surface_text_objection(as_text(seed.bytes).substr(0, size)), "");
    }
}

}  // namespace
}  // namespace tightflip::fuzz
