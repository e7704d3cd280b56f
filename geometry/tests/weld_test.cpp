#include "weld.hpp"

#include "reading.hpp"
#include <tightflip/kernel/random.hpp>

#include <limits>

namespace tightflip::geometry {
namespace {

using Points3 = std::vector<Eigen::Vector3d>;

/// Triangle i has the corners 3i, 3i + 1, 3i + 2, each with a point of its own.
TriangleSoup loose(const Points3& points) {
    TriangleSoup soup;
    soup.points = points;
    for (std::size_t i = 0; i < points.size(); ++i)
        soup.point_positions.push_back(100 + i);
    for (Index i = 0; i + 2 < std::ssize(points); i += 3) {
        soup.triangles.push_back({i, i + 1, i + 2});
        soup.triangle_positions.push_back(static_cast<std::uint64_t>(i));
    }
    return soup;
}

TEST(Weld, GoesToTheFirstThatIsNearEnough) {
    TriangleSoup soup =
        loose({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0.5, 0, 0}, {3.4, 0, 0}, {1.6, 0, 0}});
    weld(soup, 0.75);
    EXPECT_EQ(soup.points, (Points3{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3.4, 0, 0}}));
    EXPECT_EQ(soup.point_positions, (Positions{100, 101, 102, 104}));
    EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 2}, {0, 3, 1}}));
}

TEST(Weld, NoChainMovesAPointFurtherThanTheDistance) {
    TriangleSoup soup = loose({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}});
    weld(soup, 1);
    EXPECT_EQ(soup.points, (Points3{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}));
}

/// What weld does, by comparing all pairs.
Triangles welded_slowly(const Points3& points, double distance) {
    Points3 kept;
    Triangles triangles(points.size() / 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::size_t k = 0;
        while (k < kept.size()) {
            const Eigen::Vector3d d = kept[k] - points[i];
            if (std::hypot(d[0], d[1], d[2]) <= distance) break;
            ++k;
        }
        if (k == kept.size()) kept.push_back(points[i]);
        triangles[i / 3][i % 3] = static_cast<Index>(k);
    }
    return triangles;
}

TEST(Weld, AgreesWithComparingAllPairs) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        kernel::RandomStream random(seed);
        // Points of a grid, some of them far from the origin, so that rounding sets in.
        const double scale = std::array{1.0, 1e-320, 1e290, 0x1p53, 1e-5}[seed % 5];
        const double far = std::array{0.0, 1.0, 0x1p50, 0x1p53, 0x1p54}[seed / 5 % 5];
        Points3 points(3 * (2 + random.below(30)));
        for (auto& p : points) {
            for (double& x : p)
                x = (far + random.below(6)) * scale;
        }
        for (const double steps : {0.0, 0.9, 1.0, 1.5, 2.0}) {
            TriangleSoup soup = loose(points);
            weld(soup, steps * scale);
            ASSERT_EQ(soup.triangles, welded_slowly(points, steps * scale))
                << "seed " << seed << ", distance " << steps << " steps";
        }
    }
}

TEST(Weld, TakesTheLargestAndTheLeastNumbers) {
    constexpr double most = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    const Points3 points{{most, most, most}, {-most, 0, 0}, {0, least, 0},
                         {0, -least, 0},     {most, 0, 0},  {0, 0, -most}};
    for (const double distance : {least, 2 * least, 1.0, most / 4}) {
        TriangleSoup soup = loose(points);
        weld(soup, distance);
        EXPECT_EQ(soup.points.size(), distance == least ? 6U : 5U) << distance;
    }
}

TEST(Weld, DistanceNoughtMakesEqualPointsOne) {
    TriangleSoup soup = loose({{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}});
    weld(soup, 0);
    EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 0}}));
}

}  // namespace
}  // namespace tightflip::geometry
