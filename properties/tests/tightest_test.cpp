// Which triangulations have the least total absolute curvature: every labelled one of few convex
// points, decided by their edges.

#include "labelled_surfaces.hpp"
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/kernel/families.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::CriterionKind;
using geometry::Point;
using geometry::Surface;
using kernel::Halfedge;
using kernel::Index;
using kernel::Triangulation;

using EdgeSet = std::multiset<std::pair<Index, Index>>;

EdgeSet edges_of(const Triangulation& surface) {
    EdgeSet edges;
    for (Index e = 0; e < surface.edge_count(); ++e) {
        const Halfedge h = halfedge_of(kernel::Edge{e});
        edges.insert(std::minmax({surface.origin(h).id, surface.target(h).id}));
    }
    return edges;
}

TEST(Tightest, OfConvexDataInGeneralPositionIsTheHullAndOnlyTheHull) {
    for (const Index vertices : {4, 5, 6}) {
        const LabelledSurfaces all =
            reached_by_flips(vertices == 4 ? kernel::families::tetrahedron()
                                           : kernel::families::double_wheel(vertices));
        EXPECT_EQ(all.size(), vertices == 4 ? 8U : vertices == 5 ? 160U : 5280U);
        for (const std::uint64_t seed : {1, 2, 3, 4}) {
            const Surface hull = geometry::data_sets::random_sphere(vertices, seed);
            const std::vector<Point> points(hull.points().begin(), hull.points().end());
            const EdgeSet hull_edges = edges_of(hull.triangulation());
            int minima = 0;
            double next_best = 1e9;
            for (const Triangulation& triangulation : all) {
                const Surface surface(triangulation, points);
                const double value =
                    make_criterion(CriterionKind::tight, surface.view())->value().first();
                if (edges_of(triangulation) == hull_edges) {
                    EXPECT_NEAR(value, 4 * std::numbers::pi, 1e-12);
                    ++minima;
                } else {
                    next_best = std::min(next_best, value);
                }
            }
            EXPECT_EQ(minima, 2);  // the hull, and the hull turned inside out
            EXPECT_GT(next_best, 4 * std::numbers::pi + 1e-6);
        }
    }
}

TEST(Tightest, OfConvexDataHasLeastWeightedMeanCurvatureButNotLeastAreaNorEdgeLength) {
    // By Crofton's formula the hull has the least length-weighted mean curvature; area and edge
    // length are other questions (the paper's Figure 4).
    const LabelledSurfaces all = reached_by_flips(kernel::families::double_wheel(6));
    const auto smaller_than_hull = [&](const Surface& hull, CriterionKind kind) {
        const std::vector<Point> points(hull.points().begin(), hull.points().end());
        const double least = make_criterion(kind, hull.view())->value().first();
        return std::ranges::count_if(all, [&](const Triangulation& triangulation) {
            const Surface surface(triangulation, points);
            return make_criterion(kind, surface.view())->value().first() < least - 1e-9;
        });
    };
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Surface hull = geometry::data_sets::random_sphere(6, seed);
        EXPECT_EQ(smaller_than_hull(hull, CriterionKind::mean_weighted), 0);
        EXPECT_GT(smaller_than_hull(hull, CriterionKind::area), 0);
    }
    const Surface skewed = geometry::data_sets::skewed_cylinder(3);
    EXPECT_GT(smaller_than_hull(skewed, CriterionKind::area), 0);
    EXPECT_GT(smaller_than_hull(skewed, CriterionKind::edge_length), 0);
}

}  // namespace
}  // namespace tightflip::properties
