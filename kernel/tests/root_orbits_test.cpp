#include <tightflip/kernel/root_orbits.hpp>

#include <vector>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using Halfedges = std::vector<Halfedge>;

std::vector<std::size_t> firsts(RootOrbits& orbits, std::size_t roots) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < roots; ++i)
        all.push_back(orbits.first_of_orbit(i));
    return all;
}

TEST(RootOrbits, GrowWithEveryGenerator) {
    const std::vector<Root> roots{{{5}}, {{4}}, {{3}}, {{2}}, {{1}}, {{0}}};
    RootOrbits orbits;
    orbits.reset(roots, 6);
    EXPECT_EQ(firsts(orbits, 6), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));

    const Halfedges all{{0}, {1}, {2}, {3}, {4}, {5}};
    orbits.add_generator(all, Halfedges{{3}, {4}, {5}, {0}, {1}, {2}}, false);
    EXPECT_EQ(firsts(orbits, 6), (std::vector<std::size_t>{0, 1, 2, 0, 1, 2}));
    orbits.add_generator(all, Halfedges{{0}, {1}, {2}, {3}, {4}, {5}}, false);
    EXPECT_EQ(firsts(orbits, 6), (std::vector<std::size_t>{0, 1, 2, 0, 1, 2}));
    orbits.add_generator(Halfedges{{5}, {4}, {3}, {2}, {1}, {0}},
                         Halfedges{{4}, {3}, {5}, {1}, {0}, {2}}, false);
    EXPECT_EQ(firsts(orbits, 6), (std::vector<std::size_t>{0, 0, 0, 0, 0, 0}));

    orbits.reset(roots, 6);
    EXPECT_EQ(firsts(orbits, 6), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
}

TEST(RootOrbits, AReversalExchangesTheHandsOfRoots) {
    const std::vector<Root> roots{{{0}, Handedness::kept},
                                  {{0}, Handedness::mirrored},
                                  {{1}, Handedness::kept},
                                  {{1}, Handedness::mirrored}};
    const Halfedges there{{0}, {1}};
    const Halfedges back{{1}, {0}};
    RootOrbits orbits;
    orbits.reset(roots, 2);
    orbits.add_generator(there, back, true);
    EXPECT_EQ(firsts(orbits, 4), (std::vector<std::size_t>{0, 1, 1, 0}));
    orbits.reset(roots, 2);
    orbits.add_generator(there, back, false);
    EXPECT_EQ(firsts(orbits, 4), (std::vector<std::size_t>{0, 1, 0, 1}));
}

}  // namespace
}  // namespace tightflip::kernel
