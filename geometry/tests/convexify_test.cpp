#include "shapes.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/convexify.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

std::vector<Point> points_of(const Surface& surface) {
    return {surface.points().begin(), surface.points().end()};
}

std::vector<Point> sphere_points(Index count, std::uint64_t seed) {
    std::vector<Point> points = random_points(static_cast<std::size_t>(count), seed);
    for (Point& point : points)
        point.normalize();
    return points;
}

/// The edges that are not flat, as pairs of labels.
std::set<std::pair<Index, Index>> bends(const SurfaceView& surface) {
    std::set<std::pair<Index, Index>> found;
    for (Index e = 0; e < surface.edge_count(); ++e) {
        if (edge_shape(surface, {e}) == EdgeShape::flat) continue;
        const Halfedge h = kernel::halfedge_of({e});
        found.insert(
            std::minmax(at(surface.table, h).origin.id, at(surface.table, twin(h)).origin.id));
    }
    return found;
}

/// Convexifies, and checks the end and the way there.
ConvexifyResult expect_convex(Triangulation surface, Points points,
                              const ConvexifyOptions& options = {}) {
    const Triangulation start = surface;
    const ConvexifyResult result = convexify(surface, points, options);
    EXPECT_TRUE(result) << message(result);
    EXPECT_TRUE(is_convex_surface({surface.table(), points}, FlatEdges::admitted));
    const kernel::Replay replayed = kernel::replay({start, result.flips});
    EXPECT_TRUE(replayed.is_complete()) << replayed.reason;
    EXPECT_EQ(replayed.surface, surface);
    EXPECT_EQ(result.way == ConvexifyWay::none, result.flips.empty());
    if (result.way == ConvexifyWay::construction) {
        const double vertices = surface.vertex_count();
        EXPECT_LE(
            static_cast<double>(result.flips.size()) - static_cast<double>(result.concave_flips),
            2 * vertices * std::ceil(std::log2(vertices)) + 4 * vertices);
    }
    const Surface hull = convex_surface({points.begin(), points.end()}).value();
    EXPECT_EQ(bends({surface.table(), points}), bends(hull.view()));
    return result;
}

/// Starts of all kinds on that many vertices, wild ones and such with parallel edges.
std::vector<Triangulation> starts(Index vertices, std::uint64_t seed) {
    return {kernel::families::random(vertices, 0, seed), kernel::families::book(vertices),
            kernel::families::stacked(vertices, seed)};
}

TEST(Convexify, ReachesTheHullFromAnyStart) {
    for (const Index vertices : {4, 5, 6, 7, 9, 13, 40, 200}) {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const std::vector<Point> points = sphere_points(vertices, seed);
            for (const Triangulation& start : starts(vertices, seed)) {
                expect_convex(start, points, {.seed = seed});
                expect_convex(start, points, {.concave_edges_first = false});
            }
        }
    }
}

TEST(Convexify, ReachesTheHullFromDataSets) {
    for (const char* name :
         {"twisted-prism", "skewed-cylinder", "cube-grid", "ellipsoid", "random-ellipsoid"}) {
        const DataSet* set = find_data_set(name);
        ASSERT_NE(set, nullptr) << name;
        const Surface data = set->make({.vertices = set->default_vertices, .seed = 1});
        const std::vector<Point> points = points_of(data);
        expect_convex(data.triangulation(), points);
        for (const Triangulation& start : starts(data.triangulation().vertex_count(), 3))
            expect_convex(start, points);
    }
}

/// Points on the boundary of a cube, a prism or an octahedron with integer coordinates: most are
/// within facets and edges.
std::vector<Point> lattice_points(kernel::RandomStream& random) {
    const std::uint32_t size = 1 + random.below(4);
    const std::uint32_t kind = random.below(3);
    std::vector<Point> points;
    for (int i = 0; i < 60; ++i) {
        Point p(random.below(size + 1), random.below(size + 1), random.below(size + 1));
        if (kind == 0) {
            p[random.below(3)] = random.below(2) * size;
        } else if (kind == 1) {
            p.x() = std::min(p.x(), size - p.y());
            const std::uint32_t side = random.below(4);
            if (side == 0) p.x() = size - p.y();
            if (side == 1) p.x() = 0;
            if (side == 2) p.y() = 0;
            if (side == 3) p.z() = random.below(2) * size;
        } else {
            p.y() = std::min(p.y(), size - p.x());
            p.z() = size - p.x() - p.y();
            for (double& x : p)
                x = random.below(2) == 0 ? x : -x;
        }
        if (std::ranges::find(points, p) == points.end()) points.push_back(p);
    }
    return points;
}

TEST(Convexify, EndsUpToFlatEdgesWhereDataAreDegenerate) {
    kernel::RandomStream random(11);
    int solid = 0;
    for (int i = 0; i < 150; ++i) {
        const std::vector<Point> points = lattice_points(random);
        if (points.size() < 4 || !convex_hull(points)) continue;
        ++solid;
        const auto vertices = static_cast<Index>(points.size());
        expect_convex(kernel::families::random(vertices, 0, random.bits()), points,
                      {.concave_edges_first = i % 2 == 0, .seed = random.bits()});
    }
    EXPECT_GT(solid, 100);
}

TEST(Convexify, TurnsASurfaceInsideOut) {
    const Surface hull = data_sets::random_sphere(60, 4);
    std::vector<Point> mirrored = points_of(hull);
    for (Point& point : mirrored)
        point.x() = -point.x();
    const ConvexifyResult result = expect_convex(hull.triangulation(), mirrored);
    EXPECT_EQ(result.way, ConvexifyWay::construction);
}

TEST(Convexify, TakesTheShortWayWhereThereIsOne) {
    const Surface hull = data_sets::random_sphere(60, 4);
    EXPECT_EQ(expect_convex(hull.triangulation(), hull.points()).way, ConvexifyWay::none);
    const Surface prism = data_sets::twisted_prism(3);
    const ConvexifyResult result = expect_convex(prism.triangulation(), prism.points());
    EXPECT_EQ(result.way, ConvexifyWay::concave_edges);
    EXPECT_EQ(result.flips.size(), 9U);
    EXPECT_EQ(
        expect_convex(prism.triangulation(), prism.points(), {.concave_edges_first = false}).way,
        ConvexifyWay::construction);
}

TEST(Convexify, DoesNotDependOnTheSizeOfCoordinates) {
    for (const double unit : {0x1p-1060, 0x1p-300, 1e-9, 1e9, 0x1p300, 0x1p1023}) {
        std::vector<Point> points = sphere_points(50, 2);
        for (Point& point : points)
            point *= unit;
        expect_convex(kernel::families::random(50, 0, 1), points);
    }
    std::vector<Point> needle = sphere_points(50, 3);
    for (Point& point : needle)
        point.z() *= 0x1p-30;
    expect_convex(kernel::families::random(50, 0, 1), needle);
}

TEST(Convexify, IsTheSameForASeed) {
    const std::vector<Point> points = sphere_points(100, 2);
    const Triangulation start = kernel::families::random(100, 0, 1);
    const auto flips = [&](std::uint64_t seed) {
        return expect_convex(start, points, {.seed = seed}).flips;
    };
    EXPECT_EQ(flips(1), flips(1));
    EXPECT_NE(flips(1), flips(2));
}

void expect_refused(Triangulation surface, std::vector<Point> points, const DataRefusal& refusal) {
    const Triangulation start = surface;
    const ConvexifyResult result = convexify(surface, points);
    EXPECT_EQ(result.end, ConvexifyEnd::unfit_data);
    EXPECT_EQ(result.data, refusal) << message(result);
    EXPECT_EQ(message(result), message(refusal));
    EXPECT_TRUE(result.flips.empty());
    EXPECT_EQ(surface, start);
}

TEST(Convexify, RefusesDataThatAreNotConvex) {
    std::vector<Point> points = sphere_points(30, 5);
    const Triangulation start = kernel::families::random(30, 0, 5);
    points[17] *= 0.5;
    expect_refused(start, points, {DataFault::interior_point, {17, -1}});
    points[17] = points[4];
    expect_refused(start, points, {DataFault::coincident_points, {4, 17}});
    points[17].y() = std::numeric_limits<double>::quiet_NaN();
    expect_refused(start, points, {DataFault::not_finite, {17, -1}});
    points = sphere_points(30, 5);
    for (Point& point : points)
        point.y() = 1;
    expect_refused(start, points, {DataFault::coplanar_points});
    expect_refused(kernel::families::book(3), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                   {DataFault::coplanar_points});
}

TEST(Convexify, RefusesOtherGenera) {
    Triangulation torus = kernel::families::random(20, 1, 5);
    const ConvexifyResult result = convexify(torus, sphere_points(20, 1));
    EXPECT_EQ(result.end, ConvexifyEnd::not_a_sphere);
    EXPECT_FALSE(message(result).empty());
}

TEST(Convexify, StopsAtItsLimitsAndLeavesTheSurface) {
    const std::vector<Point> points = sphere_points(4000, 5);
    const Triangulation start = kernel::families::random(4000, 0, 5);
    const auto expect_end = [&](ConvexifyEnd end, const ConvexifyOptions& options) {
        Triangulation surface = start;
        const ConvexifyResult result = convexify(surface, points, options);
        EXPECT_EQ(result.end, end);
        EXPECT_TRUE(result.flips.empty());
        EXPECT_FALSE(message(result).empty());
        EXPECT_EQ(surface, start);
    };
    expect_end(ConvexifyEnd::flip_limit, {.max_flips = 5000});
    const auto needed = static_cast<std::int64_t>(expect_convex(start, points).flips.size());
    expect_end(ConvexifyEnd::flip_limit, {.max_flips = needed - 1});
    expect_convex(start, points, {.max_flips = needed});
    expect_end(ConvexifyEnd::time_limit, {.max_time = std::chrono::duration<double>(0)});
    std::int64_t seen = 0;
    expect_end(ConvexifyEnd::stopped, {.keep_going = [&](std::int64_t flips) {
                   seen = flips;
                   return flips < 50'000;
               }});
    EXPECT_GE(seen, 50'000);
}

}  // namespace
}  // namespace tightflip::geometry
