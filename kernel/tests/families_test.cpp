#include "surfaces.hpp"
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::HasSubstr;

constexpr Index most = std::numeric_limits<Index>::max();

struct Face {
    Index a, b, c;
};

/// The corners of all faces; what follows is judged from these alone.
std::vector<Face> faces_of(const Triangulation& surface) {
    const auto table = surface.table();
    std::vector<Face> faces;
    for (const auto& record : table) {
        const auto& second = table[static_cast<std::size_t>(record.next.id)];
        const auto& third = table[static_cast<std::size_t>(second.next.id)];
        const Face face{record.origin.id, second.origin.id, third.origin.id};
        if (face.a < face.b && face.a < face.c) faces.push_back(face);
    }
    return faces;
}

/// Degree of every vertex: on a closed surface a vertex lies in as many faces as it has edges.
std::vector<Index> degrees(const Triangulation& surface) {
    std::vector<Index> degree(static_cast<std::size_t>(surface.vertex_count()));
    for (const Face& face : faces_of(surface)) {
        for (const Index v : {face.a, face.b, face.c})
            ++testing::nth(degree, v);
    }
    return degree;
}

/// How many vertices have each degree.
std::map<Index, Index> degree_counts(const Triangulation& surface) {
    std::map<Index, Index> counts;
    for (const Index degree : degrees(surface))
        ++counts[degree];
    return counts;
}

/// Edges whose two faces have different third corners: those a flip does not turn into a loop.
Index flippable_edges(const Triangulation& surface) {
    const auto table = surface.table();
    const auto third_corner = [&](std::size_t h) {
        const auto& second = table[static_cast<std::size_t>(table[h].next.id)];
        return table[static_cast<std::size_t>(second.next.id)].origin;
    };
    Index count = 0;
    for (std::size_t h = 0; h < table.size(); h += 2) {
        if (third_corner(h) != third_corner(h + 1)) ++count;
    }
    return count;
}

/// Valid, and of this size and genus.
void expect_surface(const Triangulation& surface, Index vertices, Index genus, bool simple) {
    const AuditReport report = audit(surface);
    EXPECT_TRUE(report.is_valid());
    EXPECT_TRUE(report.topology.orientable);
    EXPECT_EQ(report.topology.components, 1);
    EXPECT_EQ(report.topology.vertices, vertices);
    EXPECT_EQ(report.topology.edges, 3 * vertices - 6 + 6 * genus);
    EXPECT_EQ(report.topology.faces, 2 * vertices - 4 + 4 * genus);
    EXPECT_EQ(report.topology.genus, genus);
    EXPECT_EQ(report.is_simple(), simple);
    EXPECT_EQ(surface.vertex_count(), vertices);
    EXPECT_EQ(surface.edge_count(), report.topology.edges);
    EXPECT_EQ(surface.face_count(), report.topology.faces);
    EXPECT_EQ(surface.genus(), genus);
    EXPECT_EQ(faces_of(surface).size(), static_cast<std::size_t>(report.topology.faces));
}

// ---- each family ----

TEST(Families, Tetrahedron) {
    expect_surface(families::tetrahedron(), 4, 0, true);
    EXPECT_EQ(flippable_edges(families::tetrahedron()), 6);
    EXPECT_TRUE(same_labelled_surface(
        families::tetrahedron(),
        build(testing::FaceList{{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}, 4).value()));
}

TEST(Families, Book) {
    for (const Index vertices : {4, 5, 6, 7, 8, 20, 101, 1000}) {
        SCOPED_TRACE(vertices);
        const Triangulation book = families::book(vertices);
        expect_surface(book, vertices, 0, false);
        const AuditReport report = audit(book);
        EXPECT_EQ(report.parallels->pairs_joined_twice, 1);
        EXPECT_EQ(report.parallels->max_multiplicity, vertices - 2);
        EXPECT_EQ(report.degrees->degree_two_vertices, vertices - 2);
        const std::vector<Index> degree = degrees(book);
        EXPECT_EQ(degree[0], 2 * (vertices - 2));
        EXPECT_EQ(degree[1], 2 * (vertices - 2));

        // About pole 0 the edges to pole 1 alternate with those to vertices of degree 2.
        std::vector<Index> round;
        for (const Vertex v : book.neighbours(book.outgoing()[0]))
            round.push_back(v.id);
        ASSERT_EQ(round.size(), static_cast<std::size_t>(2 * (vertices - 2)));
        const std::size_t first = round[0] == 1 ? 0 : 1;
        std::set<Index> between;
        for (std::size_t i = 0; i < round.size(); i += 2) {
            EXPECT_EQ(round[i + first], 1);
            between.insert(round[i + 1 - first]);
        }
        EXPECT_EQ(between.size(), static_cast<std::size_t>(vertices - 2));
        EXPECT_FALSE(between.contains(1));
    }
}

TEST(Families, ABookCanBeFlippedAtItsParallelEdgesAlone) {
    for (const Index vertices : {4, 5, 6, 7, 50}) {
        const Triangulation book = families::book(vertices);
        EXPECT_EQ(flippable_edges(book), vertices - 2);
        for (Index e = 0; e < book.edge_count(); ++e) {
            const std::set<Index> ends{book.origin(halfedge_of({e})).id,
                                       book.target(halfedge_of({e})).id};
            const bool joins_poles = ends == std::set<Index>{0, 1};
            EXPECT_EQ(static_cast<bool>(book.can_flip({e})), joins_poles) << "edge " << e;
        }
    }
}

TEST(Families, TheBookOfThreeVerticesIsTheTwoFaceSphere) {
    const Triangulation book = families::book(3);
    expect_surface(book, 3, 0, false);
    EXPECT_EQ(degrees(book), (std::vector<Index>{2, 2, 2}));
    EXPECT_EQ(flippable_edges(book), 0);
    for (Index e = 0; e < 3; ++e)
        EXPECT_FALSE(book.can_flip({e}));
}

TEST(Families, DoubleWheel) {
    for (const Index vertices : {5, 6, 7, 8, 30, 1001}) {
        SCOPED_TRACE(vertices);
        const Triangulation wheel = families::double_wheel(vertices);
        expect_surface(wheel, vertices, 0, true);
        std::vector<Index> expected(static_cast<std::size_t>(vertices), 4);
        expected[0] = expected[1] = vertices - 2;
        EXPECT_EQ(degrees(wheel), expected);
        for (const Face& face : faces_of(wheel))
            EXPECT_FALSE(face.a == 0 && face.b == 1);
    }
}

/// Whether taking away vertices of degree 3 one by one ends in a tetrahedron.
bool is_stacked(const Triangulation& surface) {
    std::map<Index, std::set<Index>> adjacent;
    for (const auto& [a, b, c] : faces_of(surface)) {
        adjacent[a].insert({b, c});
        adjacent[b].insert({a, c});
        adjacent[c].insert({a, b});
    }
    while (adjacent.size() > 4) {
        const auto leaf =
            std::ranges::find_if(adjacent, [](const auto& v) { return v.second.size() == 3; });
        if (leaf == adjacent.end()) return false;
        for (const Index neighbour : leaf->second)
            adjacent.at(neighbour).erase(leaf->first);
        adjacent.erase(leaf);
    }
    return std::ranges::all_of(adjacent, [](const auto& v) { return v.second.size() == 3; });
}

TEST(Families, Stacked) {
    for (const Index vertices : {4, 5, 6, 9, 40, 300}) {
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            SCOPED_TRACE(vertices);
            const Triangulation sphere = families::stacked(vertices, seed);
            expect_surface(sphere, vertices, 0, true);
            EXPECT_TRUE(is_stacked(sphere));
        }
    }
    EXPECT_FALSE(is_stacked(families::octasphere(0))) << "the recogniser can say no";
}

TEST(Families, StackedVerticesFallIntoEveryFaceUnderEveryLabel) {
    // With five vertices the two of degree 3 are the last one and the corner it hides.
    std::map<std::set<Index>, int> apices;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const std::vector<Index> degree = degrees(families::stacked(5, seed));
        std::set<Index> pair;
        for (Index v = 0; v < 5; ++v) {
            if (testing::nth(degree, v) == 3) pair.insert(v);
        }
        ++apices[pair];
    }
    EXPECT_EQ(apices.size(), 10U);
    for (const auto& [pair, times] : apices) {
        EXPECT_EQ(pair.size(), 2U);
        EXPECT_GT(times, 20) << "of 50 expected";
    }
}

TEST(Families, Prism) {
    for (const Index k : {3, 4, 5, 6, 7, 8, 31, 200}) {
        SCOPED_TRACE(k);
        expect_surface(families::prism(k), 2 * k, 0, true);
    }
    // The triangular prism cannot alternate all the way: three diagonals make a path.
    EXPECT_EQ(degree_counts(families::prism(3)), (std::map<Index, Index>{{3, 2}, {4, 2}, {5, 2}}));
    // Else, diagonals that alternate meet in every other corner, two in each. A polygon's own
    // diagonals add 1 to its corners but for two, and k - 3 to the one they start from: once
    // where two diagonals of the band end, once where none does.
    for (const Index k : {4, 6, 8, 32}) {
        std::map<Index, Index> expected;
        expected[5 + k - 3] += 1;  // the bottom's first corner
        expected[3] += 2;          // its two neighbours
        expected[3 + k - 3] += 1;  // the top's first corner
        expected[5] += 2;          // its two neighbours
        expected[6] += k / 2 - 1;  // the others, bottom and top: two diagonals of the band and one
        expected[4] += k / 2 - 2;
        expected[6] += k / 2 - 2;
        expected[4] += k / 2 - 1;
        std::erase_if(expected, [](const auto& count) { return count.second == 0; });
        EXPECT_EQ(degree_counts(families::prism(k)), expected) << k;
    }
}

TEST(Families, Antiprism) {
    for (const Index k : {3, 4, 5, 6, 7, 31, 200}) {
        SCOPED_TRACE(k);
        const Triangulation antiprism = families::antiprism(k);
        expect_surface(antiprism, 2 * k, 0, true);
        // 2 polygon sides and 2 sides of the band at each corner, and the polygons' diagonals.
        std::map<Index, Index> expected;
        expected[4 + k - 3] += 2;
        expected[4] += 4;
        if (k > 3) expected[5] += 2 * (k - 3);
        EXPECT_EQ(degree_counts(antiprism), expected);
    }
}

TEST(Families, Octasphere) {
    EXPECT_EQ(degree_counts(families::octasphere(0)), (std::map<Index, Index>{{4, 6}}));
    Index vertices = 6;
    for (int level = 0; level <= 5; ++level) {
        SCOPED_TRACE(level);
        const Triangulation sphere = families::octasphere(level);
        expect_surface(sphere, vertices, 0, true);
        std::map<Index, Index> counts = degree_counts(sphere);
        EXPECT_EQ(counts[4], 6);
        EXPECT_EQ(counts[6], vertices - 6);
        vertices = 4 * vertices - 6;  // a new vertex on each of the 3 V - 6 edges
    }
    EXPECT_EQ(families::octasphere(5).vertex_count(), 4098);
}

TEST(Families, Icosphere) {
    EXPECT_EQ(degree_counts(families::icosphere(0)), (std::map<Index, Index>{{5, 12}}));
    Index vertices = 12;
    for (int level = 0; level <= 4; ++level) {
        SCOPED_TRACE(level);
        const Triangulation sphere = families::icosphere(level);
        expect_surface(sphere, vertices, 0, true);
        std::map<Index, Index> counts = degree_counts(sphere);
        EXPECT_EQ(counts[5], 12);
        EXPECT_EQ(counts[6], vertices - 12);
        vertices = 4 * vertices - 6;
    }
    EXPECT_EQ(families::icosphere(4).vertex_count(), 2562);
}

TEST(Families, TorusGrid) {
    struct Size {
        Index m, n;
    };
    for (const auto& [m, n] :
         {Size{3, 3}, Size{3, 4}, Size{4, 3}, Size{5, 7}, Size{3, 100}, Size{40, 50}}) {
        SCOPED_TRACE(std::to_string(m) + " by " + std::to_string(n));
        const Triangulation torus = families::torus_grid(m, n);
        expect_surface(torus, m * n, 1, true);
        EXPECT_EQ(degree_counts(torus), (std::map<Index, Index>{{6, m * n}}));
    }
}

TEST(Families, SurfaceOfGenusIsSimpleWhereThereIsRoom) {
    for (Index genus = 0; genus <= 4; ++genus) {
        const Index room = genus == 0 ? 4 : 6 * genus + 3;
        for (const Index vertices : {room, room + 1, room + 10, room + 200}) {
            SCOPED_TRACE(std::to_string(genus) + " handles, vertices " + std::to_string(vertices));
            expect_surface(families::surface_of_genus(genus, vertices, 7), vertices, genus, true);
        }
    }
}

TEST(Families, SurfaceOfGenusExistsDownToThreeVertices) {
    for (const Index genus : {1, 2, 3, 4, 25}) {
        for (const Index vertices : {3, 4, 5, 6, 6 * genus + 2}) {
            SCOPED_TRACE(std::to_string(genus) + " handles, vertices " + std::to_string(vertices));
            expect_surface(families::surface_of_genus(genus, vertices, 7), vertices, genus, false);
        }
        EXPECT_EQ(flippable_edges(families::surface_of_genus(genus, 3, 7)), 0)
            << "with three vertices there is no flip on any genus";
    }
}

TEST(Families, GenusZeroIsStacked) {
    EXPECT_EQ(families::surface_of_genus(0, 30, 5), families::stacked(30, 5));
}

TEST(Families, RandomIsAMultigraphOfTheSizeAsked) {
    struct Size {
        Index vertices, genus;
    };
    for (const auto& [vertices, genus] : {Size{5, 0}, Size{30, 0}, Size{500, 0}, Size{4, 1},
                                          Size{60, 1}, Size{5, 2}, Size{60, 3}, Size{200, 4}}) {
        for (std::uint64_t seed = 1; seed < 4; ++seed) {
            SCOPED_TRACE(std::to_string(vertices) + " vertices, genus " + std::to_string(genus));
            const Triangulation surface = families::random(vertices, genus, seed);
            const bool simple = audit(surface).is_simple().value();
            expect_surface(surface, vertices, genus, simple);
            if (vertices >= 30) {
                EXPECT_FALSE(simple);
            }
            EXPECT_FALSE(
                same_labelled_surface(surface, families::surface_of_genus(genus, vertices, seed)));
        }
    }
    expect_surface(families::random(3, 2, 1), 3, 2, false);
}

TEST(Families, RandomReachesEveryTriangulationWithFourVertices) {
    // There are 8: the tetrahedron and its mirror image, and 6 books, one for each pair of poles.
    std::map<std::uint64_t, int> times;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        ++times[surface_hash(families::random(4, 0, seed))];
    }
    EXPECT_EQ(times.size(), 8U);
    for (const auto& [hash, count] : times)
        EXPECT_GT(count, 10);
}

// ---- seeds ----

using Seeded = std::function<Triangulation(std::uint64_t)>;

std::map<std::string, Seeded> seeded_families() {
    return {
        {"stacked", [](std::uint64_t seed) { return families::stacked(60, seed); }},
        {"sphere", [](std::uint64_t seed) { return families::surface_of_genus(0, 60, seed); }},
        {"simple genus 2",
         [](std::uint64_t seed) { return families::surface_of_genus(2, 60, seed); }},
        {"dense genus 3",
         [](std::uint64_t seed) { return families::surface_of_genus(3, 12, seed); }},
        {"random sphere", [](std::uint64_t seed) { return families::random(60, 0, seed); }},
        {"random genus 2", [](std::uint64_t seed) { return families::random(60, 2, seed); }},
    };
}

TEST(FamiliesSeeds, TheSameSeedGivesTheSameTables) {
    for (const auto& [name, make] : seeded_families()) {
        for (const std::uint64_t seed : {0ULL, 1ULL, 12345678901234567890ULL}) {
            EXPECT_EQ(make(seed), make(seed)) << name;
        }
    }
}

TEST(FamiliesSeeds, OtherSeedsGiveOtherSurfaces) {
    for (const auto& [name, make] : seeded_families()) {
        std::set<std::uint64_t> hashes;
        for (std::uint64_t seed = 0; seed < 50; ++seed)
            hashes.insert(surface_hash(make(seed)));
        hashes.insert(surface_hash(make(1ULL << 32)));
        hashes.insert(surface_hash(make(1ULL << 63)));
        EXPECT_EQ(hashes.size(), 52U) << name;
    }
}

/// Hashes of what one compiler on one machine made: every other must make the same. A change here
/// changes what every published seed means.
TEST(FamiliesSeeds, MeanTheSameOnEveryMachineAndCompiler) {
    struct Fingerprint {
        const char* name;
        Triangulation surface;
        std::uint64_t hash;
    };
    for (const auto& [name, surface, hash] :
         {Fingerprint{"stacked(10, 0)", families::stacked(10, 0), 0x6cc51416592182fULL},
          Fingerprint{"stacked(1000, 42)", families::stacked(1000, 42), 0x5501ea65dd37f0eULL},
          Fingerprint{"surface_of_genus(2, 40, 7)", families::surface_of_genus(2, 40, 7),
                      0x39ccd3f282791fbcULL},
          Fingerprint{"surface_of_genus(3, 5, 7)", families::surface_of_genus(3, 5, 7),
                      0x1de6bd2efe9f7d54ULL},
          Fingerprint{"random(8, 0, 1)", families::random(8, 0, 1), 0x49701830b278af51ULL},
          Fingerprint{"random(1000, 0, 2)", families::random(1000, 0, 2), 0x83dd9b9e4f03f75ULL},
          Fingerprint{"random(300, 3, 18446744073709551615)",
                      families::random(300, 3, 18446744073709551615ULL), 0x3277c8628a485ba5ULL}}) {
        EXPECT_EQ(surface_hash(surface), hash)
            << name << std::hex << " 0x" << surface_hash(surface);
    }
}

// ---- sizes out of range ----

struct OutOfRange {
    const char* name;
    std::function<Triangulation()> make;
    const char* range;
};

void PrintTo(const OutOfRange& instance, std::ostream* out) {
    *out << instance.name;
}

class FamiliesOutOfRange : public ::testing::TestWithParam<OutOfRange> {};

TEST_P(FamiliesOutOfRange, AreRefusedAndTheRangeNamed) {
    try {
        static_cast<void>(GetParam().make());
        FAIL() << "was made";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr(GetParam().range));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, FamiliesOutOfRange,
    ::testing::Values(
        OutOfRange{"Book2", [] { return families::book(2); }, "at least 3"},
        OutOfRange{"BookNegative", [] { return families::book(-5); }, "at least 3"},
        OutOfRange{"BookHuge", [] { return families::book(most); }, "2^30"},
        OutOfRange{"DoubleWheel4", [] { return families::double_wheel(4); }, "at least 5"},
        OutOfRange{"DoubleWheelHuge", [] { return families::double_wheel(most); }, "2^30"},
        OutOfRange{"Stacked3", [] { return families::stacked(3, 0); }, "at least 4"},
        OutOfRange{"StackedHuge", [] { return families::stacked(most, 0); }, "2^30"},
        OutOfRange{"Prism2", [] { return families::prism(2); }, "k >= 3"},
        OutOfRange{"PrismHuge", [] { return families::prism(most); }, "tables"},
        OutOfRange{"Antiprism2", [] { return families::antiprism(2); }, "k >= 3"},
        OutOfRange{"AntiprismHuge", [] { return families::antiprism(most); }, "tables"},
        OutOfRange{"OctasphereMinus1", [] { return families::octasphere(-1); }, "0 <= level <= 12"},
        OutOfRange{"Octasphere13", [] { return families::octasphere(13); }, "0 <= level <= 12"},
        OutOfRange{"IcosphereMinus1", [] { return families::icosphere(-1); }, "0 <= level <= 12"},
        OutOfRange{"Icosphere13", [] { return families::icosphere(13); }, "0 <= level <= 12"},
        OutOfRange{"Torus2By3", [] { return families::torus_grid(2, 3); }, "at least 3 by 3"},
        OutOfRange{"Torus3By2", [] { return families::torus_grid(3, 2); }, "at least 3 by 3"},
        OutOfRange{"Torus3ByMinus3", [] { return families::torus_grid(3, -3); }, "at least 3 by 3"},
        OutOfRange{"TorusHuge", [] { return families::torus_grid(most, most); }, "2^30"},
        OutOfRange{"GenusNegative", [] { return families::surface_of_genus(-1, 9, 0); }, "genus 0"},
        OutOfRange{"Genus0Vertices3", [] { return families::surface_of_genus(0, 3, 0); },
                   "at least 4"},
        OutOfRange{"Genus1Vertices2", [] { return families::surface_of_genus(1, 2, 0); },
                   "at least 3"},
        OutOfRange{"GenusHuge", [] { return families::surface_of_genus(most, 9, 0); }, "2^30"},
        OutOfRange{"GenusAndSizeHuge", [] { return families::surface_of_genus(most, most, 0); },
                   "2^30"},
        OutOfRange{"RandomVertices3", [] { return families::random(3, 0, 0); }, "at least 4"},
        OutOfRange{"RandomGenus1Vertices2", [] { return families::random(2, 1, 0); }, "at least 3"},
        OutOfRange{"RandomGenusNegative", [] { return families::random(9, -1, 0); }, "genus 0"}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace tightflip::kernel
