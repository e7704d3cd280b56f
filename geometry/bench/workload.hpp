/// \file
/// The surfaces that benchmarks measure.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <cmath>
#include <numeric>
#include <vector>

#include <benchmark/benchmark.h>

namespace tightflip::geometry::bench {

/// A torus with bumps and a little noise, embedded, on a grid of `m` by `n` vertices: vertices of
/// all types.
inline Surface bumpy_torus(Index m, Index n) {
    kernel::RandomStream random(1);
    std::vector<Point> points;
    for (Index i = 0; i < m; ++i) {
        for (Index j = 0; j < n; ++j) {
            const double u = 2 * M_PI * i / m;
            const double v = 2 * M_PI * j / n;
            const double noise = 1e-3 * static_cast<double>(random.below(1000)) / std::sqrt(m * n);
            const double tube = 1 + 0.2 * std::sin(7 * u) * std::sin(5 * v) + noise;
            const double around = 3 + tube * std::cos(v);
            points.emplace_back(around * std::cos(u), around * std::sin(u), tube * std::sin(v));
        }
    }
    return {kernel::families::torus_grid(m, n), std::move(points)};
}

/// The edges that can be flipped, in random order.
inline std::vector<Edge> random_edges(const Triangulation& surface) {
    std::vector<Edge> edges;
    for (Index e = 0; e < surface.edge_count(); ++e) {
        if (surface.can_flip(Edge{e})) edges.push_back(Edge{e});
    }
    kernel::RandomStream random(1);
    random.shuffle(std::span<Edge>(edges));
    return edges;
}

/// Time per item, which the tables show.
inline void report_time_for(benchmark::State& state, double items) {
    state.counters["time"] =
        benchmark::Counter(items * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace tightflip::geometry::bench
