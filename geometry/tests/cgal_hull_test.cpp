// Against an independent hull, CGAL's: omega+ is that of the star's, and `convexify` ends in it.

#include "shapes.hpp"
#include <tightflip/geometry/convexify.hpp>
#include <tightflip/geometry/curvature.hpp>
#include <tightflip/kernel/circulation.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

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

using LabelPair = std::pair<Index, Index>;

std::set<LabelPair> edges_of(const Triangulation& surface) {
    std::set<LabelPair> edges;
    for (Index e = 0; e < surface.edge_count(); ++e) {
        const Halfedge h = kernel::halfedge_of({e});
        edges.insert(std::minmax(surface.origin(h).id, surface.target(h).id));
    }
    return edges;
}

std::set<LabelPair> edges_of_hull(Points points) {
    std::map<HullPoint, Index> labels;
    for (const Point& p : points)
        labels.emplace(HullPoint(p.x(), p.y(), p.z()), static_cast<Index>(labels.size()));
    std::vector<HullPoint> corners;
    for (const Point& p : points)
        corners.emplace_back(p.x(), p.y(), p.z());
    HullMesh hull;
    CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
    std::set<LabelPair> edges;
    for (const auto e : hull.edges()) {
        edges.insert(std::minmax(labels.at(hull.point(hull.vertex(e, 0))),
                                 labels.at(hull.point(hull.vertex(e, 1)))));
    }
    return edges;
}

TEST(Convexify, EndsInTheEdgesOfTheHull) {
    for (const std::size_t vertices : {4U, 5U, 8U, 20U, 300U}) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            std::vector<Point> points = random_points(vertices, seed);
            for (Point& point : points)
                point.normalize();
            Triangulation surface = kernel::families::random(static_cast<Index>(vertices), 0, seed);
            ASSERT_TRUE(convexify(surface, points));
            EXPECT_EQ(edges_of(surface), edges_of_hull(points)) << vertices << ", seed " << seed;
        }
    }
}

}  // namespace
}  // namespace tightflip::geometry
