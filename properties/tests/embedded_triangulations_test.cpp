#include "order_type_seeds.hpp"
#include "order_types.hpp"
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/counting.hpp>
#include <tightflip/properties/embedded_triangulations.hpp>

#include <algorithm>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::Point;
using kernel::Edge;
using kernel::Triangulation;
using kernel::Vertex;
using testing::HasSubstr;
using testing::SizeIs;

Triangulation triangulation_of(FaceSet sphere, Index vertices) {
    return build(kernel::glue_faces(faces_of(sphere), vertices).gluing).value();
}

/// The faces of a surface, each ascending, sorted.
std::vector<std::array<Index, 3>> face_list(const Triangulation& surface) {
    std::vector<std::array<Index, 3>> faces;
    for (const kernel::Halfedge side : surface.faces()) {
        std::array<Index, 3> corners{surface.origin(side).id, surface.target(side).id,
                                     surface.opposite(side).id};
        std::ranges::sort(corners);
        faces.push_back(corners);
    }
    std::ranges::sort(faces);
    return faces;
}

std::vector<std::array<Index, 3>> sorted_faces_of(FaceSet sphere) {
    auto faces = faces_of(sphere);
    std::ranges::sort(faces);
    return faces;
}

bool is_simple(const Triangulation& surface) {
    return audit(surface).is_simple().value();
}

/// What EmbeddedTriangulations should say of a flip, from the EDF and the judges of surfaces.
FlipObstacle obstacle_of(const Triangulation& flipped, geometry::Points points) {
    if (!is_simple(flipped)) return FlipObstacle::parallel_edge;
    return geometry::is_embedded({flipped.table(), points}) ? FlipObstacle::none
                                                            : FlipObstacle::self_intersection;
}

std::string message_of(const std::vector<Point>& points) {
    try {
        const EmbeddedTriangulations embedded(points);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(SimpleSpheres, AreAsManyAsTheClosedFormulaCounts) {
    for (Index vertices = 4; vertices <= 8; ++vertices) {
        const std::vector<FaceSet> spheres = simple_spheres(vertices);
        const auto oriented = kernel::labelled_from_rooted(
            kernel::rooted_simple_spheres(vertices).value(), vertices, 6 * (vertices - 2));
        EXPECT_EQ(2 * spheres.size(), oriented);
        EXPECT_TRUE(std::ranges::is_sorted(spheres));
    }
}

TEST(SimpleSpheres, AreSimpleSpheres) {
    for (const FaceSet sphere : simple_spheres(6)) {
        const Triangulation surface = triangulation_of(sphere, 6);
        ASSERT_EQ(surface.genus(), 0);
        ASSERT_TRUE(is_simple(surface));
        ASSERT_EQ(face_list(surface), sorted_faces_of(sphere));
    }
}

TEST(SimpleSpheres, NeedFourToEightVertices) {
    EXPECT_THROW((void)simple_spheres(3), std::invalid_argument);
    EXPECT_THROW((void)simple_spheres(9), std::invalid_argument);
}

TEST(EmbeddedTriangulations, OfFourPointsThereIsOne) {
    const EmbeddedTriangulations embedded(points_of_seed(4, 1));
    EXPECT_EQ(embedded.all(), (std::vector<FaceSet>{0b1111}));
    EXPECT_THAT(embedded.components(), SizeIs(1));
}

// On five points a simple sphere lacks one edge and bounds two tetrahedra side by side, or one
// without the other, over the triangle of the three other points. With a point inside a tetrahedron
// all ten are embedded. Where the segment ab crosses the triangle cde, those that lack an edge
// between {a, b} and {c, d, e} are not.
TEST(EmbeddedTriangulations, OfFivePointsAreAllOrFour) {
    const std::vector<Point> inside{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}};
    EXPECT_THAT(EmbeddedTriangulations(inside).all(), SizeIs(10));
    const std::vector<Point> crossing{{4, 0, -1}, {0, 4, -1}, {-4, -4, 1}, {0, 0, 4}, {0, 0, -5}};
    EXPECT_THAT(EmbeddedTriangulations(crossing).all(), SizeIs(4));
}

TEST(EmbeddedTriangulations, AreThoseThatTheJudgeOfSurfacesCallsEmbedded) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const std::vector<Point> points = points_of_seed(7, seed);
        const std::vector<FaceSet> spheres = simple_spheres(7);
        const EmbeddedTriangulations embedded(points, spheres);
        std::vector<FaceSet> expected;
        std::ranges::copy_if(spheres, std::back_inserter(expected), [&](FaceSet sphere) {
            return geometry::is_embedded({triangulation_of(sphere, 7).table(), points});
        });
        EXPECT_EQ(embedded.all(), expected) << "seed " << seed;
    }
}

TEST(EmbeddedTriangulations, FlipsDoWhatTheKernelsDo) {
    const std::vector<Point> points = points_of_seed(6, 1);
    const EmbeddedTriangulations embedded(points);
    std::size_t of_each_kind[3]{};
    for (const FaceSet sphere : embedded.all()) {
        const Triangulation start = triangulation_of(sphere, 6);
        const auto flips = embedded.flips(sphere);
        ASSERT_THAT(flips, SizeIs(start.edge_count()));
        for (Index e = 0; e < start.edge_count(); ++e) {
            Triangulation flipped = start;
            ASSERT_TRUE(flipped.flip(Edge{e}));
            const auto ends = [e](const Triangulation& surface) {
                const kernel::Halfedge h = kernel::halfedge_of(Edge{e});
                std::array<Index, 2> both{surface.origin(h).id, surface.target(h).id};
                std::ranges::sort(both);
                return both;
            };
            const auto flip = std::ranges::find(flips, ends(start), &ConventionalFlip::edge);
            ASSERT_NE(flip, flips.end());
            EXPECT_EQ(flip->new_edge, ends(flipped));
            ASSERT_EQ(flip->obstacle, obstacle_of(flipped, points));
            if (flip->obstacle != FlipObstacle::parallel_edge) {
                EXPECT_EQ(sorted_faces_of(flip->result), face_list(flipped));
            }
            ++of_each_kind[static_cast<std::size_t>(flip->obstacle)];
        }
    }
    EXPECT_GT(*std::ranges::min_element(of_each_kind), 10U);
}

TEST(EmbeddedTriangulations, ComponentsAreClosedUnderFlipsAndMakeUpAll) {
    // Convex points, some of whose embedded triangulations no flip joins to the others.
    const std::vector<Point> points{{-2, 0, -1},  {-1, -2, 2}, {0, 1, -1}, {0, -2, -2},
                                    {-2, -1, -2}, {-2, 1, 1},  {1, -1, 1}, {1, 0, 1}};
    const EmbeddedTriangulations embedded(points);
    std::vector<FaceSet> together;
    for (const std::vector<FaceSet>& component : embedded.components()) {
        EXPECT_TRUE(std::ranges::is_sorted(component));
        together.insert(together.end(), component.begin(), component.end());
        for (const FaceSet sphere : component) {
            for (const ConventionalFlip& flip : embedded.flips(sphere)) {
                if (flip.obstacle != FlipObstacle::none) continue;
                ASSERT_TRUE(std::ranges::binary_search(component, flip.result));
            }
        }
    }
    std::ranges::sort(together);
    EXPECT_EQ(together, embedded.all());
    std::vector<std::size_t> sizes;
    for (const auto& component : embedded.components())
        sizes.push_back(component.size());
    EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 1, 2114}));
}

TEST(EmbeddedTriangulations, SurfacesAreSeenFromOutside) {
    for (const std::size_t count : {5U, 6U, 7U}) {
        const std::vector<Point> points = points_of_seed(count, 3);
        const EmbeddedTriangulations embedded(points);
        for (const FaceSet sphere : embedded.all()) {
            const geometry::Surface surface = embedded.surface(sphere);
            ASSERT_EQ(face_list(surface.triangulation()), sorted_faces_of(sphere));
            ASSERT_TRUE(std::ranges::equal(surface.points(), points));
            ASSERT_GT(measure(surface.view()).volume, 0) << count << " points";
        }
    }
}

TEST(EmbeddedTriangulations, OtherSetsOfFacesAreNoSurface) {
    const EmbeddedTriangulations embedded(points_of_seed(5, 0));
    EXPECT_THROW((void)embedded.surface(0), std::invalid_argument);
    EXPECT_THROW((void)embedded.surface(0b1111), std::invalid_argument);
}

TEST(EmbeddedTriangulations, PointsThatDoNotFitAreNamed) {
    const std::vector<Point> plane{{0, 0, 0}, {1, 0, 0}, {3, 2, 5}, {0, 1, 0}, {1, 2, 0}};
    EXPECT_THAT(message_of(plane), HasSubstr("the points 0, 1, 3, 4 lie in a plane"));
    const std::vector<Point> line{{0, 0, 0}, {1, 1, 1}, {3, 2, 5}, {0, 1, 0}, {2, 2, 2}};
    EXPECT_THAT(message_of(line), HasSubstr("the points 0, 1, 4 lie on a line"));
    const std::vector<Point> equal{{0, 0, 0}, {1, 1, 1}, {3, 2, 5}, {0, 1, 0}, {1, 1, 1}};
    EXPECT_THAT(message_of(equal), HasSubstr("the points 1, 4 coincide"));
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<Point> far{{0, 0, 0}, {1, 1, 1}, {3, infinity, 5}, {0, 1, 0}};
    EXPECT_THAT(message_of(far), HasSubstr("point 2 is not finite"));
    EXPECT_THAT(message_of(points_of_seed(3, 0)), HasSubstr("4 to 8 points"));
    EXPECT_THAT(message_of(points_of_seed(9, 0)), HasSubstr("4 to 8 points"));
}

// The remark's other side: with at most seven points in general position, conventional flips join
// all embedded triangulations. The seeds make one point set for each order type (see
// order_types_test.cpp), and more than that does not matter.
TEST(EmbeddedTriangulations, OfUpToSevenPointsAreConnected) {
    const auto check = [](std::size_t count, std::span<const std::uint64_t> seeds) {
        const std::vector<FaceSet> spheres = simple_spheres(static_cast<Index>(count));
        for (const std::uint64_t seed : seeds) {
            const EmbeddedTriangulations embedded(points_of_seed(count, seed), spheres);
            EXPECT_THAT(embedded.components(), SizeIs(1)) << count << " points, seed " << seed;
        }
    };
    check(5, seeds_of_5_points);
    check(6, seeds_of_6_points);
    check(7, seeds_of_7_points);
}

}  // namespace
}  // namespace tightflip::properties
