/// \file
/// Signs against the same determinants in rational arithmetic, on points for which floating point
/// fails.
#include "shapes.hpp"
#include <tightflip/geometry/exact_predicates.hpp>

#include <cfenv>
#include <functional>
#include <limits>
#include <ostream>
#include <sstream>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

namespace tightflip::geometry {

static void PrintTo(Sign sign, std::ostream* out) {
    *out << static_cast<int>(sign);
}

namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;

RationalPoint difference(const Point& to, const Point& from) {
    return {Rational(to.x()) - Rational(from.x()), Rational(to.y()) - Rational(from.y()),
            Rational(to.z()) - Rational(from.z())};
}

RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Rational dot(const RationalPoint& u, const RationalPoint& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

Sign sign_of(const Rational& value) {
    return static_cast<Sign>(value.sign());
}

Sign orientation_by_definition(const Point& a, const Point& b, const Point& c, const Point& d) {
    return sign_of(dot(cross(difference(b, a), difference(c, a)), difference(d, a)));
}

bool collinear_by_definition(const Point& a, const Point& b, const Point& c) {
    return cross(difference(b, a), difference(c, a)) == RationalPoint{};
}

/// The side by the normals of abc and abd.
Sign coplanar_side_by_definition(const Point& a, const Point& b, const Point& c, const Point& d) {
    const RationalPoint ab = difference(b, a);
    return sign_of(dot(cross(ab, difference(c, a)), cross(ab, difference(d, a))));
}

Sign orientation_in_plane_by_definition(const Point& a, const Point& b, const Point& c) {
    return sign_of(cross(difference(b, a), difference(c, a))[2]);
}

/// The point above d on the paraboloid, against the plane through those above a, b, c.
Sign in_circle_by_definition(const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto lifted = [&](const Point& p) {
        RationalPoint u = difference(p, d);
        u[2] = u[0] * u[0] + u[1] * u[1];
        return u;
    };
    return sign_of(dot(cross(lifted(a), lifted(b)), lifted(c)));
}

using Quadruple = std::array<Point, 4>;

/// Any exponent a double can have, denormal numbers and zeros included.
double any_double(kernel::RandomStream& random) {
    const int exponent = static_cast<int>(random.below(2098)) - 1074;
    const double value = std::ldexp(random_coordinate(random), exponent);
    return random.below(8) == 0 ? 0 : value;
}

Point shaken(Point point, kernel::RandomStream& random) {
    for (double& x : point) {
        const auto direction = random.below(3);
        if (direction == 0) continue;
        x = std::nextafter(x, direction == 1 ? 1e308 : -1e308);
    }
    return point;
}

/// Nearly coplanar, often nearly or exactly collinear: combinations of points, rounded and shaken.
Quadruple nearly_degenerate(kernel::RandomStream& random) {
    Quadruple points{random_point(random), random_point(random), random_point(random), {}};
    if (random.below(3) == 0) points[2] = points[0] + 0.3 * (points[1] - points[0]);
    const double s = random_coordinate(random);
    const double t = random_coordinate(random);
    points[3] = points[0] + s * (points[1] - points[0]) + t * (points[2] - points[0]);
    if (random.below(4) == 0) points[3] = points[random.below(3)];
    if (random.below(2) == 0) points[3] = shaken(points[3], random);
    return points;
}

struct Regime {
    const char* name;
    int repetitions;
    std::function<Quadruple(kernel::RandomStream&)> points;
};

Quadruple each(const std::function<Point()>& make) {
    Quadruple points;
    for (Point& point : points)
        point = make();
    return points;
}

Quadruple scaled(Quadruple points, int exponent) {
    for (Point& point : points) {
        for (double& x : point)
            x = std::ldexp(x, exponent);
    }
    return points;
}

std::vector<Regime> regimes() {
    using Random = kernel::RandomStream;
    return {
        {"random", 500, [](Random& r) { return each([&] { return random_point(r); }); }},
        {"grid", 1500, [](Random& r) { return each([&] { return random_grid_point(r, 1); }); }},
        {"larger_grid", 500,
         [](Random& r) { return each([&] { return random_grid_point(r, 4); }); }},
        {"nearly_degenerate", 1500, nearly_degenerate},
        {"huge", 200, [](Random& r) { return scaled(nearly_degenerate(r), 1000); }},
        {"tiny", 200, [](Random& r) { return scaled(nearly_degenerate(r), -1000); }},
        {"denormal", 200, [](Random& r) { return scaled(nearly_degenerate(r), -1068); }},
        {"denormal_grid", 500,
         [](Random& r) { return scaled(each([&] { return random_grid_point(r, 1); }), -1074); }},
        {"largest", 200,
         [](Random& r) {
             return each([&] {
                 return Point(random_grid_point(r, 1) * std::numeric_limits<double>::max());
             });
         }},
        {"underflow_under_heights", 500,
         [](Random& r) {
             return each([&] {
                 Point point = random_point(r) * 0x1p-535;
                 point.z() = random_coordinate(r) * 0x1p+1000;
                 return point;
             });
         }},
        {"any", 200,
         [](Random& r) {
             return each([&] {
                 const double x = any_double(r);
                 const double y = any_double(r);
                 return Point(x, y, any_double(r));
             });
         }},
    };
}

class ExactPredicates : public testing::TestWithParam<Regime> {};

TEST_P(ExactPredicates, AgreeWithRationalArithmetic) {
    kernel::RandomStream random(20260);
    std::array<int, 3> seen{};
    for (int i = 0; i < GetParam().repetitions; ++i) {
        const auto [a, b, c, d] = GetParam().points(random);
        const auto where = [&, a = a, b = b, c = c, d = d] {
            std::ostringstream out;
            out << std::hexfloat << a.transpose() << "; " << b.transpose() << "; " << c.transpose()
                << "; " << d.transpose();
            return out.str();
        };
        const Sign sign = orientation_by_definition(a, b, c, d);
        ++seen.at(static_cast<std::size_t>(static_cast<int>(sign) + 1));
        ASSERT_EQ(orientation(a, b, c, d), sign) << where();
        ASSERT_EQ(orientation(b, a, c, d), -sign) << where();
        ASSERT_EQ(are_collinear(a, b, c), collinear_by_definition(a, b, c)) << where();
        ASSERT_EQ(are_collinear(a, b, d), collinear_by_definition(a, b, d)) << where();
        if (sign == Sign::zero && !collinear_by_definition(a, b, c)) {
            ASSERT_EQ(coplanar_side(a, b, c, d), coplanar_side_by_definition(a, b, c, d))
                << where();
        }
        const Sign turn = orientation_in_plane_by_definition(a, b, c);
        ASSERT_EQ(orientation_in_plane(a, b, c), turn) << where();
        if (turn == Sign::positive) {
            ASSERT_EQ(in_circle_in_plane(a, b, c, d), in_circle_by_definition(a, b, c, d))
                << where();
        }
    }
    EXPECT_GT(seen[0], 0);
    EXPECT_GT(seen[2], 0);
}

INSTANTIATE_TEST_SUITE_P(Regimes, ExactPredicates, testing::ValuesIn(regimes()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(ExactPredicatesConventions, AreThoseOfTheHeader) {
    const Point o(0, 0, 0);
    const Point x(1, 0, 0);
    const Point y(0, 1, 0);
    const Point z(0, 0, 1);
    EXPECT_EQ(orientation(o, x, y, z), Sign::positive);
    EXPECT_EQ(orientation(o, x, y, Point(5, 5, 0)), Sign::zero);
    EXPECT_EQ(orientation(o, x, y, -z), Sign::negative);
    EXPECT_EQ(coplanar_side(o, x, y, Point(-3, 2, 0)), Sign::positive);
    EXPECT_EQ(coplanar_side(o, x, y, Point(-3, 0, 0)), Sign::zero);
    EXPECT_EQ(coplanar_side(o, x, y, Point(-3, -2, 0)), Sign::negative);
    EXPECT_EQ(orientation_in_plane(o, x, y), Sign::positive);
    EXPECT_EQ(orientation_in_plane(o + 7 * z, x, y), Sign::positive);
    EXPECT_EQ(in_circle_in_plane(o, x, y, Point(0.5, 0.5, 9)), Sign::positive);
    EXPECT_EQ(in_circle_in_plane(o, x, y, Point(1, 1, 0)), Sign::zero);
    EXPECT_EQ(in_circle_in_plane(o, x, y, Point(2, 2, 0)), Sign::negative);
    EXPECT_TRUE(are_collinear(o, o, y));
    EXPECT_TRUE(are_collinear(x, x, x));
    EXPECT_EQ(-Sign::positive, Sign::negative);
    EXPECT_EQ(-Sign::zero, Sign::zero);
}

TEST(ExactPredicatesConventions, TheRoundingModeIsLeftAsItWas) {
    const Point o(0, 0, 0);
    const Point x(0.1, 0.7, 0.3);
    (void)orientation(o, x, 3 * x, 7 * x);
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

}  // namespace
}  // namespace tightflip::geometry
