#include "shapes.hpp"
#include <tightflip/geometry/delaunay.hpp>
#include <tightflip/geometry/exact_predicates.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

const Point& at(Points points, Index i) {
    return points[static_cast<std::size_t>(i)];
}

/// Twice the area.
double doubled_area(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Triangles with empty circles that fill the polygon of the boundary, which is convex and holds
/// all points; `expected_area` of the convex hull where it is known.
void expect_is_delaunay(Points points, const PlaneTriangulation& plane) {
    std::set<Index> used;
    double area = 0;
    for (const auto& [a, b, c] : plane.faces) {
        used.insert({a, b, c});
        ASSERT_EQ(orientation_in_plane(at(points, a), at(points, b), at(points, c)),
                  Sign::positive);
        area += doubled_area(at(points, a), at(points, b), at(points, c));
        for (const Point& x : points) {
            ASSERT_NE(in_circle_in_plane(at(points, a), at(points, b), at(points, c), x),
                      Sign::positive);
        }
    }
    EXPECT_EQ(used.size(), points.size());
    const std::size_t sides = plane.boundary.size();
    EXPECT_EQ(plane.faces.size(), 2 * points.size() - 2 - sides);
    double around = 0;
    for (std::size_t i = 0; i < sides; ++i) {
        const Point& a = at(points, plane.boundary[i]);
        const Point& b = at(points, plane.boundary[(i + 1) % sides]);
        around += a.x() * b.y() - a.y() * b.x();
        for (const Point& x : points)
            ASSERT_NE(orientation_in_plane(a, b, x), Sign::negative);
    }
    EXPECT_NEAR(area, around, 1e-9 * around);
}

/// At an edge between triangles on one circle, the highest of the four labels is not an end of it.
void expect_ties_leave_out_the_highest(Points points, const std::vector<Face>& faces) {
    std::map<std::pair<Index, Index>, Index> third;
    for (const auto& [a, b, c] : faces) {
        third[{a, b}] = c;
        third[{b, c}] = a;
        third[{c, a}] = b;
    }
    int ties = 0;
    for (const auto& [side, c] : third) {
        const auto [a, b] = side;
        const auto beyond = third.find({b, a});
        if (beyond == third.end()) continue;
        const Index d = beyond->second;
        if (in_circle_in_plane(at(points, a), at(points, b), at(points, c), at(points, d)) !=
            Sign::zero) {
            continue;
        }
        ++ties;
        EXPECT_GT(std::max(c, d), std::max(a, b));
    }
    EXPECT_GT(ties, 0);
}

TEST(Delaunay, RandomPointsHaveEmptyCircles) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        kernel::RandomStream random(seed);
        std::vector<Point> points;
        while (points.size() < 3 + 25 * seed)
            points.push_back(random_point(random));
        expect_is_delaunay(points, delaunay_in_plane(points).value());
    }
}

TEST(Delaunay, GridPointsHaveEmptyCirclesAndTiesByTheRule) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        std::vector<Point> points;
        const int side = 3 + static_cast<int>(seed % 7);
        for (int x = 0; x <= side; ++x) {
            for (int y = 0; y <= side; ++y)
                points.emplace_back(x, y, 0);
        }
        kernel::RandomStream(seed).shuffle(std::span(points));
        if (seed % 2 == 1) points.resize(points.size() * 3 / 4);
        SCOPED_TRACE(seed);
        const auto plane = delaunay_in_plane(points).value();
        expect_is_delaunay(points, plane);
        expect_ties_leave_out_the_highest(points, plane.faces);
    }
}

TEST(Delaunay, PointsOnOneCircle) {
    // Twelve points of x^2 + y^2 = 25, exactly on a circle.
    std::vector<Point> points;
    for (const auto& [x, y] : {std::pair{5, 0},
                               {4, 3},
                               {3, 4},
                               {0, 5},
                               {-3, 4},
                               {-4, 3},
                               {-5, 0},
                               {-4, -3},
                               {-3, -4},
                               {0, -5},
                               {3, -4},
                               {4, -3}}) {
        points.emplace_back(x, y, 7);
    }
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        kernel::RandomStream(seed).shuffle(std::span(points));
        const auto plane = delaunay_in_plane(points).value();
        expect_is_delaunay(points, plane);
        expect_ties_leave_out_the_highest(points, plane.faces);
        EXPECT_EQ(plane.faces.size(), 10U);
    }
}

TEST(Delaunay, LargeSetsStaySound) {
    kernel::RandomStream random(3);
    std::vector<Point> points;
    while (points.size() < 50000)
        points.push_back(random_point(random));
    const auto plane = delaunay_in_plane(points).value();
    EXPECT_EQ(plane.faces.size(), 2 * points.size() - 2 - plane.boundary.size());
    std::map<std::pair<Index, Index>, Index> third;
    for (const auto& [a, b, c] : plane.faces) {
        third[{a, b}] = c;
        third[{b, c}] = a;
        third[{c, a}] = b;
    }
    for (const auto& [side, c] : third) {  // locally Delaunay everywhere is Delaunay
        const auto beyond = third.find({side.second, side.first});
        if (beyond == third.end()) continue;
        ASSERT_NE(in_circle_in_plane(at(points, side.first), at(points, side.second), at(points, c),
                                     at(points, beyond->second)),
                  Sign::positive);
    }
}

TEST(Delaunay, IsTheSameAtAllScales) {
    kernel::RandomStream random(8);
    std::vector<Point> points;
    while (points.size() < 60)
        points.push_back(random_grid_point(random, 1000));
    const auto plane = delaunay_in_plane(points).value();
    for (const int exponent : {-800, 900}) {
        std::vector<Point> scaled;
        for (const Point& p : points)
            scaled.emplace_back(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), 0);
        EXPECT_EQ(delaunay_in_plane(scaled).value().faces, plane.faces);
    }
}

TEST(Delaunay, RefusesWhatHasNone) {
    const auto refusal = [](const std::vector<Point>& points) {
        return delaunay_in_plane(points).refusal();
    };
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}}).fault, DataFault::too_few_points);
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 1, 5}, {2, 2, 0}, {3, 3, 1}}).fault,
              DataFault::collinear_points);
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 1, 5}, {2, 0, 0}, {1, 1, 6}}),
              (DataRefusal{DataFault::coincident_points, {1, 3}}));
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {2, 1, -INFINITY}}).fault, DataFault::not_finite);
}

}  // namespace
}  // namespace tightflip::geometry
