#include "random_gluings.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <unordered_set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::ElementsAre;
using testing::RandomGluings;

static_assert(std::forward_iterator<Star::iterator>);
static_assert(std::forward_iterator<Link::iterator>);
static_assert(std::forward_iterator<Neighbours::iterator>);
static_assert(std::forward_iterator<FaceSides::iterator>);
static_assert(std::forward_iterator<FaceCorners::iterator>);
static_assert(std::is_same_v<std::iter_value_t<Star::iterator>, Halfedge>);
static_assert(std::is_same_v<std::iter_value_t<Link::iterator>, Halfedge>);
static_assert(std::is_same_v<std::iter_value_t<Neighbours::iterator>, Vertex>);
static_assert(std::is_same_v<std::iter_value_t<FaceSides::iterator>, Halfedge>);
static_assert(std::is_same_v<std::iter_value_t<FaceCorners::iterator>, Vertex>);
static_assert(!std::is_convertible_v<Vertex, Halfedge> && !std::is_convertible_v<Edge, Halfedge>);

template <class Range>
auto listed(const Range& range) {
    using Iterator = decltype(range.begin());
    return std::vector<typename Iterator::value_type>(range.begin(), range.end());
}

Triangulation surface(const Gluing& gluing) {
    return build(gluing).value();
}

std::vector<Triangulation> surfaces() {
    std::vector<Triangulation> all;
    for (const Gluing& gluing :
         {testing::two_face_sphere(), testing::tetrahedron(), testing::book(3),
          testing::octahedron(), testing::torus_grid(), testing::seven_vertex_torus()}) {
        all.push_back(surface(gluing));
    }
    RandomGluings random(5);
    for (int k = 0; k < 50; ++k)
        all.push_back(surface(random.flipped()));
    return all;
}

std::vector<Halfedge> halfedges(const Triangulation& s) {
    std::vector<Halfedge> all;
    for (Index h = 0; h < s.halfedge_count(); ++h)
        all.push_back({h});
    return all;
}

// ---- handles ----

TEST(Handles, GoFromHalfedgesToEdgesAndBack) {
    static_assert(twin(Halfedge{6}) == Halfedge{7} && twin(Halfedge{7}) == Halfedge{6});
    static_assert(edge_of(Halfedge{6}) == Edge{3} && edge_of(Halfedge{7}) == Edge{3});
    static_assert(halfedge_of(Edge{3}) == Halfedge{6});
    static_assert(!Vertex{}.is_valid() && Vertex{0}.is_valid());
    EXPECT_LT(Vertex{1}, Vertex{2});
    EXPECT_EQ((std::unordered_set<Edge>{{1}, {2}, {1}}.size()), 2U);
}

// ---- counts and navigation ----

TEST(Triangulation, CountsItsParts) {
    const Triangulation book = surface(testing::book(3));
    EXPECT_EQ(book.vertex_count(), 5);
    EXPECT_EQ(book.edge_count(), 9);
    EXPECT_EQ(book.halfedge_count(), 18);
    EXPECT_EQ(book.face_count(), 6);
    EXPECT_EQ(book.euler_characteristic(), 2);
    EXPECT_EQ(book.genus(), 0);
    const Triangulation torus = surface(testing::seven_vertex_torus());
    EXPECT_EQ(torus.euler_characteristic(), 0);
    EXPECT_EQ(torus.genus(), 1);
}

TEST(Triangulation, NavigatesAsItsTableSays) {
    for (const Triangulation& s : surfaces()) {
        for (const Halfedge h : halfedges(s)) {
            EXPECT_EQ(s.next(h), at(s.table(), h).next);
            EXPECT_EQ(s.origin(h), at(s.table(), h).origin);
            EXPECT_EQ(s.next(s.previous(h)), h);
            EXPECT_EQ(s.previous(s.next(h)), h);
            EXPECT_EQ(s.target(h), s.origin(s.next(h)));
            EXPECT_EQ(s.target(h), s.origin(twin(h)));
            const std::set<Vertex> corners{s.origin(h), s.target(h), s.opposite(h)};
            EXPECT_EQ(corners.size(), 3U);
        }
    }
}

TEST(Triangulation, WalksRoundAFace) {
    for (const Triangulation& s : surfaces()) {
        for (const Halfedge h : halfedges(s)) {
            EXPECT_THAT(listed(s.face_sides(h)), ElementsAre(h, s.next(h), s.previous(h)));
            EXPECT_THAT(listed(s.face_corners(h)),
                        ElementsAre(s.origin(h), s.target(h), s.opposite(h)));
        }
    }
}

TEST(Triangulation, TurnsOnceAboutAVertexCounterClockwise) {
    for (const Triangulation& s : surfaces()) {
        for (const Halfedge h : halfedges(s)) {
            std::vector<Halfedge> leaving;
            for (const Halfedge x : halfedges(s)) {
                if (s.origin(x) == s.origin(h)) leaving.push_back(x);
            }
            const std::vector<Halfedge> star = listed(s.star(h));
            const std::vector<Halfedge> link = listed(s.link(h));
            const std::vector<Vertex> neighbours = listed(s.neighbours(h));
            EXPECT_EQ(star.front(), h);
            EXPECT_THAT(star, ::testing::UnorderedElementsAreArray(leaving));
            ASSERT_EQ(link.size(), star.size());
            ASSERT_EQ(neighbours.size(), star.size());
            EXPECT_EQ(s.degree(h), static_cast<Index>(star.size()));
            for (std::size_t k = 0; k < star.size(); ++k) {
                const std::size_t after = (k + 1) % star.size();
                EXPECT_EQ(neighbours[k], s.target(star[k]));
                EXPECT_EQ(link[k], s.next(star[k]));
                // Counter-clockwise, the link runs from each neighbour to the following one.
                EXPECT_EQ(s.origin(link[k]), neighbours[k]);
                EXPECT_EQ(s.target(link[k]), neighbours[after]);
            }
        }
    }
}

TEST(Triangulation, ComesToAParallelNeighbourOnceForEachEdge) {
    const Triangulation book = surface(testing::book(3));
    for (const Halfedge h : book.outgoing()) {
        const std::vector<Vertex> neighbours = listed(book.neighbours(h));
        const Vertex other{1 - book.origin(h).id};
        if (book.origin(h).id > 1) {
            EXPECT_EQ(book.degree(h), 2);
        } else {
            EXPECT_EQ(std::ranges::count(neighbours, other), 3);
        }
    }
}

TEST(Triangulation, GivesIteratorsThatPassTwiceAndInTwoStyles) {
    const Triangulation s = surface(testing::octahedron());
    const Star star = s.star({0});
    auto slow = star.begin();
    const auto copy = slow;
    EXPECT_EQ(*slow++, Halfedge{0});
    EXPECT_NE(slow, copy);
    auto fast = copy;
    EXPECT_EQ(++fast, slow);
    EXPECT_EQ(*fast, *slow);
    EXPECT_EQ(std::distance(star.begin(), star.end()), 4);
    EXPECT_EQ(std::distance(star.begin(), star.end()), 4);
    EXPECT_NE(star.begin(), star.end());
    EXPECT_EQ(Star::iterator(), Star::iterator());
}

TEST(Triangulation, ListsOneHalfedgeOfEachVertexAndEachFace) {
    for (const Triangulation& s : surfaces()) {
        const std::vector<Halfedge> outgoing = s.outgoing();
        ASSERT_EQ(outgoing.size(), static_cast<std::size_t>(s.vertex_count()));
        for (Index v = 0; v < s.vertex_count(); ++v) {
            EXPECT_EQ(s.origin(testing::nth(outgoing, v)), Vertex{v});
        }
        const std::vector<Halfedge> faces = s.faces();
        EXPECT_TRUE(std::ranges::is_sorted(faces));
        std::set<Halfedge> covered;
        for (const Halfedge h : faces) {
            for (const Halfedge side : s.face_sides(h)) {
                EXPECT_GE(side, h);
                EXPECT_TRUE(covered.insert(side).second);
            }
        }
        EXPECT_EQ(covered.size(), s.table().size());
        EXPECT_EQ(faces.size(), static_cast<std::size_t>(s.face_count()));
    }
}

TEST(Triangulation, LeavesOtherVerticesOutgoingHalfedgesFreshAfterAFlip) {
    Triangulation s = surface(testing::octahedron());
    const std::vector<Halfedge> before = s.outgoing();
    for (Index e = 0; e < s.edge_count(); ++e) {
        Triangulation flipped = s;
        if (!flipped.flip({e})) continue;
        for (Index v = 0; v < s.vertex_count(); ++v) {
            const Halfedge h = testing::nth(before, v);
            EXPECT_EQ(flipped.origin(h) == Vertex{v}, edge_of(h) != Edge{e});
        }
    }
}

// ---- misuse ----

TEST(Triangulation, RefusesHandlesThatDoNotExist) {
    Triangulation s = surface(testing::tetrahedron());
    const Triangulation before = s;
    constexpr Index lowest = std::numeric_limits<Index>::min();
    constexpr Index highest = std::numeric_limits<Index>::max();
    for (const Halfedge h :
         {Halfedge{}, Halfedge{12}, Halfedge{13}, Halfedge{lowest}, Halfedge{highest}}) {
        const std::vector<std::function<void()>> uses{
            [&] { static_cast<void>(s.next(h)); },
            [&] { static_cast<void>(s.previous(h)); },
            [&] { static_cast<void>(s.origin(h)); },
            [&] { static_cast<void>(s.target(h)); },
            [&] { static_cast<void>(s.opposite(h)); },
            [&] { static_cast<void>(s.star(h)); },
            [&] { static_cast<void>(s.link(h)); },
            [&] { static_cast<void>(s.neighbours(h)); },
            [&] { static_cast<void>(s.face_sides(h)); },
            [&] { static_cast<void>(s.face_corners(h)); },
            [&] { static_cast<void>(s.degree(h)); },
        };
        for (std::size_t k = 0; k < uses.size(); ++k) {
            EXPECT_THROW(uses[k](), std::out_of_range) << "halfedge " << h.id << ", use " << k;
        }
    }
    for (const Edge e : {Edge{}, Edge{6}, Edge{7}, Edge{12}, Edge{lowest}, Edge{highest}}) {
        EXPECT_THROW(static_cast<void>(s.can_flip(e)), std::out_of_range) << e.id;
        EXPECT_THROW(static_cast<void>(s.flip(e)), std::out_of_range) << e.id;
        EXPECT_THROW(static_cast<void>(s.unflip(e)), std::out_of_range) << e.id;
    }
    EXPECT_EQ(s, before);
    EXPECT_NO_THROW(static_cast<void>(s.next({11})));
    EXPECT_NO_THROW(static_cast<void>(s.can_flip({5})));
}

TEST(Triangulation, SaysWhichHandleDoesNotExist) {
    const Triangulation s = surface(testing::tetrahedron());
    const auto thrown_by = [](const auto& use) {
        try {
            use();
        } catch (const std::out_of_range& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(thrown_by([&] { static_cast<void>(s.next({77})); }),
                ::testing::AllOf(::testing::HasSubstr("halfedge 77"), ::testing::HasSubstr("12")));
    EXPECT_THAT(thrown_by([&] { static_cast<void>(s.can_flip({-1})); }),
                ::testing::AllOf(::testing::HasSubstr("edge -1"), ::testing::HasSubstr("6")));
}

// ---- flips ----

TEST(Triangulation, FlipsAndUnflipsItsTable) {
    for (const Triangulation& start : surfaces()) {
        for (Index e = 0; e < start.edge_count(); ++e) {
            Triangulation s = start;
            std::vector<HalfedgeRecord> table(start.table().begin(), start.table().end());
            const FlipVerdict verdict = s.flip({e});
            EXPECT_EQ(verdict, start.can_flip({e}));
            EXPECT_EQ(verdict, flip(MutableHalfedgeTable(table), Edge{e}));
            EXPECT_TRUE(std::ranges::equal(s.table(), table));
            EXPECT_TRUE(audit(s).is_valid());
            static_cast<void>(s.unflip({e}));
            EXPECT_EQ(s, start);
        }
    }
}

TEST(Triangulation, FlipsAListAsItWouldOneByOne) {
    RandomGluings random(99);
    std::size_t refused = 0;
    for (int run = 0; run < 300; ++run) {
        const Triangulation start = surface(random.flipped());
        std::vector<Edge> list(static_cast<std::size_t>(random.below(200)));
        // Few distinct edges, so that the list comes back to them while they are being prefetched.
        for (Edge& e : list)
            e = {random.below(1 + random.below(start.edge_count()))};
        Triangulation one_by_one = start;
        std::size_t flipped = 0;
        for (const Edge e : list)
            flipped += one_by_one.flip(e) ? 1 : 0;
        Triangulation at_once = start;
        EXPECT_EQ(at_once.flip_all(list), flipped);
        EXPECT_EQ(at_once, one_by_one);
        refused += list.size() - flipped;
    }
    EXPECT_GT(refused, 100U);
}

TEST(Triangulation, FlipsNothingOfAListThatNamesAnEdgeThatDoesNotExist) {
    Triangulation s = surface(testing::octahedron());
    const Triangulation before = s;
    for (const Index bad : {-1, 12, 1000000}) {
        EXPECT_THROW(s.flip_all(std::vector<Edge>{{0}, {5}, {7}, {bad}}), std::out_of_range);
        EXPECT_THROW(s.flip_all(std::vector<Edge>{{bad}, {0}}), std::out_of_range);
        EXPECT_EQ(s, before);
    }
    EXPECT_EQ(s.flip_all({}), 0U);
    EXPECT_EQ(s, before);
}

// ---- a value ----

TEST(Triangulation, IsCopiedIndependently) {
    const Triangulation original = surface(testing::octahedron());
    Triangulation copy = original;
    EXPECT_EQ(copy, original);
    ASSERT_TRUE(copy.flip({3}));
    EXPECT_NE(copy, original);
    EXPECT_EQ(original, surface(testing::octahedron()));
    copy = original;
    EXPECT_EQ(copy, original);
    const Triangulation moved = std::move(copy);
    EXPECT_EQ(moved, original);
}

TEST(Triangulation, IsEqualOnlyWhereHandlesMeanTheSame) {
    const Triangulation original = surface(testing::octahedron());
    Triangulation twice = original;
    ASSERT_TRUE(twice.flip({3}));
    ASSERT_TRUE(twice.flip({3}));
    EXPECT_NE(twice, original) << "the same surface, with the halfedges of an edge exchanged";
    EXPECT_NE(surface(testing::tetrahedron()), original);
}

TEST(Triangulation, HashesConsistentlyWithEquality) {
    const std::hash<Triangulation> hash;
    EXPECT_EQ(hash(surface(testing::octahedron())), hash(surface(testing::octahedron())));
    EXPECT_NE(hash(surface(testing::tetrahedron())),
              hash(surface(testing::relabelled(testing::tetrahedron(), {1, 0, 2, 3}, 4))));
    Triangulation walking = surface(testing::seven_vertex_torus());
    std::unordered_set<Triangulation> tables;
    std::set<std::size_t> hashes;
    RandomStream random(3);
    for (int k = 0; k < 1000; ++k) {
        static_cast<void>(walking.flip({static_cast<Index>(random.below(21))}));
        tables.insert(walking);
        hashes.insert(hash(walking));
    }
    EXPECT_GT(tables.size(), 500U);
    EXPECT_EQ(hashes.size(), tables.size()) << "with 64 bits no two of these should collide";
}

}  // namespace
}  // namespace tightflip::kernel
