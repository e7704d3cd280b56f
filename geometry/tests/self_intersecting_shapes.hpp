/// \file
/// Surfaces that meet themselves in a known way, and tori.
#pragma once

#include "shapes.hpp"

#include <numbers>

namespace tightflip::geometry {

/// Over a rim between two poles 0 and 1 at heights 1 and -1, the rim's vertices in the order given.
inline Surface bipyramid(const std::vector<Point>& rim) {
    const auto size = static_cast<Index>(rim.size());
    std::vector<Point> points{{0, 0, 1}, {0, 0, -1}};
    points.insert(points.end(), rim.begin(), rim.end());
    Faces faces;
    for (Index i = 0; i < size; ++i) {
        const Index a = 2 + i;
        const Index b = 2 + (i + 1) % size;
        faces.push_back({0, a, b});
        faces.push_back({1, b, a});
    }
    return make_surface(faces, std::move(points));
}

/// The rim goes round the axis `turns` times.
inline Surface wound_bipyramid(Index rim_size, int turns) {
    std::vector<Point> rim;
    for (Index i = 0; i < rim_size; ++i) {
        const double turn = 2 * std::numbers::pi * turns * i / rim_size;
        rim.emplace_back(std::cos(turn), std::sin(turn), 0);
    }
    return bipyramid(rim);
}

/// The rim is a figure eight that crosses itself on the axis.
inline Surface bow_tie() {
    return bipyramid({{1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}});
}

/// Radii 3 and 1 about the third axis.
inline Surface round_torus(Index m, Index n) {
    std::vector<Point> points;
    for (Index i = 0; i < m; ++i) {
        for (Index j = 0; j < n; ++j) {
            const double u = 2 * std::numbers::pi * i / m;
            const double v = 2 * std::numbers::pi * j / n;
            const double r = 3 + std::cos(v);
            points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
        }
    }
    return {kernel::families::torus_grid(m, n), std::move(points)};
}

/// All coordinates times a power of two.
inline Surface scaled(const Surface& surface, int exponent) {
    std::vector<Point> points(surface.points().begin(), surface.points().end());
    for (Point& point : points) {
        for (double& x : point)
            x = std::ldexp(x, exponent);
    }
    return {surface.triangulation(), std::move(points)};
}

}  // namespace tightflip::geometry
