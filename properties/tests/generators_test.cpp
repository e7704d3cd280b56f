#include <tightflip/properties/generators.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

/// The genera that a kind can be asked for, up to 3.
std::vector<Index> genera(const StartKind& kind) {
    return kind.any_genus ? std::vector<Index>{0, 1, 2, 3} : std::vector<Index>{0};
}

TEST(StartKinds, KeepTheirOrder) {  // corpora of the fuzz targets refer to it
    std::vector<std::string_view> names;
    for (const StartKind& kind : start_kinds())
        names.push_back(kind.name);
    names.resize(std::min<std::size_t>(names.size(), 16));
    EXPECT_THAT(names, ::testing::ElementsAre("tetrahedron", "book", "double-wheel", "stacked",
                                              "prism", "antiprism", "octasphere", "icosphere",
                                              "torus", "genus", "random", "fan", "degree-2-chain",
                                              "digons", "hub", "simple"));
}

TEST(StartKinds, AreFoundByTheirNamesAlone) {
    std::set<std::string_view> names;
    for (const StartKind& kind : start_kinds()) {
        EXPECT_EQ(find_start_kind(kind.name), &kind);
        EXPECT_TRUE(names.insert(kind.name).second) << kind.name << " twice";
        EXPECT_FALSE(kind.description.empty());
    }
    EXPECT_EQ(find_start_kind("Torus"), nullptr);
    EXPECT_EQ(find_start_kind(""), nullptr);
}

TEST(StartKinds, MakeTheRequestedSurfaceOrRefuseTheSize) {
    for (const StartKind& kind : start_kinds()) {
        for (const Index genus : genera(kind)) {
            const Index least = kind.least_vertices(genus);
            EXPECT_THROW(static_cast<void>(kind.make({.vertices = least - 1, .genus = genus})),
                         std::invalid_argument)
                << kind.name;
            for (Index vertices = least; vertices < least + 40; ++vertices) {
                SCOPED_TRACE(::testing::Message()
                             << kind.name << ", V = " << vertices << ", genus " << genus);
                std::optional<Triangulation> surface;
                try {
                    surface = kind.make({.vertices = vertices, .genus = genus, .seed = 5});
                } catch (const std::invalid_argument&) {
                    EXPECT_NE(vertices, least) << "the least size must be one";
                    continue;
                }
                const kernel::AuditReport report = audit(*surface);
                EXPECT_TRUE(report.is_valid());
                EXPECT_EQ(report.topology.vertices, vertices);
                EXPECT_EQ(report.topology.genus, kind.name == "torus" ? 1 : genus);
                EXPECT_EQ(*surface, kind.make({.vertices = vertices, .genus = genus, .seed = 5}));
            }
        }
    }
}

TEST(StartKinds, CoverSimpleAndMultigraphStartsOfEveryGenusUpToThree) {
    for (Index genus = 0; genus <= 3; ++genus) {
        std::set<bool> simple;
        for (const StartKind& kind : start_kinds()) {
            if (!kind.any_genus) continue;
            simple.insert(
                audit(kind.make({.vertices = 6 * genus + 4, .genus = genus})).is_simple().value());
        }
        EXPECT_EQ(simple.size(), 2U) << "genus " << genus;
    }
}

TEST(MakeNearest, RoundsDownToASizeTheKindHasAndUpToItsLeast) {
    struct Row {
        const char* kind;
        Index asked;
        Index given;
    };
    for (const auto& [kind, asked, given] :
         {Row{"octasphere", 65, 18}, Row{"octasphere", 66, 66}, Row{"icosphere", 13, 12},
          Row{"torus", 11, 9}, Row{"torus", 12, 12}, Row{"prism", 9, 8}, Row{"antiprism", 0, 6},
          Row{"book", -5, 3}, Row{"tetrahedron", 100, 4}, Row{"stacked", 17, 17}}) {
        EXPECT_EQ(make_nearest(*find_start_kind(kind), {.vertices = asked}).vertex_count(), given)
            << kind << " of " << asked;
    }
    EXPECT_EQ(make_nearest(*find_start_kind("genus"), {.vertices = 0, .genus = 2}).vertex_count(),
              3);
}

TEST(RandomScript, DrawsEveryEdgeOfTheStartAboutEquallyOften) {
    const Triangulation start = make_nearest(*find_start_kind("stacked"), {.vertices = 8});
    kernel::RandomStream random(3);
    const FlipScript script = random_script(start, 18'000, random);
    ASSERT_EQ(script.size(), 18'000U);
    std::vector<int> drawn(static_cast<std::size_t>(start.edge_count()));
    for (const Edge e : script)
        ++drawn.at(static_cast<std::size_t>(e.id));
    EXPECT_GT(*std::ranges::min_element(drawn), 800);  // 1000 expected, deviation 31
    EXPECT_LT(*std::ranges::max_element(drawn), 1200);
    kernel::RandomStream again(3);
    EXPECT_EQ(random_script(start, 18'000, again), script);
    EXPECT_NE(random_script(start, 18'000, again), script);
    EXPECT_TRUE(random_script(start, 0, again).empty());
}

TEST(WithoutRefused, KeepsTheFlipsThatAreDone) {
    const Triangulation book = make_nearest(*find_start_kind("book"), {.vertices = 5});
    kernel::RandomStream random(1);
    const FlipScript script = random_script(book, 60, random);
    const FlipScript done = without_refused(book, script);
    EXPECT_LT(done.size(), script.size());
    EXPECT_GT(done.size(), 10U);
    Triangulation all = book;
    Triangulation only_done = book;
    for (const Edge e : script)
        static_cast<void>(all.flip(e));
    for (const Edge e : done)
        EXPECT_TRUE(only_done.flip(e));
    EXPECT_EQ(all, only_done);
}

}  // namespace
}  // namespace tightflip::properties
