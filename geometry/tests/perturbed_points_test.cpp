#include "perturbed_points.hpp"

#include "shapes.hpp"

#include <array>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;

/// The points really moved, by a small t.
class MovedPoints {
public:
    MovedPoints(Points points, const std::array<Index, 4>& inside) {
        RationalPoint centre;
        for (const Index label : inside) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                centre[axis] +=
                    Rational(
                        points[static_cast<std::size_t>(label)][static_cast<Eigen::Index>(axis)]) /
                    4;
            }
        }
        for (const Point& point : points) {
            RationalPoint p = from_centre(point, centre);
            const Rational square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
            for (Rational& x : p)
                x /= 1 + small * square;
            points_.push_back(p);
        }
        centre_ = centre;
    }
    [[nodiscard]] static RationalPoint from_centre(const Point& p, const RationalPoint& centre) {
        return {p.x() - centre[0], p.y() - centre[1], p.z() - centre[2]};
    }
    [[nodiscard]] const RationalPoint& at(Index label) const {
        return points_.at(static_cast<std::size_t>(label));
    }
    [[nodiscard]] RationalPoint unmoved(const Point& p) const { return from_centre(p, centre_); }

    [[nodiscard]] static Sign orientation(const RationalPoint& a, const RationalPoint& b,
                                          const RationalPoint& c, const RationalPoint& d) {
        const auto less = [&](const RationalPoint& p) {
            return RationalPoint{p[0] - a[0], p[1] - a[1], p[2] - a[2]};
        };
        const RationalPoint u = less(b);
        const RationalPoint v = less(c);
        const RationalPoint w = less(d);
        const Rational determinant = u[0] * (v[1] * w[2] - v[2] * w[1]) -
                                     u[1] * (v[0] * w[2] - v[2] * w[0]) +
                                     u[2] * (v[0] * w[1] - v[1] * w[0]);
        return static_cast<Sign>(determinant.sign());
    }

private:
    inline static const Rational small{1, Rational(0x1p60)};
    std::vector<RationalPoint> points_;
    RationalPoint centre_;
};

TEST(PerturbedPoints, HaveTheSignsOfPointsMovedALittle) {
    kernel::RandomStream random(5);
    int decided_by_motion = 0;
    for (int round = 0; round < 40; ++round) {
        std::vector<Point> points;
        for (int i = 0; i < 9; ++i)
            points.push_back(random_grid_point(random, 1) * (round % 2 == 0 ? 1 : 0x1.8p-400));
        points.push_back(points.front() + Point(1, 0, 0) * points.back().cwiseAbs().maxCoeff());
        const std::array<Index, 4> inside{0, 3, 5, 7};
        const PerturbedPoints perturbed(points, inside);
        const MovedPoints moved(points, inside);
        const Point fixed = random_grid_point(random, 2);
        for (int i = 0; i < 60; ++i) {
            std::array<Index, 4> v{};
            for (Index& label : v)
                label = static_cast<Index>(random.below(10));
            const Sign expected = MovedPoints::orientation(moved.at(v[0]), moved.at(v[1]),
                                                           moved.at(v[2]), moved.at(v[3]));
            const Sign sign = perturbed.side({v[0]}, {v[1]}, {v[2]}, {v[3]});
            // What is zero to first order may differ from zero further on.
            if (sign != Sign::zero) {
                EXPECT_EQ(sign, expected);
            }
            const Sign unmoved = orientation(
                points[static_cast<std::size_t>(v[0])], points[static_cast<std::size_t>(v[1])],
                points[static_cast<std::size_t>(v[2])], points[static_cast<std::size_t>(v[3])]);
            if (unmoved == Sign::zero && sign != Sign::zero) ++decided_by_motion;
            if (unmoved != Sign::zero) {
                EXPECT_EQ(sign, unmoved);
            }
            const Sign about = perturbed.side_about({v[0]}, fixed, {v[2]}, {v[3]});
            if (about != Sign::zero) {
                EXPECT_EQ(about, MovedPoints::orientation(moved.at(v[0]), moved.unmoved(fixed),
                                                          moved.at(v[2]), moved.at(v[3])));
            }
        }
    }
    EXPECT_GT(decided_by_motion, 50);
}

TEST(PerturbedPoints, WithinAFacetComeToLieOutside) {
    // A cube with the midpoints of an edge and of a facet.
    std::vector<Point> points;
    for (int v = 0; v < 8; ++v)
        points.emplace_back(2 * (v & 1), v & 2, (v & 4) / 2);
    points.emplace_back(1, 0, 0);
    points.emplace_back(1, 1, 0);
    const PerturbedPoints perturbed(points, {0, 1, 2, 4});
    // The bottom, seen from below, through three of its corners and the edge's midpoint.
    EXPECT_EQ(perturbed.side({0}, {2}, {1}, {9}), Sign::positive);
    EXPECT_EQ(perturbed.side({0}, {2}, {1}, {8}), Sign::positive);
    // Four corners of it are on one circle, which tells nothing.
    EXPECT_EQ(perturbed.side({4}, {5}, {7}, {6}), Sign::zero);
}

}  // namespace
}  // namespace tightflip::geometry
