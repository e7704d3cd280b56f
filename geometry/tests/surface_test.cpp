#include "shapes.hpp"

#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<Point> four_points() {
    return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

TEST(Surface, RefusesAnotherNumberOfPoints) {
    const auto points = std::vector<Point>(5, Point::Zero());
    EXPECT_THAT([&] { Surface(kernel::families::tetrahedron(), points); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("5 points for 4 vertices")));
}

TEST(Surface, RefusesCoordinatesThatAreNotFiniteAndNamesTheVertex) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            auto points = four_points();
            points[2][axis] = bad;
            EXPECT_THAT([&] { Surface(kernel::families::tetrahedron(), points); },
                        ThrowsMessage<std::invalid_argument>(HasSubstr("vertex 2 ")));
        }
    }
}

TEST(Surface, TakesTheLargestAndSmallestCoordinates) {
    auto points = four_points();
    points[1] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
                 std::numeric_limits<double>::denorm_min()};
    const Surface surface(kernel::families::tetrahedron(), points);
    EXPECT_EQ(surface.point(Vertex{1}), points[1]);
}

TEST(Surface, ChecksTheVertexOfAPoint) {
    const Surface surface(kernel::families::tetrahedron(), four_points());
    EXPECT_THROW((void)surface.point(Vertex{4}), std::out_of_range);
    EXPECT_THROW((void)surface.point(Vertex{}), std::out_of_range);
}

TEST(Surface, ViewSeesTheCornersOfEachFace) {
    const Surface surface = with_random_points(kernel::families::stacked(20, 4), 5);
    const Triangulation& t = surface.triangulation();
    const SurfaceView view = surface.view();
    EXPECT_EQ(view.edge_count(), t.edge_count());
    for (Index id = 0; id < t.halfedge_count(); ++id) {
        const Halfedge h{id};
        EXPECT_EQ(view.origin(h), surface.point(t.origin(h)));
        EXPECT_EQ(view.target(h), surface.point(t.target(h)));
        EXPECT_EQ(view.opposite(h), surface.point(t.opposite(h)));
    }
}

TEST(Surface, FlipsShowInTheViewAndLeaveThePoints) {
    Surface surface = with_random_points(kernel::families::octasphere(1), 6);
    const std::vector<Point> before(surface.points().begin(), surface.points().end());
    const SurfaceView view = surface.view();
    const Halfedge h = halfedge_of(Edge{3});
    const Point c = view.opposite(h);
    const Point d = view.opposite(twin(h));
    ASSERT_TRUE(surface.triangulation().flip(Edge{3}));
    EXPECT_EQ(view.origin(h), d);
    EXPECT_EQ(view.target(h), c);
    EXPECT_TRUE(std::ranges::equal(surface.points(), before));
}

}  // namespace
}  // namespace tightflip::geometry
