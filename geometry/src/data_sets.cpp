#include "face_mesh.hpp"
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/cross_sections.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/star_shaped.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tightflip::geometry {
namespace {

using kernel::RandomStream;

constexpr double pi = std::numbers::pi;
const Point half_axes(3, 2, 1);

void require(bool holds, const char* set, const char* range) {
    if (!holds) throw std::invalid_argument(std::string(set) + " needs " + range);
}

/// Uniform in 0 .. 1, without 1.
double uniform(RandomStream& random) {
    return static_cast<double>(random.bits() >> 11) * 0x1p-53;
}

/// Uniform on the unit sphere; by rejection, so that it takes nothing but a square root.
Point random_direction(RandomStream& random) {
    for (;;) {
        const double x = 2 * uniform(random) - 1;
        const double y = 2 * uniform(random) - 1;
        const Point point(x, y, 2 * uniform(random) - 1);
        const double square = point.squaredNorm();
        if (square <= 1 && square > 0.01) return point / std::sqrt(square);
    }
}

std::vector<Point> random_directions(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    std::vector<Point> points(static_cast<std::size_t>(count));
    for (Point& point : points)
        point = random_direction(random);
    return points;
}

/// Along a spiral from pole to pole, each point a golden angle after the one before.
std::vector<Point> even_directions(Index count) {
    const double golden_angle = pi * (3 - std::sqrt(5.0));
    std::vector<Point> points;
    for (Index i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count;
        const double radius = std::sqrt(1 - z * z);
        points.emplace_back(radius * std::cos(golden_angle * i),
                            radius * std::sin(golden_angle * i), z);
    }
    return points;
}

void scale(std::vector<Point>& points, const Point& factors) {
    for (Point& point : points)
        point = point.cwiseProduct(factors);
}

/// To a multiple of 2^-40, so that shifts of these coordinates are exact.
double rounded(double x) {
    return std::round(x * 0x1p40) * 0x1p-40;
}

/// A regular k-gon at a height, its first corner at the angle `turn`.
void add_polygon(std::vector<Point>& points, Index k, double radius, double height, double turn) {
    for (Index i = 0; i < k; ++i) {
        const double angle = turn + 2 * pi * i / k;
        points.emplace_back(rounded(radius * std::cos(angle)), rounded(radius * std::sin(angle)),
                            height);
    }
}

/// Rings of k labels from 0 on, one above the other: in each quadrilateral between them the
/// diagonal from corner i below to corner i + 1 above, and a fan below and above.
std::vector<Face> ring_faces(Index rings, Index k) {
    std::vector<Face> faces;
    for (Index r = 0; r + 1 < rings; ++r) {
        for (Index i = 0; i < k; ++i) {
            const Index j = (i + 1) % k;
            const Index low = r * k;
            const Index high = low + k;
            faces.push_back({low + i, low + j, high + j});
            faces.push_back({low + i, high + j, high + i});
        }
    }
    const Index top = (rings - 1) * k;
    for (Index i = 1; i + 1 < k; ++i) {
        faces.push_back({0, i + 1, i});
        faces.push_back({top, top + i, top + i + 1});
    }
    return faces;
}

Surface prism(const std::vector<double>& radii, Index k, double turn) {
    std::vector<Point> points;
    for (std::size_t r = 0; r < radii.size(); ++r) {
        const auto height = static_cast<double>(r);
        add_polygon(points, k, radii[r], height, turn * height);
    }
    return surface_of_faces(ring_faces(static_cast<Index>(radii.size()), k), std::move(points));
}

/// Random points of the unit square.
std::vector<Point> random_plane(Index count, RandomStream& random) {
    std::vector<Point> points;
    for (Index i = 0; i < count; ++i) {
        const double x = uniform(random);
        points.emplace_back(x, uniform(random), 0);
    }
    return points;
}

double franke_function(double x, double y) {
    const double u = 9 * x;
    const double v = 9 * y;
    const auto square = [](double t) { return t * t; };
    return 0.75 * std::exp(-(square(u - 2) + square(v - 2)) / 4) +
           0.75 * std::exp(-square(u + 1) / 49 - (v + 1) / 10) +
           0.5 * std::exp(-(square(u - 7) + square(v - 3)) / 4) -
           0.2 * std::exp(-square(u - 4) - square(v - 7));
}

}  // namespace

namespace data_sets {

Surface schoenhardt_prism() {
    return prism({1, 1}, 3, pi / 6);
}

Surface twisted_prism(Index k) {
    require(k >= 3 && k < kernel::max_faces / 6, "twisted-prism", "9, 12, 15, ... vertices");
    return prism({1, 1.25, 1}, k, 0.45 * pi / k);
}

Surface skewed_cylinder(Index k) {
    require(k >= 3 && k < kernel::max_faces / 4, "skewed-cylinder", "6, 8, 10, ... vertices");
    std::vector<Point> points;
    add_polygon(points, k, 1, 0, 0);
    add_polygon(points, k, 1, 1, 0);
    for (std::size_t i = points.size() / 2; i < points.size(); ++i)
        points[i].x() += 2.5;
    return surface_of_faces(ring_faces(2, k), std::move(points));
}

Surface ellipsoid(Index vertices) {
    require(vertices >= 4, "ellipsoid", "at least 4 vertices");
    std::vector<Point> points = even_directions(vertices);
    scale(points, half_axes);
    return convex_surface(std::move(points)).value();
}

Surface random_sphere(Index vertices, std::uint64_t seed) {
    require(vertices >= 4, "random-sphere", "at least 4 vertices");
    return convex_surface(random_directions(vertices, seed)).value();
}

Surface random_ellipsoid(Index vertices, std::uint64_t seed) {
    require(vertices >= 4, "random-ellipsoid", "at least 4 vertices");
    std::vector<Point> points = random_directions(vertices, seed);
    scale(points, half_axes);
    return convex_surface(std::move(points)).value();
}

Surface bumpy_sphere(Index vertices, std::uint64_t seed) {
    require(vertices >= 20, "bumpy-sphere", "at least 20 vertices");
    constexpr int waves = 4;
    constexpr double height = 0.08;
    RandomStream random(seed);
    std::vector<Point> wave_directions;
    std::vector<double> phases;
    for (int k = 0; k < waves; ++k) {
        wave_directions.push_back(random_direction(random));
        phases.push_back(2 * pi * uniform(random));
    }
    std::vector<Point> points = even_directions(vertices);
    for (Point& point : points) {
        double radius = 1;
        for (std::size_t k = 0; k < waves; ++k)
            radius += height * std::sin(6 * point.dot(wave_directions[k]) + phases[k]);
        point *= radius;
    }
    return star_shaped_surface(std::move(points), Point::Zero()).value().surface;
}

Surface bumpy_torus(Index vertices, std::uint64_t seed) {
    constexpr Index tube = 12;
    require(vertices >= 3 * tube && vertices % tube == 0, "bumpy-torus",
            "36, 48, 60, ... vertices");
    const Index sections = vertices / tube;
    RandomStream random(seed);
    const double phase = 2 * pi * uniform(random);
    std::vector<Point> points;
    for (Index i = 0; i < sections; ++i) {
        const double round = 2 * pi * i / sections;
        for (Index j = 0; j < tube; ++j) {
            const double angle = 2 * pi * j / tube;
            const double radius = 0.7 + 0.12 * std::sin(5 * round + phase) * std::cos(3 * angle);
            const double out = 2 + radius * std::cos(angle);
            points.emplace_back(out * std::cos(round), out * std::sin(round),
                                radius * std::sin(angle));
        }
    }
    return {kernel::families::torus_grid(sections, tube), std::move(points)};
}

Surface head_cap(Index vertices) {
    constexpr Index ring = 16;
    require(vertices >= 2 * ring && vertices % ring == 0, "head-cap", "32, 48, 64, ... vertices");
    const Index count = vertices / ring;
    std::vector<Contour> sections;
    for (Index s = 0; s < count; ++s) {
        // Slices of an ellipsoid, ever closer towards the top, which ends just below the pole.
        const double up = 0.95 * (pi / 2) * s / (count - 1.0);
        Contour contour;
        add_polygon(contour, ring, std::cos(up), 1.2 * std::sin(up), 0.1 * s);
        for (Point& point : contour) {
            const double angle = std::atan2(point.y(), point.x());
            const double ears = 0.12 * std::exp(-8 * up) * std::cos(2 * angle);
            const double folds = 0.03 * std::sin(5 * angle + 4 * up);
            const double factor = 1 - ears + folds;
            point.x() *= 1.25 * factor;
            point.y() *= factor;
        }
        sections.push_back(std::move(contour));
    }
    return surface_from_cross_sections(sections).value();
}

Surface cube_grid(Index vertices) {
    Index k = 1;
    while (6 * k * k + 2 < vertices && k < 10000)
        ++k;
    require(vertices == 6 * k * k + 2, "cube-grid", "8, 26, 56, ... (6 k^2 + 2) vertices");
    std::vector<Point> points;
    for (Index x = 0; x <= k; ++x) {
        for (Index y = 0; y <= k; ++y) {
            const bool is_side = x == 0 || x == k || y == 0 || y == k;
            for (Index z = 0; z <= k; z += is_side ? 1 : k)
                points.emplace_back(x, y, z);
        }
    }
    return convex_surface(std::move(points)).value();
}

FunctionalSurface franke(Index vertices, std::uint64_t seed) {
    require(vertices >= 4, "franke", "at least 4 vertices");
    RandomStream random(seed);
    std::vector<Point> points = random_plane(vertices - 1, random);
    for (Point& point : points)
        point.z() = franke_function(point.x(), point.y());
    return functional_surface(std::move(points)).value();
}

FunctionalSurface random_heights(Index vertices, std::uint64_t seed) {
    require(vertices >= 4, "random-heights", "at least 4 vertices");
    RandomStream random(seed);
    std::vector<Point> points = random_plane(vertices - 1, random);
    for (Point& point : points)
        point.z() = uniform(random);
    return functional_surface(std::move(points)).value();
}

}  // namespace data_sets

namespace {

/// The number of corners of each of `rings` polygons.
Index polygon_size(Index vertices, Index rings, const char* set, const char* range) {
    require(vertices % rings == 0, set, range);
    return vertices / rings;
}

constexpr std::array<DataSet, 12> sets{{
    {"schoenhardt-prism", "a twisted triangular prism that no tetrahedra fill (Figure 2)", 6, false,
     [](const DataRequest& r) {
         require(r.vertices == 6, "schoenhardt-prism", "6 vertices");
         return data_sets::schoenhardt_prism();
     }},
    {"twisted-prism", "convex data in a twisted start that is not convex (Figure 14)", 9, false,
     [](const DataRequest& r) {
         return data_sets::twisted_prism(
             polygon_size(r.vertices, 3, "twisted-prism", "9, 12, 15, ... vertices"));
     }},
    {"skewed-cylinder", "two parallel polygons, one moved sideways (Figure 4)", 24, false,
     [](const DataRequest& r) {
         return data_sets::skewed_cylinder(
             polygon_size(r.vertices, 2, "skewed-cylinder", "6, 8, 10, ... vertices"));
     }},
    {"ellipsoid", "the hull of evenly spread points on an ellipsoid", 200, false,
     [](const DataRequest& r) { return data_sets::ellipsoid(r.vertices); }},
    {"random-sphere", "the hull of random points on a sphere", 200, false,
     [](const DataRequest& r) { return data_sets::random_sphere(r.vertices, r.seed); }},
    {"random-ellipsoid", "the hull of random points on an ellipsoid", 200, false,
     [](const DataRequest& r) { return data_sets::random_ellipsoid(r.vertices, r.seed); }},
    {"bumpy-sphere", "a sphere with waves, star-shaped and not convex", 500, false,
     [](const DataRequest& r) { return data_sets::bumpy_sphere(r.vertices, r.seed); }},
    {"bumpy-torus", "a torus with waves", 360, false,
     [](const DataRequest& r) { return data_sets::bumpy_torus(r.vertices, r.seed); }},
    {"head-cap", "a scalp from horizontal slices (for Figure 8)", 320, false,
     [](const DataRequest& r) { return data_sets::head_cap(r.vertices); }},
    {"cube-grid", "the points of a grid on the surface of a cube", 98, false,
     [](const DataRequest& r) { return data_sets::cube_grid(r.vertices); }},
    {"franke", "Franke's function over random points; the last vertex closes it", 101, true,
     [](const DataRequest& r) { return data_sets::franke(r.vertices, r.seed).surface; }},
    {"random-heights", "random heights over random points; the last vertex closes it", 101, true,
     [](const DataRequest& r) { return data_sets::random_heights(r.vertices, r.seed).surface; }},
}};

}  // namespace

std::span<const DataSet> all_data_sets() noexcept {
    return sets;
}

const DataSet* find_data_set(std::string_view name) noexcept {
    const auto* const set = std::ranges::find(sets, name, &DataSet::name);
    return set == sets.end() ? nullptr : set;
}

}  // namespace tightflip::geometry
