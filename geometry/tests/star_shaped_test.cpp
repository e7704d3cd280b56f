#include "shapes.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/star_shaped.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

/// Random directions at random distances 1 .. 3 from a centre.
std::vector<Point> burr(std::size_t count, const Point& centre, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    std::vector<Point> points;
    while (points.size() < count) {
        const Point direction = random_point(random).normalized();
        points.push_back(centre + (2 + random_coordinate(random)) * direction);
    }
    return points;
}

TEST(StarShaped, EveryFaceTurnsItsInsideToTheCentre) {
    for (const std::size_t count : {10U, 100U, 2000U}) {
        const Point centre(5, -3, 2);
        const auto made = star_shaped_surface(burr(count, centre, count), centre).value();
        const SurfaceView view = made.surface.view();
        EXPECT_EQ(made.faces_turned_away, 0);
        EXPECT_EQ(made.surface.triangulation().genus(), 0);
        double solid_angle = 0;
        for (const Halfedge h : made.surface.triangulation().faces()) {
            const Point a = (view.origin(h) - centre).normalized();
            const Point b = (view.target(h) - centre).normalized();
            const Point c = (view.opposite(h) - centre).normalized();
            solid_angle += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
        }
        EXPECT_NEAR(solid_angle, 4 * std::numbers::pi, 1e-9);  // each direction once
    }
}

TEST(StarShaped, OfPointsOnASphereIsTheHull) {
    auto points = burr(300, Point::Zero(), 1);
    for (Point& point : points)
        point.normalize();
    const auto made = star_shaped_surface(points, Point::Zero()).value();
    EXPECT_TRUE(is_convex_surface(made.surface.view()));
}

TEST(StarShaped, DirectionsWithinRoundingStillMakeASphere) {
    std::vector<Point> points = burr(60, Point::Zero(), 7);
    for (std::size_t i = 0; i < 40; ++i) {
        Point close = points[i] * 2;
        close[static_cast<Eigen::Index>(i % 3)] =
            std::nextafter(close[static_cast<Eigen::Index>(i % 3)], 10.0);
        points.push_back(close);
    }
    const auto made = star_shaped_surface(points, Point::Zero()).value();
    EXPECT_EQ(made.surface.triangulation().genus(), 0);
    EXPECT_EQ(made.surface.triangulation().vertex_count(), 100);
    Index turned_away = 0;
    for (const Halfedge h : made.surface.triangulation().faces()) {
        const SurfaceView view = made.surface.view();
        const Sign side =
            orientation(view.origin(h), view.target(h), view.opposite(h), Point::Zero());
        turned_away += side != Sign::negative ? 1 : 0;
    }
    EXPECT_EQ(made.faces_turned_away, turned_away);
}

TEST(StarShaped, RefusesSharedDirectionsAndCentresOutside) {
    std::vector<Point> points{{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}, {0, 0, 1}};
    const auto refusal = [&](const Point& centre) {
        return star_shaped_surface(points, centre).refusal();
    };
    EXPECT_TRUE(star_shaped_surface(points, Point::Zero()));
    EXPECT_EQ(refusal({2, 0, 0}).fault, DataFault::centre_outside);
    EXPECT_EQ(refusal({0, 0, 1}).fault, DataFault::centre_outside);  // on an edge
    EXPECT_EQ(refusal({0, NAN, 1}).fault, DataFault::centre_outside);
    points.emplace_back(3, -3, -3);
    EXPECT_EQ(refusal({0, 0, 0}), (DataRefusal{DataFault::shared_direction, {2, 5}}));
    points.back() = {0, 0.125, 0};
    EXPECT_EQ(refusal({0, 0.125, 0}), (DataRefusal{DataFault::shared_direction, {5, 5}}));
    points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(refusal({0.5, 0.5, 0}).fault, DataFault::coplanar_points);
}

}  // namespace
}  // namespace tightflip::geometry
