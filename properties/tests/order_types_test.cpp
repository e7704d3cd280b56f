#include "order_types.hpp"

#include "order_type_seeds.hpp"

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::Point;

std::set<Chirotope> order_types_of(const Quadruples& quadruples, std::size_t points,
                                   std::span<const std::uint64_t> seeds) {
    std::set<Chirotope> types;
    for (const std::uint64_t seed : seeds) {
        const auto signs = quadruples.chirotope(points_of_seed(points, seed));
        if (signs) types.insert(quadruples.order_type(*signs));
    }
    return types;
}

/// How many classes under projective transformations make up all the types; each must have no
/// others.
std::size_t count_projective_classes(const Quadruples& quadruples,
                                     const std::set<Chirotope>& types) {
    std::set<Chirotope> left = types;
    std::size_t classes = 0;
    for (; !left.empty(); ++classes) {
        const Chirotope first = *left.begin();
        left.erase(first);
        for (const Chirotope type : quadruples.projective_class(first)) {
            EXPECT_TRUE(types.contains(type)) << "an order type is missing";
            left.erase(type);
        }
    }
    return classes;
}

TEST(OrderType, NeitherNamesNorReflectionsNorAffineMapsChangeIt) {
    const Quadruples quadruples(7);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        std::vector<Point> points = points_of_seed(7, seed);
        const auto signs = quadruples.chirotope(points);
        if (!signs) continue;
        kernel::RandomStream(seed).shuffle(std::span(points));
        for (Point& p : points)
            p = {p.y() + 3, p.x() - 2 * p.z(), 5 * p.z() + p.y()};
        const auto others = quadruples.chirotope(points);
        ASSERT_TRUE(others);
        EXPECT_NE(*signs, *others);
        EXPECT_EQ(quadruples.order_type(*signs), quadruples.order_type(*others)) << "seed " << seed;
    }
}

TEST(OrderType, IsTheLeastOfAllNames) {
    // Against all renamings of the points themselves.
    const Quadruples quadruples(5);
    std::vector<Point> points = points_of_seed(5, 0);
    Chirotope least = ~Chirotope{0};
    std::array<int, 5> names{0, 1, 2, 3, 4};
    do {
        std::vector<Point> renamed;
        renamed.reserve(names.size());
        for (const int name : names)
            renamed.push_back(points[static_cast<std::size_t>(name)]);
        for (int reflected = 0; reflected < 2; ++reflected) {
            least = std::min(least, quadruples.chirotope(renamed).value());
            for (Point& p : renamed)
                p.x() = -p.x();
        }
    } while (std::ranges::next_permutation(names).found);
    EXPECT_EQ(quadruples.order_type(quadruples.chirotope(points).value()), least);
}

TEST(OrderType, FourPointsInAPlaneHaveNone) {
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}};
    EXPECT_FALSE(Quadruples(5).chirotope(points));
}

// The order types of one class are the acyclic reorientations of one oriented matroid of rank 4
// that is uniform (no four in a plane) and realizable. By duality there are as many of these on 5,
// 6 and 7 elements as of ranks 1, 2 and 3: one, one, and 11, the simple arrangements of 7 lines in
// the projective plane (OEIS A018242). So the seeds make all order types there are.
TEST(OrderTypeSeeds, AreOneForEachOrderType) {
    const auto check = [](std::size_t points, std::span<const std::uint64_t> seeds,
                          std::size_t classes) {
        const Quadruples quadruples(points);
        const std::set<Chirotope> types = order_types_of(quadruples, points, seeds);
        EXPECT_EQ(types.size(), seeds.size()) << points << " points";
        EXPECT_EQ(count_projective_classes(quadruples, types), classes) << points << " points";
    };
    check(5, seeds_of_5_points, 1);
    check(6, seeds_of_6_points, 1);
    check(7, seeds_of_7_points, 11);
}

}  // namespace
}  // namespace tightflip::properties
