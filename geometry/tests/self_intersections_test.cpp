/// \file
/// Self-intersections against all pairs of faces by linear programming, and of known surfaces.
#include "common_points.hpp"
#include "reading.hpp"
#include "self_intersecting_shapes.hpp"
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/geometry/self_intersections.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <numeric>
#include <ostream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {

static void PrintTo(const FacePair& pair, std::ostream* out) {
    *out << pair.first.id << (pair.is_local ? " locally " : " globally ") << pair.second.id;
}

namespace {

struct Corners {
    std::array<Index, 3> labels;
    Triangle triangle;
};

Corners corners_of(const Surface& surface, Halfedge h) {
    Corners result{};
    std::size_t i = 0;
    for (const Vertex v : surface.triangulation().face_corners(h)) {
        result.labels.at(i) = v.id;
        result.triangle.at(i++) = surface.point(v);
    }
    return result;
}

/// By definition, with what is in common from elsewhere: empty where the faces do not meet beyond
/// what they share, else whether they have a vertex in common.
std::optional<bool> meet_by_definition(const Surface& surface, Halfedge f, Halfedge g) {
    const Corners first = corners_of(surface, f);
    const Corners second = corners_of(surface, g);
    std::vector<std::array<Index, 2>> shared;  // edges, and vertices as edges from and to one
    for (const Index v : first.labels) {
        if (std::ranges::find(second.labels, v) != second.labels.end()) shared.push_back({v, v});
    }
    const bool is_local = !shared.empty();
    if (shared.size() == 3) return is_local;
    for (const Halfedge side : surface.triangulation().face_sides(f)) {
        for (const Halfedge other : surface.triangulation().face_sides(g)) {
            if (side != twin(other)) continue;
            shared.push_back(
                {surface.triangulation().origin(side).id, surface.triangulation().target(side).id});
        }
    }
    const auto common = common_points(first.triangle, second.triangle);
    const auto point = [&](Index v) { return as_fractions(surface.point(Vertex{v})); };
    const bool is_shared =
        common.empty() || std::ranges::any_of(shared, [&](const std::array<Index, 2>& edge) {
            return std::ranges::all_of(common, [&](const FractionPoint& x) {
                return lies_in_hull(x, point(edge[0]), point(edge[1]));
            });
        });
    return is_shared ? std::nullopt : std::optional(is_local);
}

template <class Meet>
std::vector<FacePair> all_pairs(const Surface& surface, const Meet& meet) {
    std::vector<FacePair> pairs;
    const std::vector<Halfedge> faces = surface.triangulation().faces();
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::size_t j = i + 1; j < faces.size(); ++j) {
            const std::optional<bool> is_local = meet(faces[i], faces[j]);
            if (is_local) pairs.push_back({faces[i], faces[j], *is_local});
        }
    }
    return pairs;
}

std::vector<FacePair> pairs_by_definition(const Surface& surface) {
    return all_pairs(surface,
                     [&](Halfedge f, Halfedge g) { return meet_by_definition(surface, f, g); });
}

void expect_pairs(const Surface& surface, const std::vector<FacePair>& expected) {
    const SelfIntersections found = find_self_intersections(surface.view(), 1U << 30U);
    ASSERT_EQ(found.pairs, expected);
    const auto local = std::ranges::count_if(expected, &FacePair::is_local);
    EXPECT_EQ(found.local_count, local);
    EXPECT_EQ(found.global_count, static_cast<std::int64_t>(expected.size()) - local);
    const auto collapsed = std::ranges::count_if(surface.triangulation().faces(), [&](Halfedge h) {
        const SurfaceView view = surface.view();
        return are_collinear(view.origin(h), view.target(h), view.opposite(h));
    });
    EXPECT_EQ(found.collapsed_count, collapsed);
    EXPECT_EQ(found.is_embedded(), expected.empty() && collapsed == 0);
    EXPECT_EQ(is_embedded(surface.view()), expected.empty() && collapsed == 0);
}

TEST(SelfIntersections, AreThoseOfTheDefinitionOnSmallGrids) {
    namespace families = kernel::families;
    std::map<bool, std::int64_t> seen;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const auto vertices = static_cast<Index>(5 + seed % 5);
        for (const Triangulation& triangulation :
             {families::double_wheel(vertices), families::book(vertices),
              families::random(vertices, 0, seed), families::random(vertices, 1, seed),
              families::stacked(vertices, seed)}) {
            const Surface surface =
                with_grid_points(triangulation, seed, static_cast<std::uint32_t>(1 + seed % 3));
            const auto expected = pairs_by_definition(surface);
            for (const FacePair& pair : expected)
                ++seen[pair.is_local];
            expect_pairs(surface, expected);
        }
    }
    EXPECT_GT(seen[false], 100);
    EXPECT_GT(seen[true], 100);
}

/// Each pair of faces by itself: for the search for pairs; what a pair is has its test above.
void expect_pairs_of_all_faces(const Surface& surface) {
    expect_pairs(surface, all_pairs(surface, [&](Halfedge f, Halfedge g) {
                     const auto first = corners_of(surface, f).labels;
                     const auto second = corners_of(surface, g).labels;
                     const bool is_local = std::ranges::find_first_of(first, second) != first.end();
                     return faces_meet(surface.view(), f, g) ? std::optional(is_local)
                                                             : std::nullopt;
                 }));
}

TEST(SelfIntersections, AreFoundAmongManyFaces) {
    namespace families = kernel::families;
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
        for (const Triangulation& triangulation :
             {families::double_wheel(150), families::torus_grid(9, 11),
              families::stacked(120, seed), families::random(100, 2, seed), families::book(60)}) {
            expect_pairs_of_all_faces(with_grid_points(triangulation, seed, 4));
            expect_pairs_of_all_faces(with_random_points(triangulation, seed));
        }
    }
}

/// Where every predicate needs exact arithmetic.
TEST(SelfIntersections, AreFoundAtAnyScale) {
    for (const Surface& surface : {with_random_points(kernel::families::random(9, 0, 4), 1),
                                   with_random_points(kernel::families::double_wheel(14), 2)}) {
        const auto expected = find_self_intersections(surface.view());
        ASSERT_GT(expected.local_count + expected.global_count, 0);
        for (const int exponent : {1000, 330, -330, -1000}) {
            EXPECT_EQ(find_self_intersections(scaled(surface, exponent).view()).pairs,
                      expected.pairs);
        }
    }
}

TEST(SelfIntersections, DoNotDependOnLabels) {
    kernel::RandomStream random(8);
    const Surface surface = with_grid_points(kernel::families::random(40, 1, 3), 5, 2);
    std::vector<Index> order(surface.points().size());
    std::iota(order.begin(), order.end(), 0);
    random.shuffle(std::span(order));
    const auto before = find_self_intersections(surface.view());
    const auto after = find_self_intersections(relabelled(surface, order).view());
    EXPECT_GT(before.global_count, 0);
    EXPECT_EQ(before.local_count, after.local_count);
    EXPECT_EQ(before.global_count, after.global_count);
}

TEST(SelfIntersections, TheFirstPairsAreListed) {
    const Surface surface = with_random_points(kernel::families::random(60, 0, 3), 9);
    const auto all = find_self_intersections(surface.view(), 1U << 30U);
    ASSERT_GT(all.pairs.size(), 500U);
    for (const std::size_t kept : {0U, 1U, 7U, 100U}) {
        const auto first = find_self_intersections(surface.view(), kept);
        EXPECT_EQ(first.local_count, all.local_count);
        EXPECT_EQ(first.global_count, all.global_count);
        EXPECT_EQ(first.pairs, std::vector(all.pairs.begin(),
                                           all.pairs.begin() + static_cast<std::ptrdiff_t>(kept)));
    }
}

TEST(SelfIntersections, KnownEmbeddedSurfaces) {
    for (const Surface& surface :
         {regular_tetrahedron(), cube(), octahedron(), icosahedron(), round_torus(12, 9),
          wound_bipyramid(200, 1), scaled(cube(), 1000), scaled(icosahedron(), -1000)}) {
        EXPECT_TRUE(is_embedded(surface.view()));
        EXPECT_TRUE(find_self_intersections(surface.view()).is_embedded());
    }
}

TEST(SelfIntersections, KnownCounts) {
    // The faces over the two crossing rim edges: at each pole one pair, and across two.
    const auto crossed = find_self_intersections(bow_tie().view());
    EXPECT_EQ(crossed.local_count, 2);
    EXPECT_EQ(crossed.global_count, 2);
    // Two faces with the same corners, even where these lie on a line.
    for (const double y : {0.0, 1.0}) {
        const Surface sphere{kernel::families::book(3), {{0, 0, 0}, {1, y, 0}, {2, 0, 0}}};
        EXPECT_EQ(find_self_intersections(sphere.view()).pairs,
                  (std::vector<FacePair>{{Halfedge{0}, Halfedge{1}, true}}));
    }
    // A vertex of a tetrahedron moved into the opposite face: its three faces fold onto that.
    const Surface flat = make_surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                                      {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}});
    EXPECT_EQ(find_self_intersections(flat.view()).local_count, 3);
    EXPECT_EQ(find_self_intersections(flat.view()).global_count, 0);
}

TEST(SelfIntersections, CountingStopsWhereAsked) {
    const Surface surface = with_random_points(kernel::families::random(40, 0, 4), 1);
    const auto all = find_self_intersections(surface.view());
    ASSERT_TRUE(all.is_complete);
    ASSERT_GT(all.global_count, 10);
    const auto count = all.local_count + all.global_count;
    const auto exactly = find_self_intersections(surface.view(), 0, count);
    EXPECT_TRUE(exactly.is_complete);
    EXPECT_EQ(exactly.global_count, all.global_count);
    for (const std::int64_t most : {std::int64_t{0}, all.local_count / 2, count - 1}) {
        const auto some = find_self_intersections(surface.view(), 0, most);
        EXPECT_FALSE(some.is_complete);
        EXPECT_FALSE(some.is_embedded());
        EXPECT_EQ(some.local_count + some.global_count, most);
    }
}

// Needles about two opposite vertices, whose boxes all meet.
TEST(SelfIntersections, TwoHubsOfHighDegreeTakeLittleTime) {
    const Index rim = 60000;
    std::vector<Point> points{{0, 0, 1}, {0, 0, -1}};
    for (Index i = 0; i < rim; ++i) {
        const double angle = 2 * std::numbers::pi * i / rim;
        points.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    const Surface surface(kernel::families::double_wheel(rim + 2), std::move(points));
    EXPECT_TRUE(is_embedded(surface.view()));
}

TEST(SelfIntersections, AFaceOfZeroAreaIsNotEmbedded) {
    // A tetrahedron at one point, whose faces share all there is of them, and one on a line.
    const Surface solid = regular_tetrahedron();
    for (const Point& axis : {Point(0, 0, 0), Point(1, 2, 3)}) {
        std::vector<Point> points;
        for (int i = 0; i < 4; ++i)
            points.emplace_back(i * axis);
        const Surface collapsed(solid.triangulation(), points);
        EXPECT_EQ(find_self_intersections(collapsed.view()).collapsed_count, 4);
        EXPECT_FALSE(find_self_intersections(collapsed.view()).is_embedded());
        EXPECT_FALSE(is_embedded(collapsed.view()));
    }
    // A flip that lays a face along a line: the midpoint of an edge as a third corner.
    const Surface surface =
        make_surface({{0, 2, 1}, {0, 1, 3}, {0, 3, 4}, {0, 4, 2}, {1, 2, 4}, {1, 4, 3}},
                     {{0, 0, 0}, {2, 0, 1}, {0, 2, 0}, {0, 0, 2}, {0, 1, 1}});
    ASSERT_TRUE(is_embedded(surface.view()));
    EXPECT_FALSE(flip_keeps_embedded(surface.view(), edge_between(surface, 0, 4)));
}

TEST(SelfIntersections, AFlipIsJudgedAsTheSurfaceAfterIt) {
    kernel::RandomStream random(12);
    std::map<bool, int> seen;
    for (const Surface& start : {octahedron(), cube(), icosahedron(), round_torus(5, 4)}) {
        Surface surface = start;
        for (int step = 0; step < 40; ++step) {
            std::vector<Edge> kept;
            for (Index id = 0; id < surface.triangulation().edge_count(); ++id) {
                Surface after = surface;
                const bool expected =
                    after.triangulation().flip(Edge{id}) && is_embedded(after.view());
                ASSERT_EQ(flip_keeps_embedded(surface.view(), Edge{id}), expected) << step;
                ++seen[expected];
                if (expected) kept.push_back(Edge{id});
            }
            ASSERT_FALSE(kept.empty());
            surface.triangulation().flip(
                kept[random.below(static_cast<std::uint32_t>(kept.size()))]);
        }
    }
    EXPECT_GT(seen[false], 300);
    EXPECT_GT(seen[true], 300);
}

struct Model {
    std::string name;
    bool is_embedded;
};

class EmbeddedModel : public testing::TestWithParam<Model> {};

TEST_P(EmbeddedModel, IsOrIsNot) {
    const auto path = std::filesystem::path(TIGHTFLIP_MESHES) / GetParam().name;
    if (!exists(path)) GTEST_SKIP() << path << " is not here";
    const TriangleSoup soup = read_mesh_file(path);
    const Surface surface{kernel::build(soup.triangles, soup.vertex_count()).value(), soup.points};
    const SelfIntersections found = find_self_intersections(surface.view());
    EXPECT_EQ(found.is_embedded(), GetParam().is_embedded)
        << found.local_count << " local and " << found.global_count << " global pairs";
    EXPECT_EQ(is_embedded(surface.view()), GetParam().is_embedded);
    for (const FacePair& pair : found.pairs) {
        EXPECT_TRUE(faces_meet(surface.view(), pair.first, pair.second));
    }
}

INSTANTIATE_TEST_SUITE_P(Models, EmbeddedModel,
                         testing::Values(Model{"spot.obj", true}, Model{"fandisk.obj", true},
                                         Model{"rocker-arm.obj", true}),
                         [](const auto& test) {
                             return test.param.name.substr(0, test.param.name.find_first_of(".-"));
                         });

}  // namespace
}  // namespace tightflip::geometry
