/// \file
/// Points in units in which products of many lengths neither overflow nor vanish.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tightflip::geometry {

/// The points as they are where their size is moderate; otherwise copies in units of a power of
/// two, which changes no digit of any that counts.
class ScaledPoints {
public:
    /// The point of `left_out`, if there is one, is not to be used and has no say in the units.
    explicit ScaledPoints(Points points, Vertex left_out = {}) : points_(points) {
        double extent = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (static_cast<Index>(i) == left_out.id) continue;
            extent = std::max(extent, points[i].cwiseAbs().maxCoeff());
        }
        if (extent == 0 || (extent > 0x1p-30 && extent < 0x1p30)) return;
        exponent_ = std::ilogb(extent);
        own_.assign(points.begin(), points.end());
        for (Point& point : own_) {
            for (double& coordinate : point)
                coordinate = std::ldexp(coordinate, -exponent_);
        }
        points_ = own_;
    }
    ScaledPoints(const ScaledPoints&) = delete;
    ScaledPoints& operator=(const ScaledPoints&) = delete;

    [[nodiscard]] Points points() const noexcept { return points_; }
    /// A measure of the given dimension in the units of the coordinates. Where it leaves the range
    /// of doubles it is their largest or smallest, so that its sign stands and sums are no NaN.
    [[nodiscard]] double in_units(double value, int dimension) const {
        if (exponent_ == 0 || value == 0) return value;
        const double size = std::ldexp(std::abs(value), dimension * exponent_);
        return std::copysign(std::clamp(size, std::numeric_limits<double>::min(),
                                        std::numeric_limits<double>::max()),
                             value);
    }

private:
    std::vector<Point> own_;
    Points points_;
    int exponent_ = 0;
};

}  // namespace tightflip::geometry
