#include <tightflip/properties/simpler_points.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace tightflip::properties {
namespace {

using geometry::Point;
using PointList = std::vector<Point>;

constexpr double most_integer = 1024;

bool is_small_integer(double x) {
    return std::abs(x) < most_integer && x == std::round(x);
}

struct Complexity {
    std::int64_t others = 0;  ///< coordinates that are not small integers
    std::int64_t sum = 0;     ///< of the sizes of those that are
    std::int64_t negative = 0;

    explicit Complexity(geometry::Points points) {
        for (const Point& point : points) {
            for (const double x : point) {
                negative += std::signbit(x) ? 1 : 0;
                if (is_small_integer(x)) {
                    sum += static_cast<std::int64_t>(std::abs(x));
                } else {
                    ++others;
                }
            }
        }
    }
    // NOLINTNEXTLINE(modernize-use-nullptr): the comparison with 0 is inside the defaulted operator
    friend auto operator<=>(const Complexity&, const Complexity&) = default;
};

/// The points on a grid of the integers to `size`, the largest coordinate there.
PointList on_grid(geometry::Points points, int size) {
    double largest = 0;
    for (const Point& point : points)
        largest = std::max(largest, point.cwiseAbs().maxCoeff());
    PointList rounded(points.begin(), points.end());
    for (Point& point : rounded) {
        for (double& x : point)
            x = std::round(x / largest * size) + 0.0;  // no negative zero
    }
    return rounded;
}

/// What may take the place of one coordinate, the simplest first.
std::vector<double> simpler_values(double x) {
    const double sign = x < 0 ? -1 : 1;
    if (!is_small_integer(x)) return {0, sign, std::round(x)};
    return {0, std::abs(x), std::trunc(x / 2) + 0.0, x - sign};
}

}  // namespace

std::vector<PointList> simpler_points(geometry::Points points) {
    const Complexity now(points);
    std::vector<PointList> simpler;
    const auto offer = [&](PointList candidate) {
        if (Complexity(candidate) < now) simpler.push_back(std::move(candidate));
    };
    if (now == Complexity({})) return simpler;
    offer(PointList(points.size(), Point::Zero()));
    for (int size = 1; size < most_integer; size *= 2)
        offer(on_grid(points, size));
    PointList changed(points.begin(), points.end());
    for (Point& point : changed) {
        const Point before = point;
        for (const Point& place : {Point(0, 0, 0), points.front()}) {
            point = place;
            offer(changed);
        }
        point = before;
    }
    for (Point& point : changed) {
        for (double& x : point) {
            const double before = x;
            for (const double value : simpler_values(before)) {
                x = value;
                offer(changed);
            }
            x = before;
        }
    }
    return simpler;
}

}  // namespace tightflip::properties
