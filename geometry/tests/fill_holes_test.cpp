#include "fill_holes.hpp"

#include "reading.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/soup_gluing.hpp>

#include <limits>

namespace tightflip::geometry {
namespace {

/// A surface's faces as a soup, with the gluing where asked; faces f stand on line 1000 + f.
TriangleSoup soup_of(const Surface& surface, bool with_gluing) {
    TriangleSoup soup;
    soup.source = "mesh.ply";
    soup.points.assign(surface.points().begin(), surface.points().end());
    soup.point_positions.assign(soup.points.size(), 1);
    const Triangulation& t = surface.triangulation();
    std::vector<Index> side(static_cast<std::size_t>(t.halfedge_count()));
    for (const Halfedge first : t.faces()) {
        Halfedge h = first;
        auto& corners = soup.triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = t.origin(h).id;
            side[static_cast<std::size_t>(h.id)] =
                3 * static_cast<Index>(soup.triangles.size() - 1) + static_cast<Index>(i);
            h = t.next(h);
        }
        soup.triangle_positions.push_back(999 + soup.triangles.size());
    }
    if (!with_gluing) return soup;
    soup.glued_sides.resize(soup.triangles.size());
    for (std::size_t h = 0; h < side.size(); ++h) {
        soup.glued_sides[static_cast<std::size_t>(side[h] / 3)]
                        [static_cast<std::size_t>(side[h] % 3)] = side[h ^ 1];
    }
    return soup;
}

/// The soup without one of its faces.
void remove_face(TriangleSoup& soup, std::size_t face) {
    for (auto& sides : soup.glued_sides) {
        for (Index& side : sides) {
            if (side / 3 == static_cast<Index>(face) || side < 0) {
                side = -1;
            } else if (side / 3 > static_cast<Index>(face)) {
                side -= 3;
            }
        }
    }
    const auto at = [&](auto& list) { return list.begin() + static_cast<std::ptrdiff_t>(face); };
    if (!soup.glued_sides.empty()) soup.glued_sides.erase(at(soup.glued_sides));
    soup.triangles.erase(at(soup.triangles));
    soup.triangle_positions.erase(at(soup.triangle_positions));
}

void expect_sound(const TriangleSoup& soup) {
    EXPECT_EQ(soup.points.size(), soup.point_positions.size());
    EXPECT_EQ(soup.triangles.size(), soup.triangle_positions.size());
    EXPECT_TRUE(soup.glued_sides.empty() || soup.glued_sides.size() == soup.triangles.size());
}

TEST(FillHoles, OneFaceGoneBecomesAFanAtTheMean) {
    const Surface cube_surface = cube();
    for (const bool with_gluing : {false, true}) {
        TriangleSoup soup = soup_of(cube_surface, with_gluing);
        const auto gone = soup.triangles[4];
        remove_face(soup, 4);
        const FilledHoles filled = fill_holes(soup);
        EXPECT_EQ(filled.holes, 1);
        EXPECT_EQ(filled.faces, 3);
        EXPECT_EQ(filled.sides_left_open, 0);
        expect_sound(soup);
        const kernel::AuditReport report = audit(glue(soup));
        EXPECT_TRUE(report.is_valid());
        EXPECT_TRUE(report.coherently_stored);
        EXPECT_EQ(report.topology.genus, 0);
        Point mean = Point::Zero();
        for (const Index v : gone)
            mean += cube_surface.point({v}) / 3;
        EXPECT_LT((soup.points.back() - mean).norm(), 1e-15);
        EXPECT_EQ(soup.point_positions.back(), soup.triangle_positions[11]);
    }
}

TEST(FillHoles, ManyFacesGoneAreFilledOnEveryFamily) {
    for (const Triangulation& triangulation : all_families()) {
        const bool simple = kernel::audit(triangulation).is_simple().value();
        const Surface surface = with_random_points(triangulation, 7);
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            kernel::RandomStream random(seed);
            TriangleSoup soup = soup_of(surface, !simple);
            const auto first = random.below(static_cast<std::uint32_t>(soup.triangles.size()));
            remove_face(soup, first);
            const FilledHoles filled = fill_holes(soup);
            EXPECT_EQ(filled.holes, 1);
            expect_sound(soup);
            const kernel::AuditReport report = audit(glue(soup));
            EXPECT_TRUE(report.is_valid());
            EXPECT_TRUE(report.coherently_stored);
            EXPECT_EQ(report.topology.genus, triangulation.genus());
            EXPECT_EQ(report.topology.vertices, triangulation.vertex_count() + 1);
        }
    }
}

TEST(FillHoles, HolesThatTouchAtAVertexAreFilledEachForItself) {
    // The octahedron without two opposite faces of those at vertex 5.
    TriangleSoup soup = soup_of(octahedron(), false);
    const auto has = [&](std::size_t f, Index v) {
        return std::ranges::count(soup.triangles[f], v) > 0;
    };
    for (const auto& [x, y] : {std::pair{0, 2}, std::pair{1, 3}}) {
        for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
            if (!has(f, x) || !has(f, y) || !has(f, 5)) continue;
            remove_face(soup, f);
            break;
        }
    }
    ASSERT_EQ(soup.triangles.size(), 6U);
    const FilledHoles filled = fill_holes(soup);
    EXPECT_EQ(filled.holes, 2);
    EXPECT_EQ(filled.faces, 6);
    EXPECT_TRUE(audit(glue(soup)).is_valid());
}

TEST(FillHoles, ManyHolesMayTouchAtOneVertex) {
    // The bipyramid over a hexagon without every other face at each of its poles in turn.
    const Surface wheel = with_random_points(kernel::families::double_wheel(8), 3);
    for (Index pole = 0; pole < 8; ++pole) {
        TriangleSoup soup = soup_of(wheel, false);
        const Halfedge spoke = wheel.triangulation().outgoing()[static_cast<std::size_t>(pole)];
        if (wheel.triangulation().degree(spoke) != 6) continue;
        Triangles gone;
        Halfedge h = spoke;
        for (int i = 0; i < 6; ++i, h = twin(wheel.triangulation().previous(h))) {
            const Triangulation& t = wheel.triangulation();
            if (i % 2 == 0) gone.push_back({t.origin(h).id, t.target(h).id, t.opposite(h).id});
        }
        for (auto corners : gone) {
            std::ranges::sort(corners);
            const auto face = std::ranges::find_if(soup.triangles, [&](auto triangle) {
                std::ranges::sort(triangle);
                return triangle == corners;
            });
            remove_face(soup, static_cast<std::size_t>(face - soup.triangles.begin()));
        }
        const FilledHoles filled = fill_holes(soup);
        EXPECT_EQ(filled.holes, 3);
        EXPECT_EQ(filled.sides_left_open, 0);
        EXPECT_TRUE(audit(glue(soup)).is_valid());
    }
}

TEST(FillHoles, FacesNeedNotBeOrientedAlike) {
    TriangleSoup soup = soup_of(octahedron(), false);
    remove_face(soup, 0);
    remove_face(soup, 3);
    for (std::size_t f = 0; f < soup.triangles.size(); f += 2)
        std::swap(soup.triangles[f][0], soup.triangles[f][1]);
    (void)fill_holes(soup);
    const kernel::AuditReport report = audit(glue(soup));
    EXPECT_TRUE(report.is_valid());
    EXPECT_FALSE(report.coherently_stored);
}

TEST(FillHoles, ASlitBetweenTwoVerticesGetsAFanOfTwo) {
    // Where the gluing is given, sides may be open although their ends are the same.
    TriangleSoup soup = soup_of(octahedron(), true);
    const Index other = soup.glued_sides[2][1];
    soup.glued_sides[2][1] = -1;
    soup.glued_sides[static_cast<std::size_t>(other / 3)][static_cast<std::size_t>(other % 3)] = -1;
    const FilledHoles filled = fill_holes(soup);
    EXPECT_EQ(filled.holes, 1);
    EXPECT_EQ(filled.faces, 2);
    const kernel::AuditReport report = audit(glue(soup));
    EXPECT_TRUE(report.is_valid());
    EXPECT_EQ(report.degrees.value().degree_two_vertices, 1);
    EXPECT_EQ(report.parallels.value().pairs_joined_twice, 1);
}

TEST(FillHoles, ASideThatBelongsToNoLoopStaysOpen) {
    // Three faces at one edge: that edge is no boundary, and the others' ends are odd.
    TriangleSoup soup;
    soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
    soup.point_positions = {1, 2, 3, 4, 5};
    soup.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    soup.triangle_positions = {6, 7, 8};
    const FilledHoles filled = fill_holes(soup);
    EXPECT_EQ(filled.holes, 1);
    EXPECT_EQ(filled.faces, 4);
    EXPECT_EQ(filled.sides_left_open, 2);
    expect_sound(soup);
}

TEST(FillHoles, TheMeanOfLargestNumbersIsFinite) {
    constexpr double most = std::numeric_limits<double>::max();
    TriangleSoup soup;
    soup.points = {{most, most, -most}, {most, -most, most}, {most, most, most}};
    soup.point_positions = {1, 2, 3};
    soup.triangles = {{0, 1, 2}};
    soup.triangle_positions = {4};
    (void)fill_holes(soup);
    EXPECT_TRUE(soup.points.back().allFinite());
    EXPECT_TRUE(audit(glue(soup)).is_valid());
}

TEST(FillHoles, NothingOpenNothingChanged) {
    TriangleSoup soup = soup_of(cube(), false);
    const FilledHoles filled = fill_holes(soup);
    EXPECT_EQ(filled.holes + filled.faces + filled.sides_left_open, 0);
    EXPECT_EQ(soup.triangles.size(), 12U);
}

}  // namespace
}  // namespace tightflip::geometry
