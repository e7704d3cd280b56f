#include "shapes.hpp"
#include <tightflip/geometry/stacked_surface.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

TEST(StackedSurface, IsASimpleSphereOnThePoints) {
    for (const StackingFace choice : {StackingFace::random, StackingFace::nearest}) {
        for (const std::size_t count : {4U, 5U, 100U}) {
            const auto points = random_points(count, 3);
            const Surface surface = stacked_surface(points, 1, choice).value();
            const Triangulation& t = surface.triangulation();
            EXPECT_EQ(t.genus(), 0);
            std::set<std::pair<Index, Index>> pairs;
            for (Index h = 0; h < t.halfedge_count(); ++h)
                pairs.insert({t.origin({h}).id, t.target({h}).id});
            EXPECT_EQ(pairs.size(), static_cast<std::size_t>(t.halfedge_count()));
            EXPECT_TRUE(std::ranges::equal(surface.points(), points));
            Index degree_three = 0;
            for (const Halfedge h : t.outgoing())
                degree_three += t.degree(h) == 3 ? 1 : 0;
            EXPECT_GE(degree_three, 1);  // the last point put in
        }
    }
    EXPECT_GT(measure(stacked_surface(random_points(4, 8), 5).value().view()).volume, 0);
}

TEST(StackedSurface, TheSeedDecides) {
    const auto points = random_points(50, 3);
    const auto make = [&](std::uint64_t seed) {
        return stacked_surface(points, seed).value().triangulation();
    };
    EXPECT_EQ(make(1), make(1));
    EXPECT_FALSE(kernel::same_labelled_surface(make(1), make(2)));
}

TEST(StackedSurface, TheNearestFaceIsBetterThanAny) {
    const auto points = random_points(300, 4);
    const auto area = [&](StackingFace choice) {
        return measure(stacked_surface(points, 1, choice).value().view()).area;
    };
    EXPECT_LT(area(StackingFace::nearest), 0.7 * area(StackingFace::random));
}

TEST(StackedSurface, TakesCoincidentAndHugePoints) {
    EXPECT_TRUE(stacked_surface(std::vector<Point>(6, Point(1, 2, 3)), 1, StackingFace::nearest));
    auto points = random_points(20, 1);
    for (Point& point : points)
        point *= 1e308;
    EXPECT_TRUE(stacked_surface(points, 1, StackingFace::nearest));
    points[3].x() = NAN;
    EXPECT_EQ(stacked_surface(points, 1).refusal(), (DataRefusal{DataFault::not_finite, {3, -1}}));
    EXPECT_EQ(stacked_surface({3, Point::Zero()}, 1).refusal().fault, DataFault::too_few_points);
}

}  // namespace
}  // namespace tightflip::geometry
