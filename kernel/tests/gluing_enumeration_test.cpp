#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/gluing_enumeration.hpp>

#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

Triangulation surface_in(HalfedgeTable table, Index vertices) {
    return build({table.begin(), table.end()}, vertices).value();
}

struct Size {
    Index vertices;
    Index genus;
    std::uint64_t rooted;
    std::size_t classes;
};

class Gluings : public ::testing::TestWithParam<Size> {};

/// Rooted spheres: OEIS A000309. Rooted surfaces of three vertices: OEIS A060593(g), for they are
/// the pairs of cycles of length 2g + 1 whose product is such a cycle (the turns about the
/// vertices). The tori and the numbers of classes were counted by an independent program.
TEST_P(Gluings, AreAllVisitedOnce) {
    const Size& size = GetParam();
    std::set<std::vector<Index>> words;
    std::set<CanonicalCode> codes;
    const auto visited = enumerate_gluings(size.vertices, size.genus, [&](HalfedgeTable table) {
        const Triangulation surface = surface_in(table, size.vertices);
        EXPECT_EQ(surface.genus(), size.genus);
        words.insert(rooted_code(surface, {Halfedge{0}}, Labels::ignored));
        codes.insert(canonical_code(surface, {}));
        return true;
    });
    EXPECT_EQ(visited, size.rooted);
    EXPECT_EQ(words.size(), size.rooted) << "no rooted surface comes twice";
    EXPECT_EQ(codes.size(), size.classes);
    std::size_t roots = 0;
    for (const CanonicalCode& code : codes) {
        const Triangulation surface = surface_of(code);
        roots +=
            static_cast<std::size_t>(surface.halfedge_count()) / automorphism_count(surface, {});
    }
    EXPECT_EQ(roots, size.rooted) << "every class comes with all its roots";
}

INSTANTIATE_TEST_SUITE_P(Sizes, Gluings,
                         ::testing::Values(Size{3, 0, 1, 1}, Size{4, 0, 4, 2}, Size{5, 0, 24, 4},
                                           Size{6, 0, 176, 14}, Size{7, 0, 1456, 66},
                                           Size{8, 0, 13056, 409}, Size{3, 1, 1, 1},
                                           Size{4, 1, 51, 7}, Size{5, 1, 1413, 65},
                                           Size{3, 2, 8, 2}, Size{3, 3, 180, 10}),
                         [](const auto& instance) {
                             return "V" + std::to_string(instance.param.vertices) + "Genus" +
                                    std::to_string(instance.param.genus);
                         });

TEST(GluingEnumeration, CountsNineVertexSpheres) {
    EXPECT_EQ(enumerate_gluings(9, 0, [](HalfedgeTable) { return true; }), 124032U);
}

TEST(GluingEnumeration, MeetsEverySurfaceThatFlipsMeet) {
    std::set<CanonicalCode> glued;
    enumerate_gluings(5, 1, [&](HalfedgeTable table) {
        glued.insert(canonical_code(surface_in(table, 5), {}));
        return true;
    });
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        EXPECT_TRUE(glued.contains(canonical_code(families::random(5, 1, seed), {})));
    }
}

TEST(GluingEnumeration, EndsWhenTheVisitorHasSeenEnough) {
    for (const std::uint64_t enough : {1U, 5U, 24U}) {
        std::uint64_t seen = 0;
        EXPECT_EQ(enumerate_gluings(5, 0, [&](HalfedgeTable) { return ++seen < enough; }), enough);
        EXPECT_EQ(seen, enough);
    }
    EXPECT_EQ(enumerate_gluings(12, 2, [](HalfedgeTable) { return false; }), 1U);
    EXPECT_EQ(enumerate_gluings(33, 0, [](HalfedgeTable) { return false; }), 1U)
        << "the largest number of faces";
}

TEST(GluingEnumeration, ComesInTheSameOrderAgain) {
    const auto words = [] {
        std::vector<std::vector<Index>> all;
        enumerate_gluings(4, 1, [&](HalfedgeTable table) {
            all.push_back(rooted_code(surface_in(table, 4), {Halfedge{0}}, Labels::ignored));
            return true;
        });
        return all;
    };
    EXPECT_EQ(words(), words());
}

TEST(GluingEnumeration, RefusesSizesThatDoNotExistOrAreTooLarge) {
    constexpr Index huge = std::numeric_limits<Index>::max();
    const std::vector<std::pair<Index, Index>> sizes{{2, 0},    {0, 1},       {-4, 0}, {4, -1},
                                                     {34, 0},   {32, 1},      {3, 16}, {huge, 0},
                                                     {3, huge}, {huge, -huge}};
    for (const auto& [vertices, genus] : sizes) {
        EXPECT_THROW(enumerate_gluings(vertices, genus, [](HalfedgeTable) { return true; }),
                     std::invalid_argument)
            << vertices << " vertices, genus " << genus;
    }
}

TEST(GluingEnumeration, QuickSizesExist) {
    EXPECT_GE(largest_quick_enumeration(0), 9);
    EXPECT_GE(largest_quick_enumeration(1), 6);
    EXPECT_GE(largest_quick_enumeration(2), 4);
    EXPECT_EQ(largest_quick_enumeration(-1), 0);
    EXPECT_EQ(largest_quick_enumeration(100), 0);
}

}  // namespace
}  // namespace tightflip::kernel
