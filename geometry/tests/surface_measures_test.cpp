#include "shapes.hpp"
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/geometry/surface_measures.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

constexpr double pi = std::numbers::pi;

void expect_all_sums_consistent(const Surface& surface, const SurfaceMeasures& found) {
    const Triangulation& t = surface.triangulation();
    const double scale = 1 + found.total_absolute_curvature;
    EXPECT_EQ(found.euler_characteristic, t.euler_characteristic());
    EXPECT_NEAR(found.total_curvature, 2 * pi * t.euler_characteristic(), 1e-12 * scale);
    EXPECT_NEAR(found.absolute_curvature_by_cones(), found.total_absolute_curvature, 1e-12 * scale);
    EXPECT_GE(found.total_absolute_curvature, std::abs(found.total_curvature) - 1e-12 * scale);
    EXPECT_EQ(std::reduce(found.vertex_types.begin(), found.vertex_types.end()), t.vertex_count());
    EXPECT_EQ(std::reduce(found.edge_shapes.begin(), found.edge_shapes.end()), t.edge_count());
    if (t.genus() == 0) {
        EXPECT_GE(found.total_absolute_curvature, 4 * pi - 1e-12 * scale);
    }
}

TEST(SurfaceMeasures, GaussBonnetOnAllFamilies) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        for (const Triangulation& triangulation : all_families()) {
            for (const Surface& surface :
                 {with_random_points(triangulation, seed), with_grid_points(triangulation, seed, 3),
                  with_grid_points(triangulation, seed, 1),
                  with_grid_points(triangulation, seed, 0)}) {
                expect_all_sums_consistent(surface, measure(surface.view()));
            }
        }
    }
}

struct Solid {
    std::string name;
    Surface surface;
    double edge;      ///< length
    double exterior;  ///< angle at an edge
    int edges;        ///< without the diagonals of faces
    int corners;      ///< of a face
    double area;
    double volume;
};

TEST(SurfaceMeasures, OfRegularSolidsByTheirFormulas) {
    const double a3 = std::pow(std::sqrt(8.0), 3);
    const std::vector<Solid> solids{
        {"tetrahedron", regular_tetrahedron(), std::sqrt(8.0), pi - std::acos(1.0 / 3), 6, 3,
         std::sqrt(3.0) * 8, a3 / (6 * std::sqrt(2.0))},
        {"cube", cube(), 2, pi / 2, 12, 4, 24, 8},
        {"octahedron", octahedron(), std::sqrt(2.0), pi - std::acos(-1.0 / 3), 12, 3,
         4 * std::sqrt(3.0), 4.0 / 3},
        {"icosahedron", icosahedron(), 2, pi - std::acos(-std::sqrt(5.0) / 3), 30, 3,
         20 * std::sqrt(3.0), 10.0 / 3 * (3 + std::sqrt(5.0))}};
    for (const Solid& solid : solids) {
        SCOPED_TRACE(solid.name);
        const Surface inside_out = moved(solid.surface, Eigen::Affine3d(Eigen::Scaling(-1.0)));
        for (const int side : {1, -1}) {
            const Surface& surface = side == 1 ? solid.surface : inside_out;
            const SurfaceMeasures found = measure(surface.view());
            expect_all_sums_consistent(surface, found);
            const double h_abs = solid.edges * solid.exterior / 2;
            EXPECT_NEAR(found.total_absolute_curvature, 4 * pi, 1e-13);
            EXPECT_NEAR(found.total_positive_curvature, 4 * pi, 1e-13);
            EXPECT_NEAR(found.mean_absolute_curvature, h_abs, 1e-13);
            EXPECT_NEAR(found.mean_absolute_curvature_weighted, h_abs * solid.edge, 1e-12);
            EXPECT_NEAR(found.integral_mean_curvature, side * h_abs * solid.edge, 1e-12);
            EXPECT_NEAR(found.area, solid.area, 1e-12);
            EXPECT_NEAR(found.volume, side * solid.volume, 1e-12);
            EXPECT_EQ(found.count(VertexType::convex), surface.triangulation().vertex_count());
            EXPECT_EQ(found.count(side == 1 ? EdgeShape::convex : EdgeShape::concave), solid.edges);
            EXPECT_EQ(found.count(EdgeShape::flat),
                      surface.triangulation().edge_count() - solid.edges);
        }
    }
}

TEST(SurfaceMeasures, FoldedEdgesHaveASizeAndNoSign) {
    const SurfaceMeasures found = measure(
        Surface(kernel::families::book(3), std::vector<Point>{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}})
            .view());
    EXPECT_EQ(found.integral_mean_curvature, 0);
    EXPECT_DOUBLE_EQ(found.mean_absolute_curvature, 3 * pi / 2);
    EXPECT_DOUBLE_EQ(found.mean_absolute_curvature_weighted, 12 * pi / 2);
}

TEST(SurfaceMeasures, AreasOfNeedles) {
    // A corner with three orthogonal edges, which are no axes, one of them very long; the area of
    // the face opposite the corner is the root of the squares of the others (de Gua).
    for (const double far : {1.0, 1e8, 1e16, 1e40, 1e100}) {
        std::vector<Point> points{
            {0, 0, 0}, Point(1, 2, 2) / 3 * far, Point(2, 1, -2) / 3, Point(2, -2, 1) / 3};
        const double expected = far + 0.5 + std::sqrt(2 * far * far + 1) / 2;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Surface surface =
                make_surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, points);
            EXPECT_NEAR(measure(surface.view()).area, expected, 1e-14 * expected);
            std::ranges::rotate(points, points.begin() + 1);
        }
    }
}

TEST(SurfaceMeasures, OfATorusOfRevolution) {
    constexpr Index rings = 40;
    constexpr Index sides = 24;
    std::vector<Point> points(static_cast<std::size_t>(rings * sides));
    for (Index i = 0; i < rings; ++i) {
        for (Index j = 0; j < sides; ++j) {
            const double u = 2 * pi * i / rings;
            const double v = 2 * pi * j / sides;
            const double r = 3 + std::cos(v);
            points[static_cast<std::size_t>(i * sides + j)] = {r * std::cos(u), r * std::sin(u),
                                                               std::sin(v)};
        }
    }
    const Surface surface(kernel::families::torus_grid(rings, sides), points);
    const SurfaceMeasures found = measure(surface.view());
    expect_all_sums_consistent(surface, found);
    EXPECT_NEAR(found.total_absolute_curvature, 8 * pi, 0.5);  // a tight torus, but for diagonals
    EXPECT_NEAR(found.area, 12 * pi * pi, 0.03 * 12 * pi * pi);
    EXPECT_NEAR(std::abs(found.volume), 6 * pi * pi, 0.03 * 6 * pi * pi);
}

void expect_same(const SurfaceMeasures& a, const SurfaceMeasures& b) {
    const double scale = 1 + a.total_absolute_curvature;
    EXPECT_NEAR(a.total_curvature, b.total_curvature, 1e-9 * scale);
    EXPECT_NEAR(a.total_positive_curvature, b.total_positive_curvature, 1e-9 * scale);
    EXPECT_NEAR(a.total_absolute_curvature, b.total_absolute_curvature, 1e-9 * scale);
    EXPECT_NEAR(a.mean_absolute_curvature, b.mean_absolute_curvature, 1e-9 * scale);
    EXPECT_NEAR(a.mean_absolute_curvature_weighted, b.mean_absolute_curvature_weighted,
                1e-9 * (1 + a.mean_absolute_curvature_weighted));
    EXPECT_NEAR(a.integral_mean_curvature, b.integral_mean_curvature,
                1e-9 * (1 + a.mean_absolute_curvature_weighted));
    EXPECT_NEAR(a.area, b.area, 1e-9 * (1 + a.area));
    EXPECT_NEAR(a.volume, b.volume, 1e-9 * (1 + a.area));
    EXPECT_EQ(a.vertex_types, b.vertex_types);
    EXPECT_EQ(a.edge_shapes, b.edge_shapes);
}

TEST(SurfaceMeasures, AreInvariantUnderMotionsOfPointsInGeneralPosition) {
    const Eigen::Affine3d motion = Eigen::Translation3d(1.5, -2.25, 0.75) *
                                   Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -2).normalized());
    for (const Triangulation& triangulation :
         {kernel::families::stacked(60, 7), kernel::families::octasphere(2),
          kernel::families::surface_of_genus(2, 40, 1), kernel::families::torus_grid(5, 7)}) {
        const Surface surface = with_random_points(triangulation, 12);
        expect_same(measure(surface.view()), measure(moved(surface, motion).view()));
    }
}

TEST(SurfaceMeasures, AreInvariantUnderRelabelling) {
    kernel::RandomStream random(3);
    for (const Triangulation& triangulation : all_families()) {
        for (const Surface& surface :
             {with_random_points(triangulation, 13), with_grid_points(triangulation, 13, 1)}) {
            std::vector<Index> order(static_cast<std::size_t>(triangulation.vertex_count()));
            std::iota(order.begin(), order.end(), 0);
            random.shuffle(std::span(order));
            expect_same(measure(surface.view()), measure(relabelled(surface, order).view()));
        }
    }
}

/// The tetrahedron of the four corners is taken away at a convex edge and added at a concave one.
TEST(SurfaceMeasures, AFlipChangesTheVolumeByItsTetrahedron) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        Surface surface = with_random_points(kernel::families::random(15, seed % 2, seed), seed);
        for (Index id = 0; id < surface.triangulation().edge_count(); ++id) {
            const SurfaceView view = surface.view();
            const Halfedge h = halfedge_of(Edge{id});
            const Point a = view.origin(h);
            Eigen::Matrix3d sides;
            sides << view.target(h) - a, view.opposite(h) - a, view.opposite(twin(h)) - a;
            const EdgeShape shape = edge_shape(view, Edge{id});
            const double before = measure(view).volume;
            if (!surface.triangulation().flip(Edge{id})) continue;
            const double after = measure(surface.view()).volume;
            EXPECT_NEAR(after - before, sides.determinant() / 6, 1e-12);
            EXPECT_EQ(after < before, shape == EdgeShape::convex);
        }
    }
}

TEST(SurfaceMeasures, AreNotNanForCoordinatesOfAnySize) {
    constexpr double largest = std::numeric_limits<double>::max();
    for (const double factor : {1e-320, 1e-300, 1e-150, 1e150, 1e300, largest}) {
        for (const Triangulation& triangulation : all_families()) {
            Surface surface = with_random_points(triangulation, 17);
            surface = moved(surface, Eigen::Affine3d(Eigen::Scaling(factor)));
            const SurfaceMeasures found = measure(surface.view());
            expect_all_sums_consistent(surface, found);
            for (const double value :
                 {found.mean_absolute_curvature, found.mean_absolute_curvature_weighted,
                  found.integral_mean_curvature, found.area, found.volume}) {
                EXPECT_FALSE(std::isnan(value)) << factor;
            }
        }
    }
}

TEST(SurfaceMeasures, ScaleWithTheCoordinates) {
    const Surface surface = with_random_points(kernel::families::stacked(20, 1), 19);
    const SurfaceMeasures plain = measure(surface.view());
    const double factor = 0x1p300;
    const Surface larger = moved(surface, Eigen::Affine3d(Eigen::Scaling(factor)));
    const SurfaceMeasures found = measure(larger.view());
    EXPECT_DOUBLE_EQ(found.mean_absolute_curvature_weighted,
                     factor * plain.mean_absolute_curvature_weighted);
    EXPECT_DOUBLE_EQ(found.integral_mean_curvature, factor * plain.integral_mean_curvature);
    EXPECT_DOUBLE_EQ(found.area, factor * factor * plain.area);
    EXPECT_DOUBLE_EQ(found.volume, factor * factor * factor * plain.volume);
    const Surface huge = moved(surface, Eigen::Affine3d(Eigen::Scaling(1e300)));
    EXPECT_TRUE(std::isinf(measure(huge.view()).area));
}

class Model : public testing::TestWithParam<const char*> {};

TEST_P(Model, IsMeasuredWithGaussBonnet) {
    const auto path = std::filesystem::path(TIGHTFLIP_MESHES) / GetParam();
    if (!exists(path)) GTEST_SKIP() << path << " is not here";
    TriangleSoup soup = read_mesh_file(path);
    Triangulation triangulation = kernel::build(soup.triangles, soup.vertex_count()).value();
    const Surface surface(std::move(triangulation), std::move(soup.points));
    const SurfaceMeasures found = measure(surface.view());
    const double expected = 2 * pi * surface.triangulation().euler_characteristic();
    EXPECT_NEAR(found.total_curvature, expected, 1e-9 * found.total_absolute_curvature);
    EXPECT_NEAR(found.absolute_curvature_by_cones(), found.total_absolute_curvature,
                1e-9 * found.total_absolute_curvature);
    EXPECT_GE(found.total_absolute_curvature, 8 * pi - expected);  // Chern and Lashof
    EXPECT_GT(found.area, 0);
    EXPECT_NE(found.volume, 0);
}

INSTANTIATE_TEST_SUITE_P(Closed, Model,
                         testing::Values("spot.obj", "fandisk.obj", "rocker-arm.obj"),
                         [](const auto& test) {
                             const std::string name = test.param;
                             return name.substr(0, name.find_first_of(".-"));
                         });

}  // namespace
}  // namespace tightflip::geometry
