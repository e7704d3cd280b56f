#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/covering_degree.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/negative_side.hpp>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::Point;
using geometry::Surface;
using kernel::Edge;
using kernel::Index;
using kernel::RandomStream;
using kernel::Vertex;

constexpr int rays = 500;

Tetrahedron corners(Index a, Index b, Index c, Index d) {
    return {Vertex{a}, Vertex{b}, Vertex{c}, Vertex{d}};
}

Surface tetrahedron(bool inside_out) {
    const Surface surface(kernel::families::tetrahedron(),
                          {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    if (bool(geometry::is_convex_surface(surface.view())) != inside_out) return surface;
    return {surface.triangulation(), {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
}

TEST(NegativeSide, IsSeenOfATetrahedronTurnedInsideOut) {
    EXPECT_FALSE(find_negative_view(tetrahedron(false).view(), rays, 1));
    const Surface surface = tetrahedron(true);
    const auto view = find_negative_view(surface.view(), rays, 1);
    ASSERT_TRUE(view);
    EXPECT_TRUE(is_negative_view(surface.view(), *view));
    EXPECT_EQ(covering_degree(surface.view(), view->to), -1);
    EXPECT_EQ(covering_degree(surface.view(), view->from), 0);
}

TEST(NegativeSide, ViewsAreCheckedExactly) {
    const Surface surface = tetrahedron(true);
    NegativeView view = find_negative_view(surface.view(), rays, 1).value();
    NegativeView through = view;
    through.to = through.from + 8 * (through.to - through.from);  // out again on the other side
    EXPECT_FALSE(is_negative_view(surface.view(), through));
    NegativeView inside = view;
    inside.from = view.to;
    EXPECT_FALSE(is_negative_view(surface.view(), inside));
    view.face = kernel::twin(view.face);
    EXPECT_FALSE(is_negative_view(surface.view(), view));
    // Through a vertex.
    EXPECT_FALSE(is_negative_view(surface.view(),
                                  {surface.point(Vertex{1}) * 5, {0, 0, 0}, kernel::Halfedge{0}}));
}

// From within, a face is met on its inner side too, and no other is; that is no view from outside.
TEST(NegativeSide, IsNotSeenFromInside) {
    const Surface surface = tetrahedron(false);
    Point centre(0, 0, 0);
    for (const Point& corner : surface.points())
        centre += corner / 4;
    for (const Point& direction :
         {Point(3, 0.11, 0.12), Point(-3, 0.11, 0.12), Point(2, 2.1, 2.2)}) {
        for (Index h = 0; h < surface.triangulation().halfedge_count(); ++h)
            EXPECT_FALSE(is_negative_view(surface.view(), {centre, centre + direction, {h}}));
    }
}

TEST(NegativeSide, OfConvexSurfacesIsNotSeen) {
    EXPECT_FALSE(find_negative_view(geometry::data_sets::random_sphere(20, 1).view(), rays, 1));
    EXPECT_FALSE(find_negative_view(geometry::data_sets::twisted_prism(3).view(), rays, 1));
}

TEST(Tetrahedra, MakeTheSurfaceTheyBound) {
    const Surface surface = tetrahedron(false);
    const std::vector<Tetrahedron> one{corners(0, 1, 2, 3)};
    EXPECT_TRUE(is_sum_of_tetrahedra(surface.view(), one));
    EXPECT_TRUE(is_sum_of_tetrahedra(surface.view(), std::vector{corners(2, 0, 1, 3)}));
    EXPECT_FALSE(is_sum_of_tetrahedra(surface.view(), {}));
    EXPECT_FALSE(is_sum_of_tetrahedra(surface.view(), std::vector{one[0], one[0]}));
    EXPECT_FALSE(is_sum_of_tetrahedra(tetrahedron(true).view(), one));
    EXPECT_FALSE(as_sum_of_tetrahedra(tetrahedron(true).view(), 3));
    EXPECT_FALSE(as_sum_of_tetrahedra(surface.view(), 0));
    EXPECT_EQ(as_sum_of_tetrahedra(surface.view(), 1)->size(), 1U);
}

TEST(Tetrahedra, WithoutVolumeAreNone) {
    const Surface flat(kernel::families::tetrahedron(),
                       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
    EXPECT_FALSE(is_sum_of_tetrahedra(flat.view(), std::vector{corners(0, 1, 2, 3)}));
    EXPECT_FALSE(as_sum_of_tetrahedra(flat.view(), 3));
}

// Schoenhardt's prism holds no tetrahedron of its vertices; it is a sum of them only where some
// reach out of it, and then something would have to be taken away again.
TEST(Tetrahedra, SchoenhardtsPrismIsNoSumOfThem) {
    EXPECT_FALSE(as_sum_of_tetrahedra(geometry::data_sets::schoenhardt_prism().view(), 5));
}

// Where a surface is a sum of tetrahedra, covering degrees are the numbers of those around a point,
// and its inner side is not seen.
TEST(Tetrahedra, CountTheCoveringDegree) {
    int sums = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        RandomStream random(seed);
        std::vector<Point> points(6);
        for (Point& point : points) {
            for (double& x : point)
                x = static_cast<double>(random.below(2001)) - 1000;
        }
        const Surface surface(kernel::families::random(6, 0, seed), points);
        const auto tetrahedra = as_sum_of_tetrahedra(surface.view(), 4);
        if (!tetrahedra) continue;
        ++sums;
        ASSERT_TRUE(is_sum_of_tetrahedra(surface.view(), *tetrahedra));
        EXPECT_FALSE(find_negative_view(surface.view(), rays, seed));
        for (int i = 0; i < 50; ++i) {
            const Point x(random.below(1000) - 500.25, random.below(1000) - 500.5,
                          random.below(1000) - 500.125);
            Index around = 0;
            for (const auto& [a, b, c, d] : *tetrahedra) {
                const auto side = [&](Vertex p, Vertex q, Vertex r) {
                    return geometry::orientation(surface.point(p), surface.point(q),
                                                 surface.point(r), x);
                };
                const bool inside = side(a, b, c) == side(a, d, b) &&
                                    side(a, b, c) == side(b, d, c) &&
                                    side(a, b, c) == side(c, d, a);
                around += inside ? 1 : 0;
            }
            EXPECT_EQ(covering_degree(surface.view(), x), around);
        }
    }
    EXPECT_GT(sums, 30);
}

}  // namespace
}  // namespace tightflip::properties
