#include "merge_equal_points.hpp"

#include "reading.hpp"
#include <tightflip/kernel/random.hpp>

namespace tightflip::geometry {
namespace {

/// Triangle i has the corners 3i, 3i + 1, 3i + 2, each with a point of its own.
TriangleSoup loose(const std::vector<Eigen::Vector3d>& points) {
    TriangleSoup soup;
    soup.points = points;
    for (std::size_t i = 0; i < points.size(); ++i)
        soup.point_positions.push_back(100 + i);
    for (Index i = 0; i + 2 < std::ssize(points); i += 3)
        soup.triangles.push_back({i, i + 1, i + 2});
    return soup;
}

TEST(MergeEqualPoints, NumbersInTheOrderOfAppearance) {
    TriangleSoup soup = loose({{9, 0, 0}, {5, 0, 0}, {7, 0, 0}, {5, 0, 0}, {9, 0, 0}, {1, 0, 0}});
    merge_equal_points(soup);
    EXPECT_EQ(soup.points,
              (std::vector<Eigen::Vector3d>{{9, 0, 0}, {5, 0, 0}, {7, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 2}, {1, 0, 3}}));
    EXPECT_EQ(soup.point_positions, (Positions{100, 101, 102, 105}));
}

TEST(MergeEqualPoints, TellsApartWhatDiffersInOneCoordinate) {
    TriangleSoup soup =
        loose({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, -0.0, 1}, {-0.0, 1, 0}});
    merge_equal_points(soup);
    EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 2}, {3, 1, 2}}));
}

TEST(MergeEqualPoints, AgreesWithComparingAllPairs) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        kernel::RandomStream random(seed);
        std::vector<Eigen::Vector3d> points(3 * (1 + random.below(20)));
        for (auto& p : points) {
            for (int k = 0; k < 3; ++k)
                p[k] = static_cast<int>(random.below(3)) - 1;
        }
        TriangleSoup soup = loose(points);
        merge_equal_points(soup);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto corner = static_cast<std::size_t>(soup.triangles[i / 3][i % 3]);
            ASSERT_EQ(soup.points[corner], points[i]) << "seed " << seed;
        }
        for (std::size_t i = 0; i < soup.points.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j)
                ASSERT_NE(soup.points[i], soup.points[j]);
        }
    }
}

}  // namespace
}  // namespace tightflip::geometry
