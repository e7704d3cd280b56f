// omega+ against an independent hull: that of the star, by CGAL.

#include "shapes.hpp"
#include <tightflip/geometry/curvature.hpp>
#include <tightflip/kernel/circulation.hpp>

#include <cmath>
#include <map>
#include <numbers>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using HullKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using HullPoint = HullKernel::Point_3;
using HullMesh = CGAL::Surface_mesh<HullPoint>;

/// 2 pi less the angles of the hull's faces at the vertex; 0 where it is no corner of the hull.
double positive_curvature_by_hull(const Surface& surface, Halfedge h) {
    const Point& apex = surface.view().origin(h);
    std::vector<HullPoint> points{{apex.x(), apex.y(), apex.z()}};
    for (const Vertex v : kernel::Neighbours(surface.triangulation().table(), h)) {
        const Point& p = surface.point(v);
        points.emplace_back(p.x(), p.y(), p.z());
    }
    HullMesh hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    const auto vector = [](const HullPoint& from, const HullPoint& to) {
        return Point(to.x() - from.x(), to.y() - from.y(), to.z() - from.z());
    };
    for (const auto v : hull.vertices()) {
        if (hull.point(v) != points.front()) continue;
        double angles = 0;
        for (const auto spoke : CGAL::halfedges_around_target(v, hull)) {
            const Point u = vector(hull.point(v), hull.point(hull.source(spoke)));
            const Point w = vector(hull.point(v), hull.point(hull.target(hull.next(spoke))));
            angles += std::atan2(u.cross(w).norm(), u.dot(w));
        }
        return 2 * std::numbers::pi - angles;
    }
    return 0;
}

TEST(PositiveCurvature, IsThatOfTheHullOfTheStar) {
    int on_hull = 0;
    int within = 0;
    std::uint64_t seed = 40;
    std::vector<Triangulation> starts = all_families();
    for (int i = 0; i < 40; ++i)
        starts.push_back(kernel::families::random(20, i % 3, static_cast<std::uint64_t>(i)));
    for (const Triangulation& start : starts) {
        const Surface surface = with_random_points(start, ++seed);
        StarMeter meter;
        for (const Halfedge h : surface.triangulation().outgoing()) {
            // With fewer there is no solid hull.
            const auto neighbours = kernel::Neighbours(surface.triangulation().table(), h);
            std::map<Index, int> distinct;
            for (const Vertex v : neighbours)
                ++distinct[v.id];
            if (distinct.size() < 3) continue;
            const double expected = positive_curvature_by_hull(surface, h);
            EXPECT_NEAR(meter.measure(surface.view(), h).positive, expected, 1e-10);
            ++(expected > 0 ? on_hull : within);
        }
    }
    EXPECT_GT(on_hull, 50);
    EXPECT_GT(within, 50);
}

}  // namespace
}  // namespace tightflip::geometry
