#include "projection.hpp"

#include "shapes.hpp"
#include "surface_face.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

struct Projected {
    std::vector<Point> points;
    SurfaceView view;
    explicit Projected(const Surface& surface, double azimuth = 30, double elevation = 20)
        : points(project(surface.points(), azimuth, elevation)),
          view{surface.triangulation().table(), points} {}
};

TEST(Projection, AxesGoWhereTheViewSays) {
    const std::vector<Point> ends{{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
                                  {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};
    const auto expect_at = [&](double azimuth, double elevation, const Point& x, const Point& y,
                               const Point& z) {
        const std::vector<Point> seen = project(ends, azimuth, elevation);
        const double unit = seen[1].norm();
        EXPECT_TRUE(seen[1].isApprox(unit * x, 1e-12) && seen[0].isApprox(-unit * x, 1e-12));
        EXPECT_TRUE(seen[3].isApprox(unit * y, 1e-12)) << seen[3].transpose();
        EXPECT_TRUE(seen[5].isApprox(unit * z, 1e-12)) << seen[5].transpose();
    };
    const Point right(1, 0, 0);
    const Point up(0, 1, 0);
    const Point near(0, 0, 1);
    expect_at(0, 0, near, right, up);    // from the positive x axis
    expect_at(90, 0, -right, near, up);  // from the positive y axis
    expect_at(-90, 0, right, -near, up);
    expect_at(-90, 90, right, up, near);  // from above, as on a map
    expect_at(360 + 90, 0, -right, near, up);
}

TEST(Projection, KeepsShapesAndTheirSizeIsAboutOne) {
    for (const double factor : {1.0, 1e-320, 1e-300, 1e300, std::numeric_limits<double>::max()}) {
        const Surface surface = moved(with_random_points(kernel::families::stacked(40, 1), 3),
                                      Eigen::Affine3d(Eigen::Scaling(factor)));
        const std::vector<Point> seen = project(surface.points(), 17, -40);
        double largest = 0;
        for (const Point& point : seen)
            largest = std::max(largest, point.norm());
        EXPECT_GT(largest, 0.5) << factor;
        EXPECT_LT(largest, 4) << factor;
        if (factor < 1e-310) continue;  // such points have few digits
        const auto distance = [](const Point& a, const Point& b) {
            return (a * 0.25 - b * 0.25).stableNorm();
        };
        const double ratio = distance(seen[0], seen[1]) /
                             distance(surface.points()[0], surface.points()[1]) * factor;
        for (std::size_t i = 2; i < seen.size(); ++i) {
            EXPECT_NEAR(distance(seen[i], seen[0]) / ratio,
                        distance(surface.points()[i], surface.points()[0]) / factor, 1e-12);
        }
    }
}

TEST(Projection, PointsThatCoincideAreTheOrigin) {
    const std::vector<Point> points(5, Point(1e300, -2, 1e-300));
    for (const Point& point : project(points, 30, 20))
        EXPECT_EQ(point, Point(0, 0, 0));
    EXPECT_TRUE(project({}, 30, 20).empty());
}

TEST(EdgeLines, ParallelEdgesRunApartAndOthersStraight) {
    for (const Triangulation& triangulation : all_families()) {
        const Surface surface = with_random_points(triangulation, 5);
        const Projected projected(surface);
        const EdgeLines lines(projected.view);
        std::map<std::pair<Vertex, Vertex>, std::vector<std::vector<Point>>> by_ends;
        for (Index id = 0; id < triangulation.edge_count(); ++id) {
            const Halfedge h = halfedge_of(Edge{id});
            std::vector<Point> line;
            lines.trace(Edge{id}, line);
            EXPECT_EQ(line.front(), projected.view.origin(h));
            EXPECT_EQ(line.back(), projected.view.target(h));
            by_ends[std::minmax(triangulation.origin(h), triangulation.target(h))].push_back(line);
        }
        for (const auto& [ends, parallels] : by_ends) {
            if (parallels.size() == 1) {
                EXPECT_EQ(parallels[0].size(), 2U);
            }
            const double chord = (parallels[0].front() - parallels[0].back()).head<2>().norm();
            for (std::size_t i = 0; i < parallels.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    const Point a = parallels[i][parallels[i].size() / 2];
                    const Point b = parallels[j][parallels[j].size() / 2];
                    EXPECT_GT((a - b).head<2>().norm(),
                              0.1 * chord / static_cast<double>(parallels.size()));
                    EXPECT_LT((a - b).head<2>().norm(), 0.8 * chord);
                }
            }
        }
    }
}

/// A face's outline follows the lines of its edges, so that neighbours leave no gaps.
TEST(EdgeLines, OutlinesFollowTheLines) {
    const Surface surface = with_random_points(kernel::families::book(7), 3);
    const Projected projected(surface);
    const EdgeLines lines(projected.view);
    std::vector<Point> outline;
    std::vector<Point> line;
    for (const Halfedge face : surface.triangulation().faces()) {
        lines.outline(face, outline);
        std::size_t corners = 0;
        for (const Halfedge side : surface.triangulation().face_sides(face)) {
            lines.trace(edge_of(side), line);
            corners += line.size() - 1;
            for (const Point& p : line) {
                EXPECT_TRUE(std::ranges::any_of(
                    outline, [&](const Point& q) { return (p - q).head<2>().norm() < 1e-12; }));
            }
        }
        EXPECT_EQ(outline.size(), corners);
    }
}

/// Of the outline's area nothing is left out and nothing is taken twice; straight faces stay whole.
TEST(FacePieces, CoverTheirFaces) {
    for (const Triangulation& triangulation : all_families()) {
        const Surface surface = with_random_points(triangulation, 5);
        const Projected projected(surface);
        const EdgeLines lines(projected.view);
        std::map<Index, double> areas;
        std::map<Index, int> counts;
        for (const Piece& piece : face_pieces(projected.view, lines)) {
            ASSERT_EQ(piece.corners.size(), 3U);
            areas[piece.face] += seen_area(piece.corners[0], piece.corners[1], piece.corners[2]);
            ++counts[piece.face];
            const Halfedge h{piece.face};
            EXPECT_EQ(piece.is_front, seen_area(projected.view.origin(h), projected.view.target(h),
                                                projected.view.opposite(h)) > 0);
        }
        const std::vector<Halfedge> faces = triangulation.faces();
        ASSERT_EQ(areas.size(), faces.size());
        std::vector<Point> outline;
        for (const Halfedge h : faces) {
            lines.outline(h, outline);
            double area = 0;
            for (std::size_t i = 2; i < outline.size(); ++i)
                area += seen_area(outline[0], outline[i - 1], outline[i]);
            EXPECT_NEAR(areas.at(h.id), area, 1e-12);
            EXPECT_EQ(counts.at(h.id), static_cast<int>(outline.size()) - 2);
        }
    }
}

/// The faces at a vertex of degree 2 lie on each other, and yet their outlines differ.
TEST(FacePieces, TheTwoFacesOfAFinDiffer) {
    Surface surface = with_random_points(kernel::families::book(6), 8);
    const Projected projected(surface);
    const EdgeLines lines(projected.view);
    std::vector<Point> first;
    std::vector<Point> second;
    const std::vector<Halfedge> outgoing = surface.triangulation().outgoing();
    for (Index v = 2; v < 6; ++v) {  // the poles have labels 0 and 1
        const Halfedge h = outgoing[static_cast<std::size_t>(v)];
        ASSERT_EQ(surface.triangulation().degree(h), 2);
        lines.outline(h, first);
        lines.outline(twin(h), second);
        EXPECT_EQ(first.size(), second.size());
        const auto is_in_second = [&](const Point& p) {
            return std::ranges::any_of(
                second, [&](const Point& q) { return (p - q).head<2>().norm() < 1e-9; });
        };
        EXPECT_EQ(std::ranges::count_if(first, is_in_second), 3);  // the corners alone
    }
}

}  // namespace
}  // namespace tightflip::geometry
