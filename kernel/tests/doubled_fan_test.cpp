#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/doubled_fan.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

std::vector<Vertex> random_order(Index vertices, Vertex hub, std::uint64_t seed) {
    std::vector<Vertex> order;
    for (Index v = 0; v < vertices; ++v) {
        if (v != hub.id) order.push_back({v});
    }
    RandomStream(seed).shuffle(std::span(order));
    return order;
}

void expect_doubled_fan(const Triangulation& start, Vertex hub, std::span<const Vertex> order) {
    const DoubledFan fan = doubled_fan(start, hub, order);
    const Replay replayed = replay({start, fan.flips});
    ASSERT_TRUE(replayed.is_complete()) << replayed.reason;
    ASSERT_EQ(replayed.surface, fan.surface);
    ASSERT_EQ(fan.path.size(), order.size() - 1);
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
        const Halfedge step = fan.path[k];
        EXPECT_EQ(fan.surface.origin(step), order[k]);
        EXPECT_EQ(fan.surface.target(step), order[k + 1]);
        EXPECT_EQ(fan.surface.opposite(step), hub);
        EXPECT_EQ(fan.surface.opposite(twin(step)), hub);
    }
    const Index pages = start.vertex_count() - 2;
    Index halvings = 0;
    while ((Index{1} << halvings) < pages)
        ++halvings;
    EXPECT_LE(static_cast<Index>(fan.flips.size()),
              2 * pages * halvings + 4 * start.vertex_count());
}

TEST(DoubledFan, HasTheOrderAskedForFromAnyStart) {
    for (const Index vertices : {3, 4, 5, 12, 100}) {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Vertex hub{static_cast<Index>(seed) % vertices};
            if (vertices > 3) {
                expect_doubled_fan(families::random(vertices, 0, seed), hub,
                                   random_order(vertices, hub, seed));
            }
            expect_doubled_fan(families::book(vertices), hub, random_order(vertices, hub, seed));
        }
    }
}

TEST(DoubledFan, IsOneSurfaceWhateverTheStart) {
    const std::vector<Vertex> order = random_order(30, {4}, 9);
    const DoubledFan a = doubled_fan(families::random(30, 0, 1), {4}, order);
    const DoubledFan b = doubled_fan(families::double_wheel(30), {4}, order);
    EXPECT_TRUE(same_labelled_surface(a.surface, b.surface));
}

TEST(DoubledFan, RefusesOrdersThatLeaveOutOrRepeatAVertex) {
    const Triangulation start = families::random(4, 0, 1);
    const auto refuses = [&](Vertex hub, const std::vector<Vertex>& order) {
        EXPECT_THROW(static_cast<void>(doubled_fan(start, hub, order)), std::invalid_argument);
    };
    refuses({0}, {});
    refuses({0}, {{1}, {2}});
    refuses({0}, {{1}, {2}, {2}});
    refuses({0}, {{0}, {1}, {2}});
    refuses({0}, {{1}, {2}, {4}});
    refuses({0}, {{1}, {2}, {-1}});
    refuses({4}, {{1}, {2}, {3}});
    refuses({0}, {{1}, {2}, {3}, {1}});
    const Triangulation torus = families::random(4, 1, 1);
    EXPECT_THROW(static_cast<void>(doubled_fan(torus, {0}, std::vector<Vertex>{{1}, {2}, {3}})),
                 std::invalid_argument);
}

}  // namespace
}  // namespace tightflip::kernel
