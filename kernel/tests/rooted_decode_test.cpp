#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/rooted_decode.hpp>

#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

std::vector<std::uint8_t> code_of(HalfedgeTable table) {
    std::vector<std::uint8_t> code;
    RootedWalk walk;
    walk(table, {Halfedge{0}}, Labels::ignored, [&](Index symbol) {
        code.push_back(static_cast<std::uint8_t>(symbol));
        return true;
    });
    return code;
}

template <class Symbol>
Index decode(const std::vector<Symbol>& code, std::vector<HalfedgeRecord>& records) {
    return decode(std::span(code), records);
}

/// The words that can be decoded among all of `length` symbols, of which the k-th goes up to 3k:
/// one more than sides are discovered before it is said.
std::vector<std::vector<std::uint8_t>> words_that_decode(std::size_t length) {
    std::vector<std::vector<std::uint8_t>> accepted;
    std::vector<std::uint8_t> word(length, 0);
    std::vector<HalfedgeRecord> records;
    for (std::size_t i = 0; i < length;) {
        try {
            decode(word, records);
            accepted.push_back(word);
        } catch (const std::invalid_argument&) {
        }
        for (i = 0; i < length && ++word[i] > 3 * (i + 1); ++i)
            word[i] = 0;
    }
    return accepted;
}

/// Rooted triangulations of closed orientable surfaces, loops allowed: OEIS A062980. Of two faces
/// they are 4 spheres and a torus.
TEST(RootedDecode, TakesExactlyTheWordsOfRootedSurfaces) {
    for (const auto& [length, count] :
         {std::pair<std::size_t, std::size_t>{3, 5}, std::pair<std::size_t, std::size_t>{6, 60}}) {
        const auto words = words_that_decode(length);
        EXPECT_EQ(words.size(), count);
        for (const auto& word : words) {
            std::vector<HalfedgeRecord> records;
            decode(word, records);
            EXPECT_EQ(code_of(records), word);
        }
    }
}

TEST(RootedDecode, NumbersEdgesBySymbolsAndVerticesByTheWalk) {
    for (const Triangulation& surface :
         {families::book(3), families::tetrahedron(), families::book(6), families::random(20, 0, 5),
          families::random(9, 2, 5), families::torus_grid(4, 3)}) {
        const auto code = code_of(surface.table());
        std::vector<HalfedgeRecord> records;
        const Index vertices = decode(code, records);
        EXPECT_EQ(vertices, surface.vertex_count());
        ASSERT_EQ(records.size(), surface.table().size());

        RootedWalk walk;
        walk(records, {Halfedge{0}}, Labels::ignored, [](Index) { return true; });
        Index edges = 0;
        Index met = 0;
        std::set<Index> spoken;
        for (const Halfedge side : walk.order()) {
            const Index origin = at(HalfedgeTable(records), side).origin.id;
            EXPECT_LE(origin, met) << "vertices come in the order of the walk";
            met = std::max(met, origin + 1);
            if (spoken.insert(edge_of(side).id).second) {
                EXPECT_EQ(side.id, 2 * edges++) << "even halves speak, in the order of edges";
            }
        }
        EXPECT_EQ(met, vertices);
    }
}

TEST(RootedDecode, ReusesMemoryAndTakesSymbolsOfAnyWidth) {
    std::vector<HalfedgeRecord> records;
    decode(code_of(families::random(20, 0, 1).table()), records);
    const auto capacity = records.capacity();
    const auto* const memory = records.data();
    const Triangulation surface = families::random(20, 0, 2);
    const auto narrow = code_of(surface.table());
    EXPECT_EQ(decode(narrow, records), 20);
    EXPECT_EQ(records.capacity(), capacity);
    EXPECT_EQ(records.data(), memory);
    std::vector<HalfedgeRecord> from_wide;
    decode(std::vector<Index>(narrow.begin(), narrow.end()), from_wide);
    EXPECT_EQ(from_wide, records);
}

TEST(RootedDecode, RefusesWhatNoWalkSpells) {
    const std::vector<std::vector<Index>> words{{},
                                                {0},
                                                {0, 5},
                                                {0, 5, 5},
                                                {0, 4, 5, 0},
                                                {0, 5, -1},
                                                {1, 2, 2},
                                                {0, 6, 4},
                                                {0, 0, 0},
                                                {0, 5, 4, 0, 5, 4},
                                                {0, 0, 0, 11, 7, 7},
                                                {0, 0, 0, 0, 7, 10}};
    std::vector<HalfedgeRecord> records;
    for (const auto& word : words) {
        EXPECT_THROW(decode(word, records), std::invalid_argument)
            << ::testing::PrintToString(word);
    }
}

}  // namespace
}  // namespace tightflip::kernel
