// The bundled instances against statements of the paper's section 5: docs/findings/tight-*,
// global-hidden and tightest-not-tight.

#include "labelled_surfaces.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/general_position.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/surface_file.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/negative_side.hpp>
#include <tightflip/properties/optimisation_claims.hpp>
#include <tightflip/properties/plane_pieces.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::CriterionKind;
using geometry::EdgeShape;
using geometry::FlipOrder;
using geometry::Point;
using geometry::SelfIntersections;
using geometry::Surface;
using kernel::Edge;
using kernel::FlipLog;
using kernel::Index;
using kernel::Triangulation;
using kernel::Vertex;
using testing::HasSubstr;

std::filesystem::path finding(const std::string& name) {
    return std::filesystem::path(TIGHTFLIP_FINDINGS) / name;
}

Surface surface_in(const std::string& name) {
    return geometry::read_surface_file(finding(name));
}

FlipLog log_in(const std::string& name) {
    return kernel::parse_flip_log(kernel::read_file(finding(name)), name);
}

std::vector<Point> points_of(const Surface& surface) {
    return {surface.points().begin(), surface.points().end()};
}

double tight(const Surface& surface) {
    return make_criterion(CriterionKind::tight, surface.view())->value().first();
}

SelfIntersections intersections(const Surface& surface) {
    return find_self_intersections(surface.view());
}

bool is_simple(const Surface& surface) {
    return audit(surface.triangulation()).is_simple().value();
}

void expect_convex_data_in_general_position(const Surface& surface) {
    EXPECT_TRUE(geometry::general_position(surface.points()).holds());
    EXPECT_TRUE(geometry::is_convex_data(surface.points()));
}

TEST(TightStuck, FromAnEmbeddedStartLocalSearchEndsBesideTheHull) {
    const Surface start = surface_in("tight-stuck-start.txt");
    const FlipLog log = log_in("tight-stuck-path.log");
    ASSERT_EQ(start.triangulation().vertex_count(), 5);
    ASSERT_EQ(start.triangulation(), log.start);
    expect_convex_data_in_general_position(start);
    EXPECT_TRUE(geometry::is_embedded(start.view()));
    EXPECT_FALSE(tight_is_global(start));

    ASSERT_EQ(log.flips.size(), 1U);
    const Surface end(replay(log).surface, points_of(start));
    EXPECT_LT(tight(end), tight(start) - 0.7);
    EXPECT_EQ(convexity(end.view()), Convexity::none);
    EXPECT_GT(measure(end.view()).volume, 0);
    EXPECT_TRUE(is_simple(end));
    EXPECT_EQ(intersections(end).local_count, 2);
    EXPECT_EQ(intersections(end).global_count, 0);
    EXPECT_FALSE(flips_keep_intersections_local(start, log.flips));
    // The end is a strict minimum: every flip raises Tight, and not by a rounding.
    const auto criterion = make_criterion(CriterionKind::tight, end.view());
    for (Index e = 0; e < end.triangulation().edge_count(); ++e) {
        if (!end.triangulation().can_flip({e})) continue;
        EXPECT_GT(criterion->change({e}).first(), 0.1) << "edge " << e;
    }

    const auto stuck = tight_search_ends_convex(start, FlipOrder::first);
    ASSERT_TRUE(stuck);
    EXPECT_EQ(stuck->step, 1U);
    // Whoever takes the best flip there is gets to the hull from there, but not from the end.
    EXPECT_FALSE(tight_search_ends_convex(start, FlipOrder::best));
    EXPECT_TRUE(tight_search_ends_convex(end, FlipOrder::best));
}

struct Crossing {
    std::string name;
    std::int64_t local_before = 0;
};

class TightMakesGlobal : public testing::TestWithParam<Crossing> {};

TEST_P(TightMakesGlobal, SelfIntersectionsByOneFlipThatLowersIt) {
    const Surface start = surface_in("tight-" + GetParam().name + ".txt");
    const FlipLog log = log_in("tight-" + GetParam().name + ".log");
    ASSERT_EQ(start.triangulation().vertex_count(), 6);
    ASSERT_EQ(start.triangulation(), log.start);
    expect_convex_data_in_general_position(start);
    EXPECT_TRUE(is_simple(start));
    EXPECT_EQ(intersections(start).local_count, GetParam().local_before);
    EXPECT_EQ(intersections(start).global_count, 0);

    ASSERT_EQ(log.flips.size(), 1U);
    const Surface end(replay(log).surface, points_of(start));
    EXPECT_LT(tight(end), tight(start) - 0.1);
    EXPECT_TRUE(is_simple(end));
    EXPECT_EQ(intersections(end).global_count, 1);
    for (const geometry::FacePair& pair : intersections(end).pairs)
        EXPECT_TRUE(faces_meet(end.view(), pair.first, pair.second));

    const auto refuted = flips_keep_intersections_local(start, log.flips);
    ASSERT_TRUE(refuted);
    EXPECT_EQ(refuted->step, 1U);
    EXPECT_THAT(describe(*refuted), HasSubstr("after 1 flips: 1105 flips_keep_inter"));
}

INSTANTIATE_TEST_SUITE_P(, TightMakesGlobal,
                         testing::Values(Crossing{"local-to-global", 2},
                                         Crossing{"embedded-to-global", 0}));

TEST(GlobalHidden, SelfIntersectionShowsNoNegativeSide) {
    const Surface surface = surface_in("global-hidden.txt");
    ASSERT_EQ(surface.triangulation().vertex_count(), 6);
    expect_convex_data_in_general_position(surface);
    EXPECT_TRUE(is_simple(surface));
    EXPECT_EQ(intersections(surface).global_count, 1);
    const std::vector<Tetrahedron> tetrahedra{{Vertex{2}, Vertex{0}, Vertex{3}, Vertex{4}},
                                              {Vertex{1}, Vertex{2}, Vertex{3}, Vertex{5}},
                                              {Vertex{3}, Vertex{2}, Vertex{4}, Vertex{5}}};
    EXPECT_TRUE(is_sum_of_tetrahedra(surface.view(), tetrahedra));
    EXPECT_FALSE(find_negative_view(surface.view(), 20'000, 1));
    EXPECT_TRUE(global_intersections_show_the_negative_side(surface, 3));
}

// Every edge is convex, and yet the surface is not: it winds twice about an edge.
TEST(GlobalHidden, SurfaceHasConvexEdgesOnly) {
    const Surface surface = surface_in("global-hidden.txt");
    for (Index e = 0; e < surface.triangulation().edge_count(); ++e)
        EXPECT_EQ(edge_shape(surface.view(), Edge{e}), EdgeShape::convex);
    const geometry::SurfaceConvexity convex = is_convex_surface(surface.view());
    EXPECT_FALSE(convex);
    EXPECT_TRUE(convex.vertex.is_valid());
}

TEST(TightestNotTight, IsCutIntoThreePiecesByAPlane) {
    const Surface surface = surface_in("tightest-not-tight.txt");
    ASSERT_EQ(surface.triangulation().vertex_count(), 5);
    EXPECT_TRUE(geometry::general_position(surface.points()).holds());
    EXPECT_FALSE(geometry::is_convex_data(surface.points()));
    EXPECT_TRUE(geometry::is_embedded(surface.view()));
    const double value = tight(surface);
    EXPECT_GT(value, 4 * std::numbers::pi + 0.5);
    // None of all triangulations of these points is less curved, so it is Tightest.
    for (const Triangulation& other : reached_by_flips(surface.triangulation()))
        EXPECT_GT(tight(Surface(other, points_of(surface))), value - 1e-9);
    EXPECT_EQ(most_pieces(surface.view()).pieces(), 3);
    EXPECT_FALSE(tight_is_two_piece(surface));
}

// The embedded convex triangulation that no conventional flip leaves (section 4.2.1): the EDF
// lowers Tight there, but not among embedded surfaces.
TEST(TightWhileEmbedded, IsStuckWhereNoFlipKeepsTheSurfaceEmbedded) {
    const Surface isolated = surface_in("embedded-convex-isolated.txt");
    EXPECT_FALSE(tight_is_global(isolated));
    EXPECT_TRUE(tight_is_global_while_embedded(isolated));
    EXPECT_FALSE(tight_is_global_while_embedded(surface_in("embedded-convex-hull.txt")));
}

// Two more vertices within a face, which is in the hull's boundary, can be joined in several ways.
// These flips keep the surface embedded, and Tight as it is: that is no way down.
TEST(TightWhileEmbedded, IsStuckWhereFlipsLeaveItAsItIs) {
    const Surface isolated = surface_in("embedded-convex-isolated.txt");
    std::vector<std::array<Index, 3>> faces;
    const Triangulation& triangulation = isolated.triangulation();
    for (const kernel::Halfedge h : triangulation.faces()) {
        faces.push_back(
            {triangulation.origin(h).id, triangulation.target(h).id, triangulation.opposite(h).id});
    }
    std::vector<Point> points;
    for (const Point& point : isolated.points())
        points.emplace_back(64 * point);
    const auto at = [&](Index v) { return points[static_cast<std::size_t>(v)]; };
    const auto [a, b, c] = faces.front();
    points.emplace_back((at(a) + at(b) + 2 * at(c)) / 4);
    points.emplace_back((2 * at(a) + at(b) + at(8)) / 4);
    faces.erase(faces.begin());
    faces.insert(faces.end(), {{b, c, 8}, {c, a, 8}, {a, b, 9}, {b, 8, 9}, {8, a, 9}});
    const Surface surface(build(kernel::glue_faces(faces, 10).gluing).value(), points);
    ASSERT_TRUE(geometry::is_convex_data(points));
    ASSERT_TRUE(is_embedded(surface.view()));

    const auto criterion = make_criterion(CriterionKind::tight, surface.view());
    double least = 1;
    for (Index e = 0; e < surface.triangulation().edge_count(); ++e) {
        if (!flip_keeps_embedded(surface.view(), {e})) continue;
        least = std::min(least, criterion->change({e}).first());
    }
    EXPECT_NEAR(least, 0, 1e-12);
    EXPECT_TRUE(tight_is_global_while_embedded(surface));
}

}  // namespace
}  // namespace tightflip::properties
