/// \file
/// Points in units in which products of many lengths neither overflow nor vanish.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tightflip::geometry {

/// The points as they are where their size is moderate; otherwise copies in units of a power of
/// two, which changes no digit of any that counts.
class ScaledPoints {
public:
    explicit ScaledPoints(Points points) : points_(points) {
        double extent = 0;
        for (const Point& point : points)
            extent = std::max(extent, point.cwiseAbs().maxCoeff());
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
    /// A measure of the given dimension in the units of the coordinates.
    [[nodiscard]] double in_units(double value, int dimension) const {
        return exponent_ == 0 ? value : std::ldexp(value, dimension * exponent_);
    }

private:
    std::vector<Point> own_;
    Points points_;
    int exponent_ = 0;
};

}  // namespace tightflip::geometry
