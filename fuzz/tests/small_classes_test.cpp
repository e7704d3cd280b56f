#include "small_classes.hpp"

#include <tightflip/kernel/canonical.hpp>

#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

/// Where a class's flips lead; none may be refused.
kernel::Triangulation surface_of_class(const SmallClass& one) {
    kernel::Triangulation surface = decode_script(script_input(one.start)).start();
    for (const std::uint32_t flip : one.flips)
        EXPECT_TRUE(surface.flip(kernel::Edge{static_cast<kernel::Index>(flip)})) << one.name;
    return surface;
}

TEST(SmallClasses, AreAllClassesOfTheirSizes) {
    std::map<std::pair<kernel::Index, kernel::Index>, std::set<kernel::CanonicalCode>> codes;
    for (const SmallClass& one : small_classes()) {
        const kernel::Triangulation surface = surface_of_class(one);
        auto& codes_of_size = codes[std::pair(surface.genus(), surface.vertex_count())];
        EXPECT_TRUE(codes_of_size.insert(canonical_code(surface, {})).second)
            << one.name << " comes again";
        EXPECT_LE(one.flips.size(), most_flips);
    }
    // As `tightflip explore` counts them, and the closed formula and all gluings confirm.
    const std::map<std::pair<kernel::Index, kernel::Index>, std::size_t> known{
        {{0, 3}, 1}, {{0, 4}, 2}, {{0, 5}, 4}, {{0, 6}, 14}, {{1, 3}, 1}, {{1, 4}, 7}};
    ASSERT_EQ(codes.size(), known.size());
    for (const auto& [size, count] : known)
        EXPECT_EQ(codes[size].size(), count) << "genus " << size.first << ", V " << size.second;
}

}  // namespace
}  // namespace tightflip::fuzz
