#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/shorten.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using Flips = std::vector<Edge>;

Triangulation end_of(const FlipLog& log) {
    Replay replayed = replay(log);
    EXPECT_TRUE(replayed.is_complete()) << "flip " << replayed.done << ": " << replayed.reason;
    return std::move(replayed.surface);
}

/// Shortens, expecting the same ends and no more flips.
FlipLog shortened(const FlipLog& log, const ShortenOptions& options = {}) {
    FlipLog shorter = shorten(log, options);
    EXPECT_EQ(shorter.start, log.start);
    EXPECT_LE(shorter.flips.size(), log.flips.size());
    EXPECT_TRUE(same_labelled_surface(end_of(shorter), end_of(log)));
    return shorter;
}

/// A log of `attempts` flips of random edges, refused ones left out. With few edges to choose from
/// they come close together, and relations are many.
FlipLog wandering(const Triangulation& start, int attempts, std::uint64_t seed,
                  Index edges_to_choose_from) {
    RecordedSurface surface(start);
    RandomStream random(seed);
    const Index edges = std::min(edges_to_choose_from, start.edge_count());
    for (int k = 0; k < attempts; ++k) {
        const auto e = static_cast<Index>(random.below(static_cast<std::uint32_t>(edges)));
        static_cast<void>(surface.flip({e}));
    }
    return surface.log();
}

/// An edge none of whose two faces has a corner at the vertices near `h`.
Edge far_from(const Triangulation& surface, Halfedge h) {
    std::set<Vertex> near;
    for (const Halfedge spoke : surface.star(h)) {
        near.insert(surface.target(spoke));
        near.insert(surface.opposite(twin(surface.next(spoke))));
    }
    Halfedge far{0};
    while (near.contains(surface.origin(far)) || near.contains(surface.target(far)))
        ++far.id;
    return edge_of(far);
}

/// On a sphere of many vertices two edges that share a face, another side of the quadrilateral
/// about the first, and an edge far from them.
struct Place {
    Triangulation sphere = families::icosphere(2);
    Halfedge h{0};
    Edge e = edge_of(h);
    Edge f = edge_of(sphere.next(h));
    Edge side = edge_of(sphere.next(twin(h)));
    Edge far = far_from(sphere, h);
};

TEST(Shorten, CancelsTwoFlipsOfAnEdgeInARow) {
    const Place at;
    EXPECT_EQ(shortened({at.sphere, {at.e, at.e}}).flips, Flips{});
    EXPECT_EQ(shortened({at.sphere, {at.f, at.e, at.e, at.e}}).flips, (Flips{at.f, at.e}));
    EXPECT_EQ(shortened({at.sphere, {at.e, at.e, at.e, at.e}}).flips, Flips{});
}

TEST(Shorten, CancelsAcrossFlipsElsewhereAndPairsWithinPairs) {
    const Place at;
    EXPECT_EQ(shortened({at.sphere, {at.e, at.far, at.e}}).flips, (Flips{at.far}));
    EXPECT_EQ(shortened({at.sphere, {at.e, at.side, at.f, at.f, at.side, at.e}}).flips, Flips{});
}

TEST(Shorten, GoesThePentagonTheShortWayRound) {
    const Place at;
    const FlipLog three = shortened({at.sphere, {at.e, at.f, at.e}});
    EXPECT_EQ(three.flips, (Flips{at.f, at.e}));
    EXPECT_EQ(shortened({at.sphere, {at.e, at.f, at.e, at.f}}).flips.size(), 1U);
    EXPECT_EQ(shortened({at.sphere, {at.e, at.f, at.e, at.f, at.e}}).flips, Flips{});
    EXPECT_EQ(shortened({at.sphere, {at.e, at.far, at.f, at.far, at.e}}).flips.size(), 2U);
}

TEST(Shorten, ExchangesTheNamesOfThePentagonsDiagonalsInWhatFollows) {
    const Place at;
    // Were f not called e afterwards, the last flips would be of other edges.
    for (const Flips& rest :
         {Flips{at.side, at.e}, Flips{at.side, at.f}, Flips{at.side, at.e, at.f},
          Flips{at.far, at.side, at.f, at.e, at.side}}) {
        FlipLog log{at.sphere, {at.e, at.f, at.e}};
        log.flips.insert(log.flips.end(), rest.begin(), rest.end());
        EXPECT_LT(shortened(log).flips.size(), log.flips.size());
    }
}

TEST(Shorten, KeepsWhatASideBetweenKeepsApart) {
    const Place at;
    for (const Flips& flips : {Flips{at.e}, Flips{at.e, at.f}, Flips{at.e, at.side, at.f, at.e},
                               Flips{at.e, at.f, at.side, at.e}}) {
        EXPECT_EQ(shortened({at.sphere, flips}).flips, flips);
    }
    EXPECT_EQ(shorten({at.sphere, {}}).flips, Flips{});
}

TEST(Shorten, LeadsToTheSameEndFromManyStarts) {
    std::uint64_t seed = 0;
    std::size_t saved = 0;
    for (const Index genus : {0, 1, 2}) {
        for (const Index vertices : {4, 5, 6, 9, 15, 40}) {
            for (int run = 0; run < 60; ++run) {
                ++seed;
                const FlipLog log = wandering(families::random(vertices, genus, seed), 150, seed,
                                              5 + static_cast<Index>(seed % 60));
                saved += log.flips.size() - shortened(log).flips.size();
                if (HasFailure())
                    FAIL() << "genus " << genus << ", V = " << vertices << ", seed " << seed;
            }
        }
    }
    EXPECT_GT(saved, 0U);
}

TEST(Shorten, LeadsBackAlongAnyPathInNoFlips) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        FlipLog log = wandering(families::random(12, 0, seed), 100, seed, 36);
        for (std::size_t k = log.flips.size(); k-- > 0;)
            log.flips.push_back(log.flips[k]);
        EXPECT_EQ(shortened(log).flips, Flips{}) << "seed " << seed;
    }
}

TEST(Shorten, ShortensConstructedPaths) {
    for (const Index vertices : {20, 100, 1000}) {
        const FlipLog path =
            connect(families::random(vertices, 0, 1), families::random(vertices, 0, 2)).value();
        EXPECT_LT(shortened(path).flips.size(), path.flips.size()) << vertices;
    }
}

TEST(Shorten, SpendsNoMorePassesThanItMay) {
    const Place at;
    const FlipLog log{at.sphere, {at.e, at.e}};
    EXPECT_EQ(shorten(log, {.most_passes = 0}), log);
    EXPECT_EQ(shorten(log, {.most_passes = 1}).flips, Flips{});
    const FlipLog path = connect(families::random(300, 0, 1), families::random(300, 0, 2)).value();
    const FlipLog once = shortened(path, {.most_passes = 1});
    const FlipLog often = shortened(path);
    EXPECT_LT(often.flips.size(), once.flips.size());
    EXPECT_EQ(shortened(often).flips, often.flips);
}

TEST(Shorten, RefusesALogThatDoesNotReplay) {
    const Triangulation book = families::book(5);
    Index refused = 0;
    while (book.can_flip({refused}))
        ++refused;
    for (const Index e : {refused, -1, book.edge_count()}) {
        EXPECT_THROW(static_cast<void>(shorten({book, {{e}}})), std::invalid_argument) << e;
    }
}

}  // namespace
}  // namespace tightflip::kernel
