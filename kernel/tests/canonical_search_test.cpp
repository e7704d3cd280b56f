#include "disguises.hpp"
#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/canonical_search.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

constexpr std::array<Equality, 4> equalities{{{Labels::ignored, Mirror::distinct},
                                              {Labels::ignored, Mirror::identified},
                                              {Labels::kept, Mirror::distinct},
                                              {Labels::kept, Mirror::identified}}};

std::vector<Index> search_on(CanonicalSearch& search, const Triangulation& surface,
                             Equality equality) {
    std::vector<Index> code(code_length(surface.table().size(), equality.labels));
    search(surface.table(), surface.vertex_count(), equality, std::span(code));
    return code;
}

/// Few and many symmetries, with and without reversals, below and above where orbits are used.
std::vector<Triangulation> samples() {
    return {families::book(3),
            families::tetrahedron(),
            families::book(30),
            families::double_wheel(25),
            families::prism(20),
            families::antiprism(20),
            families::octasphere(2),
            families::icosphere(1),
            families::torus_grid(3, 3),
            families::torus_grid(5, 5),
            families::torus_grid(4, 9),
            families::surface_of_genus(2, 3, 0),
            families::surface_of_genus(3, 3, 1),
            families::stacked(40, 1),
            families::random(12, 0, 1),
            families::random(30, 2, 2)};
}

/// The definition: best roots are all those from which the walk spells the code.
TEST(CanonicalSearch, BestRootsAreAllThatSpellTheCode) {
    CanonicalSearch search;
    for (const Triangulation& surface : samples()) {
        for (const Equality equality : equalities) {
            const std::vector<Index> code = search_on(search, surface, equality);
            std::vector<Root> best(search.best_roots().begin(), search.best_roots().end());
            std::size_t spelling = 0;
            for (const Handedness handedness : {Handedness::kept, Handedness::mirrored}) {
                if (handedness == Handedness::mirrored && equality.mirror == Mirror::distinct) {
                    continue;
                }
                for (Index h = 0; h < surface.halfedge_count(); ++h) {
                    const Root root{{h}, handedness};
                    const bool spells = rooted_code(surface, root, equality.labels) == code;
                    EXPECT_EQ(std::ranges::count(best, root), spells ? 1 : 0) << "root " << h;
                    spelling += spells ? 1U : 0U;
                }
            }
            EXPECT_EQ(best.size(), spelling);
            EXPECT_GT(spelling, 0U);
        }
    }
}

TEST(CanonicalSearch, DoesNotDependOnNumbersNorOnEarlierSearches) {
    RandomStream random(7);
    CanonicalSearch reused;
    for (const Triangulation& surface : samples()) {
        for (const Equality equality : equalities) {
            CanonicalSearch fresh;
            const std::vector<Index> code = search_on(fresh, surface, equality);
            for (int copy = 0; copy < 5; ++copy) {
                Triangulation other = testing::renumbered(surface, random);
                if (equality.mirror == Mirror::identified && copy % 2 == 1) {
                    other = testing::mirrored(other);
                }
                if (equality.labels == Labels::ignored) other = testing::relabelled(other, random);
                EXPECT_EQ(search_on(reused, other, equality), code);
                EXPECT_EQ(reused.best_roots().size(), fresh.best_roots().size());
            }
        }
    }
}

/// Where several degrees are equally rare, labels must not decide among them.
TEST(CanonicalSearch, DoesNotBreakTiesByLabels) {
    RandomStream random(4);
    CanonicalSearch search;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Triangulation surface = families::random(7, 0, seed);
        const Triangulation other = testing::relabelled(surface, random);
        EXPECT_EQ(search_on(search, surface, {}), search_on(search, other, {})) << "seed " << seed;
    }
}

TEST(CanonicalSearch, SymbolsMayBeNarrow) {
    for (const Triangulation& surface : samples()) {
        if (surface.halfedge_count() > 255) continue;
        CanonicalSearch search;
        const std::vector<Index> wide = search_on(search, surface, {});
        std::vector<std::uint8_t> narrow(wide.size());
        search(surface.table(), surface.vertex_count(), {}, std::span(narrow));
        EXPECT_TRUE(std::ranges::equal(wide, narrow));
    }
}

/// Where every root looks like every other, trying each would take days.
TEST(CanonicalSearch, UsesTheSymmetriesOfLargeSurfaces) {
    CanonicalSearch search;
    const auto group = [&](const Triangulation& surface, Mirror mirror) {
        search_on(search, surface, {Labels::ignored, mirror});
        return search.best_roots().size();
    };
    EXPECT_EQ(group(families::torus_grid(150, 150), Mirror::distinct), 6U * 150 * 150);
    EXPECT_EQ(group(families::torus_grid(150, 150), Mirror::identified), 12U * 150 * 150);
    EXPECT_EQ(group(families::torus_grid(150, 200), Mirror::distinct), 2U * 150 * 200);
    EXPECT_EQ(group(families::double_wheel(20002), Mirror::distinct), 2U * 20000);
    EXPECT_EQ(group(families::book(20002), Mirror::identified), 4U * 20000);
    RandomStream random(3);
    EXPECT_EQ(group(testing::renumbered(families::torus_grid(100, 150), random), Mirror::distinct),
              2U * 100 * 150);
}

}  // namespace
}  // namespace tightflip::kernel
