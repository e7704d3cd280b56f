#include "disguises.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <vector>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using testing::mirrored;
using testing::records_of;
using testing::renumbered;
using testing::with_labels;

/// A second opinion on equality: the least of the words that walks over the surface spell, one walk
/// from every halfedge; a walk numbers halfedges in the order in which it meets them.
std::vector<Index> least_word(const Triangulation& surface) {
    const auto records = records_of(surface);
    std::vector<Index> least;
    for (Index start = 0; start < surface.halfedge_count(); ++start) {
        std::map<Index, Index> number{{start, 0}};
        std::vector<Index> met{start};
        std::vector<Index> word;
        for (std::size_t i = 0; i < met.size(); ++i) {
            const auto& [next, origin] = testing::nth(records, met[i]);
            word.push_back(origin.id);
            for (const Index neighbour : {next.id, met[i] ^ 1}) {
                const auto count = static_cast<Index>(number.size());
                if (number.emplace(neighbour, count).second) met.push_back(neighbour);
                word.push_back(number.at(neighbour));
            }
        }
        if (least.empty() || word < least) least = word;
    }
    return least;
}

/// The same face list, its sides sewn together at random among those that labels allow.
Gluing with_sides_resewn(Gluing gluing, RandomStream& random) {
    std::map<std::pair<Index, Index>, std::vector<Index>> sides;
    for (Index s = 0; s < testing::side_count(gluing); ++s) {
        sides[{testing::start_of(gluing, s), testing::end_of(gluing, s)}].push_back(s);
    }
    for (auto& [ends, there] : sides) {
        if (ends.first > ends.second) continue;
        random.shuffle(std::span(there));
        const auto& back = sides.at({ends.second, ends.first});
        for (std::size_t i = 0; i < there.size(); ++i)
            testing::join(gluing, there[i], back[i]);
    }
    return gluing;
}

std::multiset<std::array<Index, 3>> face_list(const Gluing& gluing) {
    std::multiset<std::array<Index, 3>> faces;
    for (const GluedFace& face : gluing.faces) {
        auto corners = face.corners;
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        faces.insert(corners);
    }
    return faces;
}

/// Valid surfaces among those with the face list of `surface`.
std::vector<Triangulation> other_gluings(const Triangulation& surface, int attempts) {
    const Gluing gluing = read_table(surface.table(), surface.vertex_count()).gluing;
    RandomStream random(42);
    std::vector<Triangulation> others;
    for (; attempts > 0; --attempts) {
        const Gluing resewn = with_sides_resewn(gluing, random);
        EXPECT_EQ(face_list(resewn), face_list(gluing));
        if (auto built = build(resewn)) others.push_back(std::move(built).value());
    }
    return others;
}

std::vector<Triangulation> samples() {
    std::vector<Triangulation> surfaces{
        families::book(3),          families::tetrahedron(),
        families::book(9),          families::double_wheel(7),
        families::torus_grid(3, 4), families::antiprism(5),
        families::octasphere(1),    families::surface_of_genus(2, 3, 1)};
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        surfaces.push_back(families::random(7, 0, seed));
        surfaces.push_back(families::random(4, 1, seed));
        surfaces.push_back(families::random(5, 3, seed));
    }
    return surfaces;
}

// ---- what does not matter ----

TEST(SurfaceEquality, NumbersOfHalfedgesDoNotMatter) {
    RandomStream random(7);
    for (const Triangulation& surface : samples()) {
        EXPECT_TRUE(same_labelled_surface(surface, surface));
        for (int run = 0; run < 10; ++run) {
            const Triangulation other = renumbered(surface, random);
            EXPECT_TRUE(same_labelled_surface(surface, other));
            EXPECT_TRUE(same_labelled_surface(other, surface));
            EXPECT_EQ(surface_hash(surface), surface_hash(other));
        }
    }
    const Triangulation large = families::random(2000, 5, 1);
    const Triangulation other = renumbered(large, random);
    EXPECT_NE(large, other);
    EXPECT_TRUE(same_labelled_surface(large, other));
    EXPECT_EQ(surface_hash(large), surface_hash(other));
}

TEST(SurfaceEquality, TheOrderOfFacesAndTheirFirstCornersDoNotMatter) {
    RandomStream random(8);
    testing::FaceList faces = testing::octahedron_faces();
    const Triangulation surface = build(faces, 6).value();
    for (int run = 0; run < 20; ++run) {
        random.shuffle(std::span(faces));
        for (auto& corners : faces) {
            std::rotate(corners.begin(), corners.begin() + random.below(3), corners.end());
        }
        const Triangulation other = build(faces, 6).value();
        EXPECT_TRUE(same_labelled_surface(surface, other));
        EXPECT_EQ(surface_hash(surface), surface_hash(other));
    }
}

TEST(SurfaceEquality, FourFlipsGiveTheTableAndTwoTheSurface) {
    for (const Triangulation& surface : samples()) {
        for (Index e = 0; e < surface.edge_count(); ++e) {
            Triangulation flipped = surface;
            if (!flipped.flip({e})) continue;
            EXPECT_FALSE(same_labelled_surface(surface, flipped)) << "edge " << e;
            EXPECT_NE(surface_hash(surface), surface_hash(flipped)) << "edge " << e;
            ASSERT_TRUE(flipped.flip({e}));
            EXPECT_NE(surface, flipped) << "twice exchanges the halves of edge " << e;
            EXPECT_TRUE(same_labelled_surface(surface, flipped)) << "edge " << e;
            EXPECT_EQ(surface_hash(surface), surface_hash(flipped)) << "edge " << e;
            ASSERT_TRUE(flipped.flip({e}));
            EXPECT_FALSE(same_labelled_surface(surface, flipped)) << "edge " << e;
            ASSERT_TRUE(flipped.flip({e}));
            EXPECT_EQ(surface, flipped) << "edge " << e;
        }
    }
}

// ---- what does ----

TEST(SurfaceEquality, AMirrorImageIsAnotherSurface) {
    for (const Triangulation& surface : {families::tetrahedron(), families::icosphere(0),
                                         families::torus_grid(3, 3), families::random(9, 0, 3)}) {
        const Triangulation image = mirrored(surface);
        EXPECT_FALSE(same_labelled_surface(surface, image));
        EXPECT_FALSE(same_labelled_surface(image, surface));
        EXPECT_NE(surface_hash(surface), surface_hash(image));
        EXPECT_TRUE(same_labelled_surface(surface, mirrored(image)));
    }
}

TEST(SurfaceEquality, TheTwoFaceSphereIsItsOwnMirrorImage) {
    const Triangulation sphere = families::book(3);
    EXPECT_TRUE(same_labelled_surface(sphere, mirrored(sphere)));
    EXPECT_EQ(surface_hash(sphere), surface_hash(mirrored(sphere)));
}

TEST(SurfaceEquality, LabelsMatter) {
    const Triangulation tetrahedron = families::tetrahedron();
    std::vector<Index> label{0, 1, 2, 3};
    do {
        // Even permutations turn the tetrahedron, odd ones mirror it.
        int inversions = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < i; ++j)
                inversions += label[j] > label[i] ? 1 : 0;
        }
        EXPECT_EQ(same_labelled_surface(tetrahedron, with_labels(tetrahedron, label)),
                  inversions % 2 == 0);
    } while (std::ranges::next_permutation(label).found);

    const Triangulation wheel = families::double_wheel(8);
    const Triangulation swapped = with_labels(wheel, {0, 1, 3, 2, 4, 5, 6, 7});
    EXPECT_FALSE(same_labelled_surface(wheel, swapped));
    EXPECT_NE(surface_hash(wheel), surface_hash(swapped));
}

TEST(SurfaceEquality, SizesMatter) {
    const std::vector<Triangulation> surfaces{families::book(3),
                                              families::tetrahedron(),
                                              families::book(5),
                                              families::torus_grid(3, 3),
                                              families::surface_of_genus(1, 3, 0),
                                              families::surface_of_genus(2, 3, 0)};
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        for (std::size_t j = 0; j < surfaces.size(); ++j) {
            EXPECT_EQ(same_labelled_surface(surfaces[i], surfaces[j]), i == j);
            EXPECT_EQ(surface_hash(surfaces[i]) == surface_hash(surfaces[j]), i == j);
        }
    }
}

TEST(SurfaceEquality, TheOrderOfThePagesOfABookMattersButForTurningIt) {
    const Triangulation book = families::book(6);  // pages 2, 3, 4, 5
    EXPECT_TRUE(same_labelled_surface(book, with_labels(book, {0, 1, 3, 4, 5, 2})));
    EXPECT_FALSE(same_labelled_surface(book, with_labels(book, {0, 1, 3, 2, 4, 5})));
    EXPECT_TRUE(same_labelled_surface(book, with_labels(book, {1, 0, 5, 4, 3, 2})));
    EXPECT_FALSE(same_labelled_surface(book, with_labels(book, {1, 0, 2, 3, 4, 5})));
}

/// On the sphere from five vertices and a triple edge on, on the torus with double edges: the
/// faces are the same as triples of labels, the surfaces are not.
TEST(SurfaceEquality, TellsGluingsOfOneFaceListApart) {
    struct Case {
        const char* name;
        Triangulation surface;
        Index max_multiplicity;
    };
    for (const auto& [name, surface, multiplicity] :
         {Case{"book of three pages", families::book(5), 3},
          Case{"book of five pages", families::book(7), 5},
          Case{"torus with double edges", families::random(4, 1, 12), 2},
          Case{"torus with fourfold edges", families::random(5, 1, 1), 4}}) {
        EXPECT_EQ(audit(surface).parallels.value().max_multiplicity, multiplicity) << name;
        std::size_t different = 0;
        for (const Triangulation& other : other_gluings(surface, 300)) {
            const bool same = least_word(surface) == least_word(other);
            EXPECT_EQ(same_labelled_surface(surface, other), same) << name;
            EXPECT_EQ(surface_hash(surface) == surface_hash(other), same) << name;
            different += same ? 0U : 1U;
        }
        EXPECT_GT(different, 0U) << name;
    }
}

TEST(SurfaceEquality, ADoubleEdgeOnTheSphereDeterminesTheGluing) {
    const Triangulation book = families::book(4);
    const auto others = other_gluings(book, 50);
    EXPECT_FALSE(others.empty());
    for (const Triangulation& other : others)
        EXPECT_TRUE(same_labelled_surface(book, other));
}

// ---- against the second opinion ----

TEST(SurfaceEquality, AgreesWithTheSecondOpinionWhereFewLabelsHelp) {
    // With three or four vertices nearly every halfedge looks like many others.
    std::map<std::pair<Index, Index>, std::vector<Triangulation>> by_size;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        for (const Index genus : {1, 2}) {
            const Triangulation grown = families::random(4, genus, seed);
            by_size[{genus, 4}].push_back(grown);
            by_size[{genus, 4}].push_back(mirrored(grown));
        }
    }
    // Of genus 2 with three vertices there are classes that no flip joins; sewing finds them.
    for (const Index genus : {1, 2}) {
        by_size[{genus, 3}] = other_gluings(families::surface_of_genus(genus, 3, 0), 2000);
    }
    std::size_t same = 0;
    std::size_t different = 0;
    for (const auto& [size, surfaces] : by_size) {
        std::vector<std::vector<Index>> words;
        for (const Triangulation& surface : surfaces)
            words.push_back(least_word(surface));
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const bool expected = words[i] == words[j];
                ++(expected ? same : different);
                EXPECT_EQ(same_labelled_surface(surfaces[i], surfaces[j]), expected);
                if (expected) {
                    EXPECT_EQ(surface_hash(surfaces[i]), surface_hash(surfaces[j]));
                }
            }
        }
    }
    EXPECT_GT(same, 100U);
    EXPECT_GT(different, 100U);
}

// ---- exhaustively ----

/// Every labelled oriented sphere that flips lead to, kept apart by hash and equality.
class Reached {
public:
    explicit Reached(const Triangulation& start) {
        add(start);
        constexpr std::size_t most = 10000;  // where equality fails there is no end
        for (std::size_t i = 0; i < all.size() && all.size() < most; ++i) {
            Index flippable = 0;
            for (Index e = 0; e < start.edge_count(); ++e) {
                Triangulation flipped = all[i];
                if (!flipped.flip({e})) continue;
                ++flippable;
                add(flipped);
            }
            flippable_edges.insert(flippable);
        }
    }
    std::vector<Triangulation> all;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> by_hash;
    std::multiset<Index> flippable_edges;

private:
    void add(const Triangulation& surface) {
        auto& alike = by_hash[surface_hash(surface)];
        for (const std::size_t i : alike) {
            if (same_labelled_surface(all[i], surface)) return;
        }
        alike.push_back(all.size());
        all.push_back(surface);
    }
};

struct Count {
    Index vertices;
    std::size_t surfaces;
};
class SurfaceEqualityOnAllSpheres : public ::testing::TestWithParam<Count> {};

/// The counts are those of rooted loopless triangulations (OEIS A000309) times V! / (6 (V - 2)):
/// labels leave no automorphism.
TEST_P(SurfaceEqualityOnAllSpheres, CountsThemRight) {
    const auto [vertices, surfaces] = GetParam();
    const Reached reached(families::book(vertices));
    EXPECT_EQ(reached.all.size(), surfaces);
    EXPECT_EQ(reached.by_hash.size(), surfaces) << "no two have the same hash";

    std::set<std::vector<Index>> words;
    for (const Triangulation& surface : reached.all)
        words.insert(least_word(surface));
    EXPECT_EQ(words.size(), surfaces) << "the second opinion";

    // Observed, not proved: the book has the fewest flippable edges, simple spheres have all.
    EXPECT_EQ(*reached.flippable_edges.begin(), vertices - 2);
    EXPECT_EQ(*reached.flippable_edges.rbegin(), 3 * (vertices - 2));
}

INSTANTIATE_TEST_SUITE_P(Sizes, SurfaceEqualityOnAllSpheres,
                         ::testing::Values(Count{4, 8}, Count{5, 160}, Count{6, 5280}),
                         [](const auto& instance) {
                             return std::to_string(instance.param.vertices) + "Vertices";
                         });

TEST(SurfaceEqualityOnTori, TwoStartsReachTheSameSurfaces) {
    const Reached one(families::surface_of_genus(1, 4, 1));
    const Reached other(families::random(4, 1, 99));
    EXPECT_GT(one.all.size(), 1U);
    EXPECT_EQ(one.all.size(), other.all.size());
    std::set<std::vector<Index>> words;
    for (const Triangulation& surface : one.all)
        words.insert(least_word(surface));
    EXPECT_EQ(words.size(), one.all.size());
    for (const Triangulation& surface : other.all)
        EXPECT_TRUE(words.contains(least_word(surface)));
}

}  // namespace
}  // namespace tightflip::kernel
