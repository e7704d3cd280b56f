// What the kinds of generators.hpp promise that come from adversarial_starts.hpp.

#include <tightflip/properties/generators.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using kernel::Halfedge;
using kernel::Vertex;

Triangulation made(std::string_view kind, Index vertices, Index genus = 0, std::uint64_t seed = 3) {
    return find_start_kind(kind)->make({.vertices = vertices, .genus = genus, .seed = seed});
}

std::vector<Index> degrees(const Triangulation& surface) {
    std::vector<Index> found;
    for (const Halfedge h : surface.outgoing())
        found.push_back(surface.degree(h));
    return found;
}

Index pairs_of_parallel_edges(const Triangulation& surface) {
    std::set<std::pair<Vertex, Vertex>> pairs;
    for (Index e = 0; e < surface.edge_count(); ++e) {
        const Halfedge h = halfedge_of(Edge{e});
        pairs.insert(std::minmax(surface.origin(h), surface.target(h)));
    }
    return surface.edge_count() - static_cast<Index>(pairs.size());
}

TEST(Fan, IsTwoFansAboutOneVertex) {
    for (const Index vertices : {3, 4, 5, 17}) {
        const Triangulation fan = made("fan", vertices);
        const std::vector<Index> found = degrees(fan);
        EXPECT_EQ(found.front(), fan.face_count());
        EXPECT_EQ(found[1], 2);
        EXPECT_EQ(found.back(), 2);
        for (Index v = 2; v + 1 < vertices; ++v)
            EXPECT_EQ(found[static_cast<std::size_t>(v)], 4);
        EXPECT_EQ(pairs_of_parallel_edges(fan), vertices - 3);
    }
}

TEST(DegreeTwoChain, ComesApartBetweenVerticesOfDegreeTwo) {
    for (const Index genus : {0, 1, 3}) {
        const Triangulation chain = made("degree-2-chain", 20, genus);
        const std::vector<Index> found = degrees(chain);
        EXPECT_EQ(found.back(), 2);
        EXPECT_EQ(found[18], 4);
        for (std::size_t v = 5; v < 18; ++v)
            EXPECT_EQ(found[v], 6) << "vertex " << v;
        // One vertex less is the chain without the last: its faces and edges, and no others.
        const std::vector<Index> shorter = degrees(made("degree-2-chain", 19, genus));
        EXPECT_TRUE(std::equal(shorter.begin(), shorter.begin() + 17, found.begin()));
        EXPECT_EQ(shorter.back(), 2);
    }
}

TEST(Digons, HaveManyVerticesOfDegreeTwoAtRandom) {
    for (const Index genus : {0, 1, 2}) {
        const std::vector<Index> found = degrees(made("digons", 60, genus));
        EXPECT_GT(std::ranges::count(found, 2), 15);
        EXPECT_GT(*std::ranges::max_element(found), 12);
        EXPECT_LT(*std::ranges::max_element(found), 90);  // of some 120 faces
        EXPECT_NE(made("digons", 60, genus, 1), made("digons", 60, genus, 2));
    }
}

TEST(Hub, IsAVertexOfEveryFace) {
    for (const Index genus : {0, 1, 2, 3}) {
        for (const std::uint64_t seed : {1U, 2U}) {
            const Triangulation hub = made("hub", 30, genus, seed);
            EXPECT_EQ(degrees(hub).front(), hub.face_count());
        }
        EXPECT_NE(made("hub", 30, genus, 1), made("hub", 30, genus, 2));
    }
}

TEST(Simple, HasNoParallelEdgesAndIsFarFromItsStart) {
    for (const Index genus : {0, 1, 2}) {
        for (const Index vertices : {6 * genus + 4, 6 * genus + 40}) {
            const Triangulation surface = made("simple", vertices, genus);
            EXPECT_TRUE(audit(surface).is_simple().value());
            if (vertices < 40) continue;
            Index same = 0;  // halfedges that still join what they did
            const Triangulation start = made("genus", vertices, genus);
            for (Index h = 0; h < start.halfedge_count(); ++h)
                same += surface.origin(Halfedge{h}) == start.origin(Halfedge{h}) &&
                                surface.target(Halfedge{h}) == start.target(Halfedge{h})
                            ? 1
                            : 0;
            EXPECT_LT(same, start.halfedge_count() / 4);
        }
    }
    EXPECT_THROW(static_cast<void>(made("simple", 14, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace tightflip::properties
