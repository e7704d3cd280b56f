#include "axis_sweep.hpp"

#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

/// Coordinates between -1 and 1.
Point random_point(kernel::RandomStream& random) {
    const auto coordinate = [&] { return std::ldexp(double(random.bits() >> 11), -52) - 1; };
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, coordinate()};
}

/// A plane through a point that has all other points strictly on its positive side, and in it the
/// axis from that point to `o`.
struct Touching {
    Vertex hub;
    Point o;
};

std::optional<Touching> touching_axis(Points points, kernel::RandomStream& random) {
    const Point up = random_point(random).normalized();
    const Point across = up.cross(random_point(random)).normalized();
    const Point forth = up.cross(across);
    if (!up.allFinite() || !across.allFinite()) return std::nullopt;
    const auto lowest = std::ranges::min_element(
        points, {}, [&](const Point& point) { return up.dot(0.25 * point); });
    double reach = 0;  // a part of the extent, which might be too large for a number
    for (const Point& point : points)
        reach = std::max(reach, (0.25 * point - 0.25 * *lowest).cwiseAbs().maxCoeff());
    const Point o = *lowest + reach * across;
    const Point q = *lowest + reach * forth;
    if (!o.allFinite() || !q.allFinite()) return std::nullopt;
    const bool touches = std::ranges::all_of(points, [&](const Point& point) {
        return &point == &*lowest || orientation(*lowest, o, q, point) == Sign::positive;
    });
    if (!touches) return std::nullopt;
    return Touching{{static_cast<Index>(lowest - points.begin())}, o};
}

}  // namespace

std::optional<AxisSweep> axis_sweep(Points points, const PerturbedPoints& perturbed,
                                    std::uint64_t seed) {
    kernel::RandomStream random(seed);
    constexpr int most_tries = 100;
    for (int i = 0; i < most_tries; ++i) {
        const auto axis = touching_axis(points, random);
        if (!axis) continue;
        AxisSweep sweep{axis->hub, {}};
        for (Index v = 0; v < static_cast<Index>(points.size()); ++v) {
            if (v != axis->hub.id) sweep.order.push_back({v});
        }
        bool has_ties = false;
        std::ranges::sort(sweep.order, [&](Vertex x, Vertex y) {
            const Sign side = perturbed.side_about(axis->hub, axis->o, x, y);
            has_ties = has_ties || (side == Sign::zero && x != y);
            return side == Sign::positive;
        });
        if (!has_ties) return sweep;
    }
    return std::nullopt;
}

}  // namespace tightflip::geometry
