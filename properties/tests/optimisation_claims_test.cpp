#include "labelled_surfaces.hpp"
#include "order_type_seeds.hpp"
#include "order_types.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/general_position.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/embedded_triangulations.hpp>
#include <tightflip/properties/negative_side.hpp>
#include <tightflip/properties/optimisation_claims.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::CriterionKind;
using geometry::FlatEdges;
using geometry::FlipOrder;
using geometry::Point;
using geometry::Surface;
using geometry::SurfaceView;
using kernel::Edge;
using kernel::Index;
using kernel::Triangulation;

std::string said(const std::optional<OptimisationFinding>& finding) {
    return finding ? describe(*finding) : "";
}

/// The labelled spheres on so many vertices, parallel edges included.
LabelledSurfaces all_spheres(Index vertices) {
    return reached_by_flips(vertices == 4 ? kernel::families::tetrahedron()
                                          : kernel::families::double_wheel(vertices));
}

std::vector<Point> points_of(const Surface& surface) {
    return {surface.points().begin(), surface.points().end()};
}

/// One point set for each order type of convex points in general position.
std::vector<std::vector<Point>> convex_order_types(std::size_t count,
                                                   std::span<const std::uint64_t> seeds) {
    std::vector<std::vector<Point>> sets;
    for (const std::uint64_t seed : seeds) {
        std::vector<Point> points = points_of_seed(count, seed);
        if (geometry::is_convex_data(points)) sets.push_back(std::move(points));
    }
    return sets;
}

void expect_tight_is_global(const std::vector<Point>& points, std::span<const FaceSet> spheres,
                            bool while_embedded) {
    const EmbeddedTriangulations embedded(points, spheres);
    std::size_t not_convex = 0;
    for (const FaceSet sphere : embedded.all()) {
        const Surface surface = embedded.surface(sphere);
        not_convex += convexity(surface.view()) == Convexity::none ? 1U : 0U;
        ASSERT_EQ(said(tight_is_global(surface)), "");
        ASSERT_EQ(said(concave_flips_do_not_raise_tight(surface)), "");
        if (while_embedded) {
            ASSERT_EQ(said(tight_is_global_while_embedded(surface)), "");
        }
    }
    EXPECT_EQ(not_convex + 1, embedded.all().size());
}

TEST(TightIsGlobal, AmongAllEmbeddedTriangulationsOfUpToSevenConvexPoints) {
    const auto check = [](std::size_t count, std::span<const std::uint64_t> seeds,
                          std::size_t order_types) {
        const std::vector<FaceSet> spheres = simple_spheres(static_cast<Index>(count));
        const auto sets = convex_order_types(count, seeds);
        EXPECT_EQ(sets.size(), order_types);
        for (const std::vector<Point>& points : sets)
            expect_tight_is_global(points, spheres, true);
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            expect_tight_is_global(
                points_of(geometry::data_sets::random_sphere(static_cast<Index>(count), seed)),
                spheres, true);
        }
    };
    check(5, seeds_of_5_points, 1);
    check(6, seeds_of_6_points, 2);
    check(7, seeds_of_7_points, 30);
}

TEST(TightIsGlobal, AmongAllEmbeddedTriangulationsOfEightConvexPoints) {
    const std::vector<FaceSet> spheres = simple_spheres(8);
    for (const std::uint64_t seed : {1U, 2U}) {
        expect_tight_is_global(points_of(geometry::data_sets::random_ellipsoid(8, seed)), spheres,
                               false);
    }
}

/// A walk of flips that keep the surface embedded.
void walk(Surface& surface, int attempts, kernel::RandomStream& random) {
    const auto edges = static_cast<std::uint32_t>(surface.triangulation().edge_count());
    for (int i = 0; i < attempts; ++i) {
        const Edge e{static_cast<Index>(random.below(edges))};
        if (flip_keeps_embedded(surface.view(), e)) {
            static_cast<void>(surface.triangulation().flip(e));
        }
    }
}

TEST(TightIsGlobal, OnWalksAmongEmbeddedTriangulationsOfMorePoints) {
    int not_convex = 0;
    for (const Index vertices : {9, 10, 12, 20, 40}) {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            Surface surface = geometry::data_sets::random_sphere(vertices, seed);
            kernel::RandomStream random(seed);
            for (int step = 0; step < 20; ++step) {
                walk(surface, 2 * vertices, random);
                ASSERT_TRUE(is_embedded(surface.view()));
                not_convex += convexity(surface.view()) == Convexity::none ? 1 : 0;
                ASSERT_EQ(said(tight_is_global(surface)), "") << vertices << ", " << seed;
                ASSERT_EQ(said(concave_flips_do_not_raise_tight(surface)), "");
            }
        }
    }
    EXPECT_GT(not_convex, 900);
}

// Points within facets and edges, facets with many corners: the claim is not for general position
// alone.
TEST(TightIsGlobal, OnWalksOnDataNotInGeneralPosition) {
    const std::vector<Point> pyramid{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0},
                                     {0, 0, 5}, {0, 0, 0},  {1, 0, 0}};
    int not_convex = 0;
    for (const Surface& convex :
         {geometry::convex_surface(pyramid).value(), geometry::data_sets::cube_grid(8),
          geometry::data_sets::cube_grid(26)}) {
        Surface surface = convex;
        kernel::RandomStream random(1);
        for (int step = 0; step < 60; ++step) {
            walk(surface, convex.triangulation().edge_count(), random);
            not_convex += convexity(surface.view()) == Convexity::none ? 1 : 0;
            ASSERT_EQ(said(tight_is_global(surface)), "");
            ASSERT_EQ(said(concave_flips_do_not_raise_tight(surface)), "");
        }
    }
    EXPECT_GT(not_convex, 120);
}

// The premises: nothing is said of other surfaces, though no flip lowers Tight.
TEST(TightIsGlobal, SpeaksOfEmbeddedSpheresOnConvexDataOnly) {
    const Surface prism = geometry::data_sets::schoenhardt_prism();
    EXPECT_FALSE(tight_is_global(geometry::data_sets::bumpy_torus(36, 1)));
    // A tetrahedron with a point inside, which is Tightest.
    const Surface pit(kernel::families::stacked(5, 1),
                      {{0, 0, 1}, {0, 0, 9}, {9, 0, -3}, {-5, 8, -3}, {-5, -8, -3}});
    for (const Triangulation& other : reached_by_flips(pit.triangulation())) {
        ASSERT_FALSE(tight_is_global(Surface(other, points_of(pit))));
        ASSERT_FALSE(tight_search_ends_convex(Surface(other, points_of(pit)), FlipOrder::best));
        ASSERT_FALSE(concave_flips_do_not_raise_tight(Surface(other, points_of(pit))));
    }
    EXPECT_EQ(said(tight_is_global(prism)), "");
    EXPECT_EQ(convexity(prism.view()), Convexity::none);
}

// Inside out every edge is concave, and flips raise Tight.
TEST(ConcaveFlips, AreSpokenOfWhereFacesTurnOutwardsOnly) {
    const Surface hull = geometry::data_sets::random_sphere(8, 1);
    std::vector<Point> points;
    for (const Point& point : hull.points())
        points.emplace_back(-point);
    const Surface inside_out(hull.triangulation(), points);
    ASSERT_TRUE(is_embedded(inside_out.view()));
    const auto tight = make_criterion(CriterionKind::tight, inside_out.view());
    for (Index e = 0; e < hull.triangulation().edge_count(); ++e) {
        ASSERT_EQ(edge_shape(inside_out.view(), Edge{e}), geometry::EdgeShape::concave);
        EXPECT_GT(tight->change({e}).first(), 1e-3);
    }
    EXPECT_EQ(said(concave_flips_do_not_raise_tight(inside_out)), "");
}

// What refutes it, counted (docs/theory.md): all triangulations of five points have local
// self-intersections at most, since two of their faces share a corner.
TEST(TightSearch, FromFivePointsIsStuckAtTimes) {
    const Surface hull = geometry::data_sets::random_sphere(5, 6);
    int stuck = 0;
    for (const Triangulation& start : all_spheres(5)) {
        const Surface surface(start, points_of(hull));
        ASSERT_EQ(find_self_intersections(surface.view(), 0).global_count, 0);
        ASSERT_FALSE(concave_flips_do_not_raise_tight(surface));
        const auto finding = tight_search_ends_convex(surface, FlipOrder::best);
        stuck += finding ? 1 : 0;
        if (finding) {
            EXPECT_EQ(finding->claim, OptimisationClaim::tight_search_ends_convex);
        }
    }
    EXPECT_GT(stuck, 10);
    EXPECT_LT(stuck, 100);
    EXPECT_FALSE(tight_search_ends_convex(hull, FlipOrder::first));
    // Inside out it is as tight.
    std::vector<Point> reflected;
    for (const Point& point : hull.points())
        reflected.emplace_back(-point);
    EXPECT_FALSE(
        tight_search_ends_convex(Surface(hull.triangulation(), reflected), FlipOrder::first));
    EXPECT_FALSE(tight_search_ends_convex(geometry::data_sets::twisted_prism(4), FlipOrder::first));
}

TEST(FlipsKeepIntersectionsLocal, SpeaksOfFlipsThatLowerTightOnly) {
    const Surface hull = geometry::data_sets::random_sphere(8, 1);
    const auto edges = static_cast<std::uint32_t>(hull.triangulation().edge_count());
    kernel::RandomStream random(1);
    std::vector<Edge> script;
    Surface tangled = hull;
    while (find_self_intersections(tangled.view(), 0).global_count == 0) {
        const Edge e{static_cast<Index>(random.below(edges))};
        if (tangled.triangulation().flip(e)) script.push_back(e);
        ASSERT_LT(script.size(), 1000U);
    }
    EXPECT_FALSE(flips_keep_intersections_local(hull, script));
    // Down to the hull nothing happens that it could object to.
    Triangulation prism = geometry::data_sets::twisted_prism(3).triangulation();
    const Surface start = geometry::data_sets::twisted_prism(3);
    const auto tight = make_criterion(CriterionKind::tight, {prism.table(), start.points()});
    const auto run = optimise(prism, start.points(), *tight);
    ASSERT_EQ(convexity({prism.table(), start.points()}), Convexity::convex);
    EXPECT_FALSE(flips_keep_intersections_local(start, run.flips));
}

// Along the flips of whole searches: the first surface that meets itself globally is found.
TEST(FlipsKeepIntersectionsLocal, FindsTheFirstFlipThatDoesNot) {
    int later = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Surface start = geometry::data_sets::random_sphere(20, seed);
        kernel::RandomStream random(seed);
        walk(start, 400, random);
        Surface surface = start;
        const auto tight = make_criterion(CriterionKind::tight, surface.view());
        const auto run = optimise(surface.triangulation(), start.points(), *tight);
        surface = start;
        std::size_t expected = 0;
        for (std::size_t i = 0; expected == 0 && i < run.flips.size(); ++i) {
            static_cast<void>(surface.triangulation().flip(run.flips[i]));
            if (find_self_intersections(surface.view(), 0).global_count > 0) expected = i + 1;
        }
        const auto finding = flips_keep_intersections_local(start, run.flips);
        EXPECT_EQ(finding ? finding->step : 0, expected) << "seed " << seed;
        later += expected > 1 ? 1 : 0;
    }
    EXPECT_GT(later, 5);
}

// Of the triangulations of six points that meet themselves globally most show the inner side, and
// many are proved not to.
TEST(GlobalIntersections, ShowTheNegativeSideOrAreSumsOfTetrahedra) {
    const Surface hull = geometry::data_sets::random_sphere(6, 1);
    int global = 0;
    int shown = 0;
    int hidden = 0;
    for (const Triangulation& triangulation : all_spheres(6)) {
        const Surface surface(triangulation, points_of(hull));
        const bool is_global = find_self_intersections(surface.view(), 0).global_count > 0;
        const bool is_hidden = bool(global_intersections_show_the_negative_side(surface, 5));
        if (!is_global) {
            ASSERT_FALSE(is_hidden);
            continue;
        }
        const bool is_shown = bool(find_negative_view(surface.view(), 300, 1));
        ASSERT_FALSE(is_shown && is_hidden);
        ++global;
        hidden += is_hidden ? 1 : 0;
        shown += is_shown ? 1 : 0;
    }
    EXPECT_EQ(global, 908);
    EXPECT_EQ(hidden, 300);
    EXPECT_GT(shown, 500);
    EXPECT_LE(shown + hidden, global);
}

/// How many of the spheres are convex on the points; all of these differ in flat edges only.
std::size_t count_convex(const std::vector<Point>& points, const LabelledSurfaces& spheres,
                         FlatEdges flat) {
    std::vector<Surface> convex;
    for (const Triangulation& sphere : spheres) {
        if (is_convex_surface({sphere.table(), points}, flat)) convex.emplace_back(sphere, points);
    }
    for (const Surface& surface : convex)
        EXPECT_EQ(said(convex_is_unique(convex.front(), surface)), "");
    return convex.size();
}

TEST(ConvexTriangulation, IsUniqueInGeneralPosition) {
    for (const Index vertices : {4, 5, 6}) {
        const LabelledSurfaces spheres = all_spheres(vertices);
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
            const Surface hull = vertices % 2 == 0
                                     ? geometry::data_sets::random_sphere(vertices, seed)
                                     : geometry::data_sets::random_ellipsoid(vertices, seed);
            ASSERT_TRUE(geometry::general_position(hull.points()).holds());
            EXPECT_EQ(count_convex(points_of(hull), spheres, FlatEdges::refused), 1U);
            EXPECT_EQ(count_convex(points_of(hull), spheres, FlatEdges::admitted), 1U);
        }
    }
}

TEST(ConvexTriangulation, HasConvexEdgesOnlyInGeneralPosition) {
    for (const Index vertices : {4, 10, 100}) {
        const Surface hull = geometry::data_sets::random_sphere(vertices, 1);
        for (Index e = 0; e < hull.triangulation().edge_count(); ++e)
            ASSERT_EQ(edge_shape(hull.view(), Edge{e}), geometry::EdgeShape::convex);
    }
}

// As many as the facets can be cut up: Catalan numbers for polygons, one way where a point is in
// the middle of a square or of an edge.
TEST(ConvexTriangulation, IsUniqueUpToFlatEdgesElsewhere) {
    const auto pyramid = [](std::vector<Point> base) {
        base.emplace_back(0, 0, 5);
        return base;
    };
    const LabelledSurfaces five = all_spheres(5);
    const LabelledSurfaces six = all_spheres(6);
    const auto count = [](const std::vector<Point>& points, const LabelledSurfaces& spheres) {
        return count_convex(points, spheres, FlatEdges::admitted);
    };
    const std::vector<Point> square{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
    EXPECT_EQ(count(pyramid(square), five), 2U);
    EXPECT_EQ(count({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}}, five), 1U);
    EXPECT_EQ(count(pyramid({{0, 0, 0}, {2, 0, 0}, {3, 2, 0}, {1, 3, 0}, {-1, 2, 0}}), six), 5U);
    EXPECT_EQ(count({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}}, six), 8U);
    const std::vector<Point> octahedron{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                        {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    EXPECT_EQ(count(octahedron, six), 1U);
    std::vector<Point> centred = pyramid(square);
    centred.emplace_back(0, 0, 0);
    EXPECT_EQ(count(centred, six), 1U);
}

TEST(ConvexTriangulation, OfSevenPointsIsUniqueUpToFlatEdges) {
    const LabelledSurfaces spheres = all_spheres(7);
    const std::vector<Point> points = points_of(geometry::data_sets::random_sphere(7, 1));
    ASSERT_TRUE(geometry::general_position(points).holds());
    EXPECT_EQ(count_convex(points, spheres, FlatEdges::admitted), 1U);
    const std::vector<Point> pyramid{{2, 0, 0},   {1, 2, 0},  {-1, 2, 0}, {-2, 0, 0},
                                     {-1, -2, 0}, {1, -2, 0}, {0, 0, 5}};
    EXPECT_EQ(count_convex(pyramid, spheres, FlatEdges::admitted), 14U);
}

// Of all simple spheres on the corners of a cube those are convex that cut each square by one of
// its diagonals.
TEST(ConvexTriangulation, OfACubeIsUniqueUpToItsDiagonals) {
    std::vector<Point> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    std::vector<Point> reflected;
    for (const Point& corner : corners)
        reflected.emplace_back(-corner);
    // Each sphere is built one way round, and its reflection stands for the other.
    std::array<std::vector<Surface>, 2> convex;
    for (const FaceSet sphere : simple_spheres(8)) {
        const Triangulation triangulation =
            build(kernel::glue_faces(faces_of(sphere), 8).gluing).value();
        const Convexity shape = convexity({triangulation.table(), corners});
        if (shape == Convexity::convex) convex[0].emplace_back(triangulation, corners);
        if (shape == Convexity::inside_out) convex[1].emplace_back(triangulation, reflected);
    }
    EXPECT_EQ(convex[0].size() + convex[1].size(), 64U);
    for (const std::vector<Surface>& alike : convex) {
        for (const Surface& surface : alike)
            EXPECT_EQ(said(convex_is_unique(alike.front(), surface)), "");
    }
}

// The check would say so: two convex surfaces on the same points that differ in bent edges there
// are none, so one of them is given other points.
TEST(ConvexTriangulation, OnOtherPointsIsNotCompared) {
    const Surface hull = geometry::data_sets::random_sphere(8, 1);
    EXPECT_FALSE(convex_is_unique(hull, geometry::data_sets::random_sphere(8, 2)));
    EXPECT_FALSE(convex_is_unique(hull, hull));
}

TEST(Convexity, IsToldWhicheverWayTheFacesTurn) {
    const Surface hull = geometry::data_sets::cube_grid(26);
    EXPECT_EQ(convexity(hull.view()), Convexity::convex);
    std::vector<Point> reflected = points_of(hull);
    for (Point& point : reflected)
        point = -point;
    EXPECT_EQ(convexity({hull.triangulation().table(), reflected}), Convexity::inside_out);
    EXPECT_EQ(convexity(geometry::data_sets::twisted_prism(3).view()), Convexity::none);
}

// Tight in the classical sense: the least of Omega_abs, 2 pi (4 - chi), and two pieces at most are
// one property, whatever the surface.
TEST(TightIsTwoPiece, OnAllTriangulationsOfFewPoints) {
    for (const Index vertices : {4, 5, 6}) {
        const LabelledSurfaces spheres = all_spheres(vertices);
        for (const std::uint32_t size : {1U, 3U, 1000U}) {
            kernel::RandomStream random(static_cast<std::uint64_t>(vertices) + size);
            std::vector<Point> points(static_cast<std::size_t>(vertices));
            for (Point& point : points) {
                for (double& x : point)
                    x = static_cast<double>(random.below(2 * size + 1)) - size;
            }
            for (const Triangulation& sphere : spheres)
                ASSERT_EQ(said(tight_is_two_piece(Surface(sphere, points))), "") << size;
        }
    }
}

TEST(TightIsTwoPiece, OnRandomSurfacesOfHigherGenus) {
    for (const Index genus : {1, 2}) {
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            kernel::RandomStream random(seed);
            const Index vertices = genus == 1 ? 7 : 8;
            std::vector<Point> points(static_cast<std::size_t>(vertices));
            for (Point& point : points) {
                for (double& x : point)
                    x = static_cast<double>(random.below(2001)) - 1000;
            }
            const Surface surface(kernel::families::random(vertices, genus, seed), points);
            EXPECT_EQ(said(tight_is_two_piece(surface)), "") << genus << ", " << seed;
        }
    }
}

TEST(TightIsTwoPiece, OnModels) {
    for (const Surface& surface :
         {geometry::data_sets::twisted_prism(4), geometry::data_sets::cube_grid(26),
          geometry::data_sets::skewed_cylinder(5), geometry::data_sets::schoenhardt_prism(),
          geometry::data_sets::bumpy_sphere(20, 1), geometry::data_sets::bumpy_torus(36, 1)}) {
        EXPECT_EQ(said(tight_is_two_piece(surface)), "");
    }
}

// A torus of a square frame: tight, as a torus of revolution is.
TEST(TightIsTwoPiece, OnAFrame) {
    std::vector<Point> points;
    for (const auto& [size, height] :
         {std::pair{3, -1}, std::pair{3, 1}, std::pair{1, 1}, std::pair{1, -1}}) {
        for (const auto& [x, y] :
             {std::pair{1, 1}, std::pair{-1, 1}, std::pair{-1, -1}, std::pair{1, -1}})
            points.emplace_back(size * x, size * y, height);
    }
    const auto at = [](Index ring, Index corner) { return 4 * (ring % 4) + corner % 4; };
    std::vector<std::array<Index, 3>> faces;
    for (Index ring = 0; ring < 4; ++ring) {
        for (Index corner = 0; corner < 4; ++corner) {
            faces.push_back({at(ring, corner), at(ring, corner + 1), at(ring + 1, corner + 1)});
            faces.push_back({at(ring, corner), at(ring + 1, corner + 1), at(ring + 1, corner)});
        }
    }
    const Surface frame(build(kernel::glue_faces(faces, 16).gluing).value(), points);
    ASSERT_EQ(frame.triangulation().genus(), 1);
    ASSERT_TRUE(is_embedded(frame.view()));
    EXPECT_NEAR(make_criterion(CriterionKind::tight, frame.view())->value().first(),
                8 * std::numbers::pi, 1e-9);
    EXPECT_EQ(said(tight_is_two_piece(frame)), "");
}

TEST(OptimisationClaims, HaveNamesAndCodes) {
    EXPECT_EQ(name(OptimisationClaim::tight_is_global), "tight_is_global");
    EXPECT_EQ(name(OptimisationClaim::tight_is_two_piece), "tight_is_two_piece");
    EXPECT_EQ(describe({OptimisationClaim::convex_is_unique, 3, "why"}),
              "after 3 flips: 1107 convex_is_unique: why");
}

}  // namespace
}  // namespace tightflip::properties
