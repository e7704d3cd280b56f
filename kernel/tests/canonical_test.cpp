#include "disguises.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

constexpr Equality oriented{Labels::ignored, Mirror::distinct};
constexpr Equality unoriented{Labels::ignored, Mirror::identified};
constexpr Equality labelled{Labels::kept, Mirror::distinct};
constexpr Equality labelled_unoriented{Labels::kept, Mirror::identified};
constexpr std::array<Equality, 4> equalities{oriented, unoriented, labelled, labelled_unoriented};

// ---- a second opinion: maps of sides of faces, one image at a time ----

/// Whether the map of sides that sends side 0 of `a` to `image` and is extended by the rules of an
/// isomorphism meets no contradiction. A mirrored map sends next to previous.
bool extends_naively(const Triangulation& a, const Triangulation& b, Halfedge image, bool mirrored,
                     bool keeps_labels) {
    std::map<Halfedge, Halfedge> map{{Halfedge{0}, image}};
    std::vector<Halfedge> pending{Halfedge{0}};
    while (!pending.empty()) {
        const Halfedge x = pending.back();
        pending.pop_back();
        const Halfedge y = map.at(x);
        if (keeps_labels && a.origin(x) != (mirrored ? b.target(y) : b.origin(y))) return false;
        for (const auto& [from, to] : {std::pair{a.next(x), mirrored ? b.previous(y) : b.next(y)},
                                       std::pair{twin(x), twin(y)}}) {
            const auto [known, is_new] = map.emplace(from, to);
            if (known->second != to) return false;
            if (is_new) pending.push_back(from);
        }
    }
    return true;
}

std::size_t isomorphisms(const Triangulation& a, const Triangulation& b, Equality equality) {
    if (a.halfedge_count() != b.halfedge_count()) return 0;
    std::size_t count = 0;
    for (Index h = 0; h < b.halfedge_count(); ++h) {
        for (const bool mirrored : {false, true}) {
            if (mirrored && equality.mirror == Mirror::distinct) continue;
            count +=
                extends_naively(a, b, {h}, mirrored, equality.labels == Labels::kept) ? 1U : 0U;
        }
    }
    return count;
}

/// One surface of each class that flips lead to, told apart by the second opinion.
std::vector<Triangulation> classes_from(const Triangulation& start, Equality equality) {
    std::vector<Triangulation> classes{start};
    for (std::size_t i = 0; i < classes.size(); ++i) {
        for (Index e = 0; e < start.edge_count(); ++e) {
            Triangulation flipped = classes[i];
            if (!flipped.flip({e})) continue;
            const bool is_known = std::ranges::any_of(classes, [&](const Triangulation& known) {
                return isomorphisms(known, flipped, equality) > 0;
            });
            if (!is_known) classes.push_back(flipped);
        }
    }
    return classes;
}

struct Family {
    const char* name;
    Triangulation start;
    std::size_t classes;
    std::size_t rooted;  ///< OEIS A000309 for the sphere
};
std::vector<Family> small_families() {
    return {{"SphereOf3", families::book(3), 1, 1},
            {"SphereOf4", families::book(4), 2, 4},
            {"SphereOf5", families::book(5), 4, 24},
            {"SphereOf6", families::book(6), 14, 176},
            {"TorusOf3", families::surface_of_genus(1, 3, 0), 1, 1},
            {"TorusOf4", families::surface_of_genus(1, 4, 0), 7, 51}};
}

/// Whether the map is what its description says.
void expect_isomorphism(const Triangulation& a, const Triangulation& b, const Isomorphism& map,
                        Equality equality) {
    const bool mirrored = map.handedness == Handedness::mirrored;
    EXPECT_FALSE(mirrored && equality.mirror == Mirror::distinct);
    ASSERT_EQ(map.halfedges.size(), a.table().size());
    ASSERT_EQ(map.vertices.size(), static_cast<std::size_t>(a.vertex_count()));
    EXPECT_EQ(std::set(map.halfedges.begin(), map.halfedges.end()).size(), b.table().size());
    EXPECT_EQ(std::set(map.vertices.begin(), map.vertices.end()).size(), map.vertices.size());
    for (Index i = 0; i < a.halfedge_count(); ++i) {
        const Halfedge h{i};
        const auto image = [&](Halfedge x) { return testing::nth(map.halfedges, x.id); };
        ASSERT_EQ(b.origin(image(h)), testing::nth(map.vertices, a.origin(h).id));
        ASSERT_EQ(image(twin(h)), twin(image(h)));
        ASSERT_EQ(image(a.next(h)), mirrored ? twin(b.previous(twin(image(h)))) : b.next(image(h)));
    }
    if (equality.labels == Labels::kept) {
        for (Index v = 0; v < a.vertex_count(); ++v)
            EXPECT_EQ(testing::nth(map.vertices, v).id, v);
    }
}

/// Surfaces alike in some meanings of equality and not in others.
std::vector<Triangulation> with_copies(const std::vector<Triangulation>& surfaces) {
    RandomStream random(11);
    std::vector<Triangulation> all;
    for (const Triangulation& surface : surfaces) {
        all.push_back(surface);
        all.push_back(testing::renumbered(surface, random));
        all.push_back(testing::mirrored(all.back()));
        all.push_back(testing::relabelled(surface, random));
        all.push_back(testing::renumbered(testing::mirrored(all.back()), random));
    }
    return all;
}

// ---- against the second opinion ----

class CanonicalOnSmallSurfaces : public ::testing::TestWithParam<Family> {};

TEST_P(CanonicalOnSmallSurfaces, CodesAreEqualExactlyWhereSurfacesAre) {
    const Family& family = GetParam();
    const std::vector<Triangulation> classes = classes_from(family.start, oriented);
    EXPECT_EQ(classes.size(), family.classes);
    const std::vector<Triangulation> surfaces = with_copies(classes);
    for (const Equality equality : equalities) {
        std::vector<CanonicalCode> codes;
        codes.reserve(surfaces.size());
        for (const Triangulation& surface : surfaces) {
            codes.push_back(canonical_code(surface, equality));
        }
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            for (std::size_t j = 0; j < surfaces.size(); ++j) {
                const bool equal = isomorphisms(surfaces[i], surfaces[j], equality) > 0;
                EXPECT_EQ(codes[i] == codes[j], equal) << i << " and " << j;
                EXPECT_EQ(digest(codes[i]) == digest(codes[j]), equal) << i << " and " << j;
            }
        }
    }
}

TEST_P(CanonicalOnSmallSurfaces, MapsAreIsomorphisms) {
    const std::vector<Triangulation> surfaces =
        with_copies(classes_from(GetParam().start, oriented));
    for (const Equality equality : equalities) {
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            for (std::size_t j = 0; j < surfaces.size(); ++j) {
                const auto map = isomorphism(surfaces[i], surfaces[j], equality);
                ASSERT_EQ(map.has_value(), isomorphisms(surfaces[i], surfaces[j], equality) > 0);
                if (map) expect_isomorphism(surfaces[i], surfaces[j], *map, equality);
            }
        }
    }
}

TEST_P(CanonicalOnSmallSurfaces, CountsAutomorphisms) {
    for (const Triangulation& surface : with_copies(classes_from(GetParam().start, oriented))) {
        for (const Equality equality : equalities) {
            EXPECT_EQ(automorphism_count(surface, equality),
                      isomorphisms(surface, surface, equality));
        }
    }
}

/// Orbit and stabiliser: a class has as many rooted surfaces as roots, divided by its symmetries.
TEST_P(CanonicalOnSmallSurfaces, RootedSurfacesAddUp) {
    const Family& family = GetParam();
    std::size_t rooted = 0;
    std::set<std::vector<Index>> words;
    for (const Triangulation& surface : classes_from(family.start, oriented)) {
        const auto roots = static_cast<std::size_t>(surface.halfedge_count());
        EXPECT_EQ(roots % automorphism_count(surface, oriented), 0U);
        rooted += roots / automorphism_count(surface, oriented);
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            words.insert(rooted_code(surface, {Halfedge{h}}, Labels::ignored));
        }
    }
    EXPECT_EQ(rooted, family.rooted);
    EXPECT_EQ(words.size(), family.rooted);
}

INSTANTIATE_TEST_SUITE_P(Sizes, CanonicalOnSmallSurfaces, ::testing::ValuesIn(small_families()),
                         [](const auto& instance) { return std::string(instance.param.name); });

// ---- symmetries that are known ----

TEST(Canonical, KnowsTheSymmetriesOfFamilies) {
    struct Case {
        const char* name;
        Triangulation surface;
        std::size_t rotations;
        std::size_t all;
    };
    const std::vector<Case> cases{
        {"two faces", families::book(3), 6, 12},
        {"tetrahedron", families::tetrahedron(), 12, 24},
        {"octahedron", families::octasphere(0), 24, 48},
        {"icosahedron", families::icosphere(0), 60, 120},
        {"octasphere", families::octasphere(3), 24, 48},
        {"icosphere", families::icosphere(2), 60, 120},
        {"book of four", families::book(4), 4, 8},
        {"book of twelve", families::book(12), 20, 40},
        {"double wheel of nine", families::double_wheel(9), 14, 28},
        {"seven-vertex torus (chiral)", build(testing::seven_vertex_torus()).value(), 42, 42},
        {"square torus", families::torus_grid(5, 5), 150, 300},
        {"oblong torus", families::torus_grid(5, 8), 80, 80}};
    for (const auto& [name, surface, rotations, all] : cases) {
        EXPECT_EQ(automorphism_count(surface, oriented), rotations) << name;
        EXPECT_EQ(automorphism_count(surface, unoriented), all) << name;
    }
}

TEST(Canonical, TellsChiralSurfacesFromTheirMirrorImages) {
    // Of 66 classes of spheres with seven vertices 54 are left when mirror images are identified.
    std::set<CanonicalCode> kept;
    std::set<CanonicalCode> identified;
    std::vector<Triangulation> pending{families::book(7)};
    std::size_t chiral = 0;
    while (!pending.empty()) {
        const Triangulation surface = pending.back();
        pending.pop_back();
        if (!kept.insert(canonical_code(surface, oriented)).second) continue;
        identified.insert(canonical_code(surface, unoriented));
        const Triangulation image = testing::mirrored(surface);
        const bool is_chiral = isomorphisms(surface, image, oriented) == 0;
        chiral += is_chiral ? 1U : 0U;
        EXPECT_EQ(canonical_code(surface, oriented) != canonical_code(image, oriented), is_chiral);
        EXPECT_EQ(canonical_code(surface, unoriented), canonical_code(image, unoriented));
        EXPECT_EQ(automorphism_count(surface, unoriented),
                  (is_chiral ? 1 : 2) * automorphism_count(surface, oriented));
        for (Index e = 0; e < surface.edge_count(); ++e) {
            pending.push_back(surface);
            if (!pending.back().flip({e})) pending.pop_back();
        }
    }
    EXPECT_EQ(kept.size(), 66U);
    EXPECT_EQ(identified.size(), 54U);
    EXPECT_EQ(chiral, 24U);
}

// ---- labelled codes ----

TEST(Canonical, LabelledCodesAgreeWithEqualityOfLabelledSurfaces) {
    std::vector<Triangulation> surfaces;
    for (const Triangulation& start :
         {families::book(5), families::random(4, 1, 3), families::surface_of_genus(2, 3, 0)}) {
        for (const Triangulation& surface : classes_from(start, labelled)) {
            surfaces.push_back(surface);
            if (surfaces.size() % 4 == 0) surfaces.push_back(testing::mirrored(surface));
        }
    }
    EXPECT_GT(surfaces.size(), 160U);
    RandomStream random(5);
    std::vector<CanonicalCode> codes;
    codes.reserve(surfaces.size());
    for (const Triangulation& surface : surfaces) {
        codes.push_back(canonical_code(testing::renumbered(surface, random), labelled));
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        for (std::size_t j = 0; j < surfaces.size(); ++j) {
            EXPECT_EQ(codes[i] == codes[j], same_labelled_surface(surfaces[i], surfaces[j]));
        }
    }
}

// ---- values ----

TEST(Canonical, CodesSayWhatTheyAreOf) {
    const Triangulation sphere = families::book(3);
    const CanonicalCode code = canonical_code(sphere, oriented);
    EXPECT_EQ(code.vertex_count(), 3);
    EXPECT_EQ(code.equality(), oriented);
    EXPECT_EQ(to_string(code), "0 5 4");
    EXPECT_EQ(to_string(CanonicalCode{}), "");

    std::set<CanonicalCode> codes{CanonicalCode{}};
    std::set<std::uint64_t> digests{digest(CanonicalCode{})};
    std::unordered_set<CanonicalCode> hashed{CanonicalCode{}};
    for (const Equality equality : equalities) {
        codes.insert(canonical_code(sphere, equality));
        digests.insert(digest(canonical_code(sphere, equality)));
        hashed.insert(canonical_code(sphere, equality));
    }
    EXPECT_EQ(codes.size(), 5U) << "codes for different meanings of equality differ";
    EXPECT_EQ(digests.size(), 5U);
    EXPECT_EQ(hashed.size(), 5U);
}

TEST(Canonical, SurfacesOfOneSizeAndCodeLengthMayDifferInGenus) {
    const Triangulation sphere = families::book(9);
    const Triangulation torus = families::random(7, 1, 1);
    ASSERT_EQ(sphere.halfedge_count(), torus.halfedge_count());
    EXPECT_NE(canonical_code(sphere, oriented), canonical_code(torus, oriented));
    EXPECT_FALSE(isomorphism(sphere, torus, oriented));
}

// ---- back to surfaces ----

TEST(Canonical, CodesLeadBackToTheSurface) {
    std::vector<Triangulation> surfaces = classes_from(families::book(6), oriented);
    for (const Triangulation& more :
         {families::book(3), families::random(50, 0, 1), families::random(20, 3, 2),
          families::surface_of_genus(3, 3, 1), families::torus_grid(6, 6), families::book(40)}) {
        surfaces.push_back(more);
    }
    RandomStream random(8);
    for (const Triangulation& plain : surfaces) {
        const Triangulation surface =
            testing::renumbered(testing::relabelled(plain, random), random);
        for (const Equality equality : equalities) {
            const CanonicalCode code = canonical_code(surface, equality);
            const Triangulation decoded = surface_of(code);
            EXPECT_EQ(canonical_code(decoded, equality), code);
            const auto spelled = rooted_code(decoded, {Halfedge{0}}, equality.labels);
            EXPECT_TRUE(std::ranges::equal(spelled, code.symbols())) << "halfedge 0 is the root";
            EXPECT_TRUE(isomorphism(surface, decoded, equality));
            if (equality == labelled) {
                EXPECT_TRUE(same_labelled_surface(decoded, surface));
            }
        }
    }
}

TEST(Canonical, RefusesWordsThatAreNoSurface) {
    struct Case {
        std::vector<Index> symbols;
        Labels labels;
    };
    const std::vector<Case> cases{{{}, Labels::ignored},
                                  {{0, 5, 5}, Labels::ignored},
                                  {{0, 4, 5}, Labels::ignored},  // the torus of one vertex: loops
                                  {{1, 0, 5}, Labels::ignored},  // a sphere with a loop
                                  {{}, Labels::kept},
                                  {{0, 1, 2}, Labels::kept},
                                  {{0, 5, 4}, Labels::kept},
                                  {{0, 1, 2, 0, 2, 5}, Labels::kept},
                                  {{0, 1, 2, 0}, Labels::kept},
                                  {{0, 1, 2, 0, 1, 5, 4}, Labels::kept},
                                  {{0, 1, 3, 0, 3, 5, 4}, Labels::kept},
                                  {{0, 1, 1, 0, 1, 5, 4}, Labels::kept},
                                  {{0, -1, 2, 0, 2, 5, 4}, Labels::kept}};
    for (const auto& [symbols, labels] : cases) {
        EXPECT_THROW(static_cast<void>(surface_of(symbols, labels)), std::invalid_argument)
            << ::testing::PrintToString(symbols);
    }
    EXPECT_THROW(static_cast<void>(surface_of(CanonicalCode{})), std::invalid_argument);
    const std::vector<Index> right{0, 1, 2, 0, 2, 5, 4};
    EXPECT_TRUE(same_labelled_surface(surface_of(right, Labels::kept), families::book(3)));
}

// ---- large ----

TEST(Canonical, LargeSurfacesUnderOtherNumbersAreEqual) {
    RandomStream random(9);
    for (const Triangulation& surface :
         {families::random(20000, 0, 4), families::random(5000, 50, 4), families::stacked(20000, 4),
          families::icosphere(5)}) {
        const Triangulation other =
            testing::relabelled(testing::renumbered(surface, random), random);
        const auto map = isomorphism(surface, other, oriented);
        ASSERT_TRUE(map.has_value());
        expect_isomorphism(surface, other, *map, oriented);
        Triangulation flipped = other;
        Index e = 0;
        while (!flipped.flip({e}))
            ++e;
        EXPECT_NE(canonical_code(surface, oriented), canonical_code(flipped, oriented));
    }
}

}  // namespace
}  // namespace tightflip::kernel
