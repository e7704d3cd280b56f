#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/plane_pieces.hpp>

#include <algorithm>
#include <array>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::Point;
using geometry::Surface;
using kernel::Index;
using kernel::RandomStream;
using kernel::Triangulation;

double coordinate(RandomStream& random) {
    return static_cast<double>(random.bits() >> 11U) * 0x1p-52 - 1;
}

std::vector<Point> random_points(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    std::vector<Point> points(static_cast<std::size_t>(count));
    for (Point& point : points) {
        for (double& x : point)
            x = coordinate(random);
    }
    return points;
}

/// The vertices on one side that are joined to `start` there are marked.
void spread(const Triangulation& surface, const std::vector<bool>& above, std::vector<bool>& seen,
            std::size_t start) {
    seen[start] = true;
    for (bool grows = true; grows;) {
        grows = false;
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            const auto a = static_cast<std::size_t>(surface.origin({h}).id);
            const auto b = static_cast<std::size_t>(surface.target({h}).id);
            if (!seen[a] || seen[b] || above[a] != above[b]) continue;
            seen[b] = grows = true;
        }
    }
}

/// By the definition, for a plane that meets no vertex.
Index pieces_of(const Surface& surface, const Point& normal, double height) {
    std::vector<bool> above;
    for (const Point& point : surface.points())
        above.push_back(normal.dot(point) > height);
    Index pieces = 0;
    // Each side's components are counted by marking one after the other.
    std::vector<bool> done(above.size(), false);
    for (std::size_t v = 0; v < above.size(); ++v) {
        if (done[v]) continue;
        ++pieces;
        std::vector<bool> seen(above.size(), false);
        spread(surface.triangulation(), above, seen, v);
        for (std::size_t w = 0; w < above.size(); ++w)
            done[w] = done[w] || seen[w];
    }
    return pieces;
}

Index most_pieces_of_random_planes(const Surface& surface, int planes, std::uint64_t seed) {
    RandomStream random(seed);
    Index most = 0;
    for (int i = 0; i < planes; ++i) {
        const Point normal(coordinate(random), coordinate(random), coordinate(random));
        const Point on(2 * coordinate(random), 2 * coordinate(random), 2 * coordinate(random));
        most = std::max(most, pieces_of(surface, normal, normal.dot(on)));
    }
    return most;
}

TEST(PlanePieces, OfATetrahedronAreTwo) {
    const Surface surface(kernel::families::tetrahedron(),
                          {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const PlaneCut cut = most_pieces(surface.view());
    EXPECT_EQ(cut.above, 1);
    EXPECT_EQ(cut.below, 1);
}

TEST(PlanePieces, OfABookCanBeAsManyAsItsPages) {
    // Poles in the middle of a ring of pages: each page is a piece above a plane that has only the
    // pages of one half above it.
    const std::vector<Point> points{{0, 0, -1}, {0, 0, -1.5}, {3, 0, 0.1},
                                    {0, 3, 0},  {-3, 0, 0.2}, {0, -3, 0.3}};
    const PlaneCut cut = most_pieces(Surface(kernel::families::book(6), points).view());
    EXPECT_EQ(std::max(cut.above, cut.below), 4);
    EXPECT_EQ(cut.pieces(), 5);
}

// No plane shows more than the search over flags finds, and mostly some random plane shows as much.
TEST(PlanePieces, AreTheMostThatAnyPlaneShows) {
    int met = 0;
    for (const Index vertices : {5, 6, 7, 8}) {
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const Surface surface(kernel::families::random(vertices, 0, seed),
                                  random_points(vertices, seed));
            const Index most = most_pieces(surface.view()).pieces();
            const Index shown = most_pieces_of_random_planes(surface, 6000, seed);
            EXPECT_GE(most, shown) << vertices << " vertices, seed " << seed;
            met += most == shown ? 1 : 0;
        }
    }
    EXPECT_GE(met, 40);  // of 48
}

// Coplanar and collinear points too: lines in a plane, and points on a line, are looked at in every
// order.
TEST(PlanePieces, AreTheMostThatAnyPlaneShowsOfPointsOnAGrid) {
    int met = 0;
    for (const std::uint32_t depth : {1U, 3U}) {
        for (std::uint64_t seed = 1; seed <= 24; ++seed) {
            RandomStream random(seed);
            std::vector<Point> points;
            while (points.size() < 7) {
                const Point point(random.below(3), random.below(3), random.below(depth));
                if (std::ranges::find(points, point) == points.end()) points.push_back(point);
            }
            const Surface surface(kernel::families::random(7, 0, seed), points);
            const Index most = most_pieces(surface.view()).pieces();
            const Index shown = most_pieces_of_random_planes(surface, 4000, seed);
            EXPECT_GE(most, shown) << "depth " << depth << ", seed " << seed;
            met += most == shown ? 1 : 0;
        }
    }
    EXPECT_GE(met, 36);  // of 48
}

// What the answer says of its plane can be done: a plane near the three points that leaves them on
// the named sides cuts into as many pieces.
TEST(PlanePieces, TheAnswersPlaneExists) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Surface surface(kernel::families::random(9, 0, seed), random_points(9, seed));
        const PlaneCut cut = most_pieces(surface.view());
        const Point a = surface.point(cut.through[0]);
        const Point b = surface.point(cut.through[1]);
        const Point c = surface.point(cut.through[2]);
        const Point normal = (b - a).cross(c - a).normalized();
        const auto lowered = [&](std::size_t i, const Point& p) -> Point {
            return p + (cut.is_above.at(i) ? -1e-7 : 1e-7) * normal;
        };
        const Point d = lowered(0, a);
        const Point tilted = (lowered(1, b) - d).cross(lowered(2, c) - d);
        EXPECT_EQ(pieces_of(surface, tilted, tilted.dot(d)), cut.pieces()) << "seed " << seed;
    }
}

TEST(PlanePieces, OfConvexSurfacesAreTwo) {
    for (const Index vertices : {5, 8, 16})
        EXPECT_EQ(most_pieces(geometry::data_sets::random_sphere(vertices, 7).view()).pieces(), 2);
    // Coplanar points on all sides, and points on edges and within facets.
    EXPECT_EQ(most_pieces(geometry::data_sets::skewed_cylinder(4).view()).pieces(), 2);
    EXPECT_EQ(most_pieces(geometry::data_sets::cube_grid(26).view()).pieces(), 2);
}

// In one plane a line does the cutting: the arms of a cross beside its middle.
TEST(PlanePieces, OfCoplanarPointsAreFoundByLines) {
    const std::vector<Point> points{{-1, 0, 0}, {1, 0, 0}, {-3, 1, 0},
                                    {0, 2, 0},  {3, 1, 0}, {0, -1, 0}};
    const Surface surface(kernel::families::book(6), points);
    const PlaneCut cut = most_pieces(surface.view());
    EXPECT_EQ(cut.pieces(), 4);  // three pages above the poles and one below, with them
    EXPECT_EQ(std::max(cut.above, cut.below), 3);
}

TEST(PlanePieces, OfPointsOnALineThereIsNoPlane) {
    const std::vector<Point> points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    EXPECT_EQ(most_pieces(Surface(kernel::families::tetrahedron(), points).view()).pieces(), 0);
}

// A torus all of whose seven vertices are neighbours cannot be cut into more than two pieces,
// wherever its points are (Kuehnel).
TEST(PlanePieces, OfTheTorusOfSevenVerticesAreTwo) {
    std::vector<std::array<Index, 3>> faces;
    for (Index i = 0; i < 7; ++i) {
        faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
        faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
    }
    const Triangulation torus = build(kernel::glue_faces(faces, 7).gluing).value();
    ASSERT_EQ(torus.genus(), 1);
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        EXPECT_EQ(most_pieces(Surface(torus, random_points(7, seed)).view()).pieces(), 2);
}

}  // namespace
}  // namespace tightflip::properties
