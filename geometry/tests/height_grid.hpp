/// \file
/// Functional surfaces for tests: heights over a grid, closed by a marked vertex.
#pragma once

#include "shapes.hpp"

#include <functional>

namespace tightflip::geometry {

struct HeightGrid {
    Surface surface;
    Vertex marked;
};

/// n x n points over the unit square, each cell cut by one diagonal, or the other, or alternating;
/// `place` moves each point of the plane and gives its height.
inline HeightGrid height_grid(Index n, const std::function<Point(double, double)>& place) {
    std::vector<Point> points;
    for (Index y = 0; y < n; ++y) {
        for (Index x = 0; x < n; ++x)
            points.push_back(
                place(static_cast<double>(x) / (n - 1), static_cast<double>(y) / (n - 1)));
    }
    const Vertex marked{n * n};
    points.emplace_back(0.5, 0.5, -3);
    Faces faces;
    for (Index y = 0; y + 1 < n; ++y) {
        for (Index x = 0; x + 1 < n; ++x) {
            const Index a = y * n + x;
            if ((x + y) % 2 == 0) {
                faces.push_back({a, a + 1, a + n + 1});
                faces.push_back({a, a + n + 1, a + n});
            } else {
                faces.push_back({a, a + 1, a + n});
                faces.push_back({a + 1, a + n + 1, a + n});
            }
        }
    }
    for (Index i = 0; i + 1 < n; ++i) {
        const Index last = n - 1;
        faces.push_back({i + 1, i, marked.id});
        faces.push_back({last * n + i, last * n + i + 1, marked.id});
        faces.push_back({i * n, (i + 1) * n, marked.id});
        faces.push_back({(i + 1) * n + last, i * n + last, marked.id});
    }
    return {make_surface(faces, std::move(points)), marked};
}

/// The same with the inner points of the plane shaken by up to a quarter cell, and random heights.
inline HeightGrid random_height_grid(Index n, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    return height_grid(n, [&](double x, double y) {
        const bool is_inner = x > 0 && x < 1 && y > 0 && y < 1;
        const double shake = is_inner ? 0.25 / (n - 1) : 0;
        return Point(x + shake * random_coordinate(random), y + shake * random_coordinate(random),
                     0.3 * random_coordinate(random));
    });
}

}  // namespace tightflip::geometry
