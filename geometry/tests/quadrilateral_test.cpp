#include "shapes.hpp"
#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/geometry/quadrilateral.hpp>

#include <algorithm>
#include <optional>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

/// Edge 01 of a tetrahedron from (0, 0, 0) to (4, 0, 0), its opposite corners as given.
Surface around_edge(const Point& left, const Point& right) {
    return make_surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                        {{0, 0, 0}, {4, 0, 0}, left, right});
}

QuadrilateralType type_of(const Surface& surface) {
    return quadrilateral_type(surface.view(), edge_between(surface, 0, 1));
}
Development development_of(const Surface& surface) {
    return development(surface.view(), edge_between(surface, 0, 1));
}

TEST(Quadrilateral, HasTheFourTypesOfThePaper) {
    EXPECT_EQ(type_of(around_edge({2, 1, 0}, {2, -1, -1})), QuadrilateralType::cc);
    EXPECT_EQ(type_of(around_edge({2, 1, 0}, {2, -1, 1})), QuadrilateralType::cr);
    EXPECT_EQ(type_of(around_edge({-2, 1, 0}, {-2, -1, -1})), QuadrilateralType::rc);
    EXPECT_EQ(type_of(around_edge({-2, 1, 0}, {-2, -1, 1})), QuadrilateralType::rr);
    EXPECT_EQ(type_of(around_edge({6, 1, 0}, {6, -1, -1})), QuadrilateralType::rc);
    EXPECT_EQ(type_of(around_edge({6, 1, 0}, {6, -1, 1})), QuadrilateralType::rr);
}

TEST(Quadrilateral, HasNoTypeOutOfGeneralPosition) {
    for (const Point& right : {Point(2, -1, 0),      // flat
                               Point(2, 2, 0),       // folded
                               Point(1, 0, 0),       // degenerate
                               Point(0, -1, -1)}) {  // straight: two right angles
        EXPECT_EQ(type_of(around_edge({0, 1, 0}, right)), QuadrilateralType::none);
    }
}

TEST(Quadrilateral, DevelopmentIsDecidedWithoutRounding) {
    EXPECT_EQ(development_of(around_edge({0, 1, 0}, {0, -1, -1})), Development::straight);
    EXPECT_EQ(development_of(around_edge({0, 1, 0}, {1e-300, -1, -1})), Development::convex);
    EXPECT_EQ(development_of(around_edge({0, 1, 0}, {-1e-300, -1, -1})), Development::reflex);
    EXPECT_EQ(development_of(around_edge({4, 3, 0}, {4, -3, 7})), Development::straight);
    EXPECT_EQ(development_of(around_edge({4, 3, 0}, {3.9999999999999996, -3, 7})),
              Development::convex);
    EXPECT_EQ(development_of(around_edge({4, 3, 0}, {4.000000000000001, -3, 7})),
              Development::reflex);
    // 60 degrees and 120 degrees, irrational cosines avoided: lengths sqrt(8) and sqrt(2).
    EXPECT_EQ(development_of(around_edge({2, 2, 0}, {-1, 0, -1})), Development::straight);
    EXPECT_EQ(development_of(around_edge({2, 2, 0}, {-1, 0, -1.0000000000000002})),
              Development::convex);
    EXPECT_EQ(development_of(around_edge({2, 2, 0}, {-1.0000000000000002, 0, -1})),
              Development::reflex);
    EXPECT_EQ(development_of(around_edge({1, 0, 0}, {2, 1, 0})), Development::degenerate);
    EXPECT_EQ(development_of(around_edge({1, 1, 0}, {4, 0, 0})), Development::degenerate);
}

using Long = boost::multiprecision::cpp_bin_float_100;
using LongVector = std::array<Long, 3>;

Long angle(const Point& apex, const Point& b, const Point& c) {
    LongVector u;
    LongVector v;
    for (Eigen::Index i = 0; i < 3; ++i) {
        u[static_cast<std::size_t>(i)] = Long(b[i]) - Long(apex[i]);
        v[static_cast<std::size_t>(i)] = Long(c[i]) - Long(apex[i]);
    }
    const auto dot = [](const LongVector& x, const LongVector& y) -> Long {
        return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    };
    const LongVector w{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]};
    return atan2(Long(sqrt(dot(w, w))), dot(u, v));
}

/// By the angles themselves, to a hundred digits; empty where these do not tell.
std::optional<Development> development_by_angles(const SurfaceView& surface, Edge e) {
    const Halfedge h = halfedge_of(e);
    const Point& a = surface.origin(h);
    const Point& b = surface.target(h);
    const Point& c = surface.opposite(h);
    const Point& d = surface.opposite(twin(h));
    const Long pi = boost::math::constants::pi<Long>();
    const Long at_a = angle(a, b, c) + angle(a, b, d);
    const Long at_b = angle(b, a, c) + angle(b, a, d);
    const Long excess = std::max(at_a, at_b) - pi;
    if (abs(excess) < Long(1e-80)) return std::nullopt;
    return excess < 0 ? Development::convex : Development::reflex;
}

TEST(Quadrilateral, DevelopmentAgreesWithItsAnglesToAHundredDigits) {
    std::array<int, 4> seen{};
    int undecided = 0;
    const auto check = [&](const Surface& surface) {
        for (Index id = 0; id < surface.triangulation().edge_count(); ++id) {
            const Development found = development(surface.view(), Edge{id});
            ++seen.at(static_cast<std::size_t>(found));
            if (found == Development::degenerate) {
                EXPECT_EQ(edge_shape(surface.view(), Edge{id}), EdgeShape::degenerate);
                continue;
            }
            const auto expected = development_by_angles(surface.view(), Edge{id});
            if (!expected) ++undecided;
            EXPECT_EQ(found, expected.value_or(Development::straight));
        }
    };
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Triangulation triangulation = kernel::families::random(20, 0, seed);
        check(with_random_points(triangulation, seed));
        check(with_grid_points(triangulation, seed, 2));
        for (const double factor : {1e-150, 1e-75, 1e150}) {
            check(moved(with_grid_points(triangulation, seed, 3),
                        Eigen::Affine3d(Eigen::Scaling(factor))));
        }
    }
    EXPECT_GT(seen[0], 100);
    EXPECT_GT(seen[1], 3);
    EXPECT_GT(seen[2], 100);
    EXPECT_GT(seen[3], 3);
    EXPECT_GT(undecided, 0);
}

/// One corner is the other's reflection in the point a, turned about the edge, scaled and rounded.
TEST(Quadrilateral, NearlyStraightDevelopmentsAgreeWithTheirAngles) {
    kernel::RandomStream random(8);
    std::array<int, 4> seen{};
    for (int trial = 0; trial < 300; ++trial) {
        const Point c = random_point(random);
        const Eigen::AngleAxisd turn(random_coordinate(random), Point::UnitX());
        const Point d = turn * Point(c * (0.1 * random_coordinate(random) - 1));
        const Surface surface = around_edge(c, d);
        const Edge e = edge_between(surface, 0, 1);
        const Development found = development(surface.view(), e);
        ASSERT_EQ(found, development_by_angles(surface.view(), e).value_or(Development::straight));
        ++seen.at(static_cast<std::size_t>(found));
    }
    EXPECT_GT(seen[0], 50);
    EXPECT_GT(seen[2], 50);
}

TEST(Quadrilateral, TakesTheLargestAndSmallestCoordinates) {
    for (const int exponent : {-1070, -1000, 0, 1000, 1020}) {
        const double unit = std::ldexp(1.0, exponent);
        const auto type = [&](const Point& right) {
            return type_of(
                moved(around_edge({2, 1, 0}, right), Eigen::Affine3d(Eigen::Scaling(unit))));
        };
        EXPECT_EQ(type({2, -1, -1}), QuadrilateralType::cc) << exponent;
        EXPECT_EQ(type({2, -1, 1}), QuadrilateralType::cr) << exponent;
        EXPECT_EQ(type({-6, -1, -1}), QuadrilateralType::rc) << exponent;
        EXPECT_EQ(type({-6, -1, 1}), QuadrilateralType::rr) << exponent;
    }
}

/// The letter of the edge changes with a flip; the development need not stay convex.
TEST(Quadrilateral, FlipsExchangeTheSecondLetter) {
    std::array<std::array<int, 4>, 4> changes{};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Surface surface = with_random_points(kernel::families::random(20, 0, seed), seed);
        for (Index id = 0; id < surface.triangulation().edge_count(); ++id) {
            const auto before = quadrilateral_type(surface.view(), Edge{id});
            if (!surface.triangulation().flip(Edge{id})) continue;
            const auto after = quadrilateral_type(surface.view(), Edge{id});
            ASSERT_NE(before, QuadrilateralType::none);
            ASSERT_NE(after, QuadrilateralType::none);
            ++changes.at(static_cast<std::size_t>(before)).at(static_cast<std::size_t>(after));
        }
    }
    for (std::size_t before = 0; before < 4; ++before) {
        for (std::size_t after = 0; after < 4; ++after) {
            if (before % 2 == after % 2) {
                EXPECT_EQ(changes.at(before).at(after), 0) << before << ' ' << after;
            }
        }
    }
    EXPECT_GT(changes[0][1] + changes[1][0], 0);
    EXPECT_GT(changes[2][1] + changes[3][0], 0);
}

}  // namespace
}  // namespace tightflip::geometry
