#include "shapes.hpp"
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/functional_surface.hpp>

#include <algorithm>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

TEST(FunctionalSurface, IsTheDelaunayTriangulationClosedBelow) {
    for (const std::size_t count : {3U, 4U, 10U, 200U}) {
        const auto points = random_points(count, count);
        const FunctionalSurface functional = functional_surface(points).value();
        const auto [surface, marked] = functional;
        const Triangulation& t = surface.triangulation();
        EXPECT_EQ(t.genus(), 0);
        EXPECT_EQ(marked.id, static_cast<Index>(count));
        EXPECT_EQ(t.vertex_count(), static_cast<Index>(count) + 1);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_EQ(surface.points()[i], points[i]);

        Faces finite;
        for (const Halfedge h : t.faces()) {
            std::array<Index, 3> corners{t.origin(h).id, t.target(h).id, t.opposite(h).id};
            std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
            if (std::ranges::count(corners, marked.id) == 0) finite.push_back(corners);
        }
        std::ranges::sort(finite);
        const auto plane = delaunay_in_plane(points).value();
        EXPECT_EQ(finite, plane.faces);

        std::set<Index> link;
        for (const Vertex v : t.neighbours(t.outgoing()[count]))
            link.insert(v.id);
        EXPECT_EQ(link, std::set<Index>(plane.boundary.begin(), plane.boundary.end()));
    }
}

TEST(FunctionalSurface, TheMarkedVertexIsFarBelow) {
    for (const double height : {0.0, 1e9, -1e12, 1e300}) {
        auto points = random_points(20, 2);
        for (Point& point : points)
            point.z() += height;
        const auto [surface, marked] = functional_surface(points).value();
        for (const Point& point : points)
            EXPECT_LT(surface.point(marked).z(), point.z() - 1);
    }
    const double most = std::numeric_limits<double>::max();
    const auto extreme = functional_surface({{-most, -most, -most}, {most, 0, most}, {0, most, 0}});
    EXPECT_TRUE(extreme.value().surface.points().back().allFinite());
}

TEST(FunctionalSurface, RefusesAsThePlaneDoes) {
    EXPECT_EQ(functional_surface({{0, 0, 0}, {1, 1, 5}, {2, 2, 0}}).refusal().fault,
              DataFault::collinear_points);
    EXPECT_EQ(functional_surface({{0, 0, 0}, {1, 1, 5}, {2, 0, 0}, {0, 0, 1}}).refusal(),
              (DataRefusal{DataFault::coincident_points, {0, 3}}));
}

}  // namespace
}  // namespace tightflip::geometry
