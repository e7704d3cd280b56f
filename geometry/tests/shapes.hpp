/// \file
/// Surfaces with points for tests: regular solids, random positions, and moving them about.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

namespace tightflip::geometry {

using Faces = std::vector<std::array<Index, 3>>;

inline Surface make_surface(const Faces& faces, std::vector<Point> points) {
    return {kernel::build(faces, static_cast<Index>(points.size())).value(), std::move(points)};
}

/// Uniform in -1 .. 1.
inline double random_coordinate(kernel::RandomStream& random) {
    return static_cast<double>(random.bits() >> 11) * 0x1p-52 - 1;
}

inline Point random_point(kernel::RandomStream& random) {
    const double x = random_coordinate(random);
    const double y = random_coordinate(random);
    return {x, y, random_coordinate(random)};
}

inline std::vector<Point> random_points(std::size_t count, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    std::vector<Point> points;
    while (points.size() < count)
        points.push_back(random_point(random));
    return points;
}

/// Uniform among the integers -bound .. bound, in each coordinate.
inline Point random_grid_point(kernel::RandomStream& random, std::uint32_t bound) {
    Point point;
    for (double& x : point)
        x = static_cast<double>(random.below(2 * bound + 1)) - bound;
    return point;
}

inline Surface with_random_points(Triangulation triangulation, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    std::vector<Point> points(static_cast<std::size_t>(triangulation.vertex_count()));
    for (Point& point : points)
        point = random_point(random);
    return {std::move(triangulation), std::move(points)};
}

/// Points of a small grid: many coincide, or lie on common lines and planes.
inline Surface with_grid_points(Triangulation triangulation, std::uint64_t seed,
                                std::uint32_t bound) {
    kernel::RandomStream random(seed);
    std::vector<Point> points(static_cast<std::size_t>(triangulation.vertex_count()));
    for (Point& point : points)
        point = random_grid_point(random, bound);
    return {std::move(triangulation), std::move(points)};
}

/// One surface of each family, of sizes for quick tests.
inline std::vector<Triangulation> all_families() {
    namespace families = kernel::families;
    return {families::tetrahedron(),
            families::book(3),
            families::book(12),
            families::double_wheel(15),
            families::stacked(40, 1),
            families::prism(7),
            families::antiprism(6),
            families::octasphere(2),
            families::icosphere(1),
            families::torus_grid(5, 6),
            families::surface_of_genus(2, 30, 5),
            families::surface_of_genus(1, 3, 5),
            families::random(30, 0, 2),
            families::random(25, 1, 3),
            families::random(20, 3, 4)};
}

/// Counter-clockwise seen from outside; edge length sqrt(8).
inline Surface regular_tetrahedron() {
    return make_surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                        {{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}});
}

/// The cube of edge 2 about the origin; vertex 4z + 2y + x, each face cut by one diagonal.
inline Surface cube() {
    std::vector<Point> points;
    for (Index v = 0; v < 8; ++v) {
        points.emplace_back(2 * (v & 1) - 1, (v & 2) - 1, (v & 4) / 2 - 1);
    }
    const std::array<std::array<Index, 4>, 6> squares{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    Faces faces;
    for (const auto& [a, b, c, d] : squares) {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
    }
    return make_surface(faces, std::move(points));
}

/// The octahedron with vertices at distance 1 on the axes.
inline Surface octahedron() {
    Faces faces;
    for (Index i = 0; i < 8; ++i) {  // x of sign i & 1, y of sign i & 2, z of sign i & 4
        const Index x = i & 1;
        const Index y = 2 + (i >> 1 & 1);
        const Index z = 4 + (i >> 2);
        const bool is_positive = ((i ^ i >> 1 ^ i >> 2) & 1) != 0;
        faces.push_back(is_positive ? std::array{x, y, z} : std::array{y, x, z});
    }
    return make_surface(faces,
                        {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}});
}

/// The regular icosahedron of edge 2: a face joins any three vertices at that distance.
inline Surface icosahedron() {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<Point> points;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double one : {-1.0, 1.0}) {
            for (const double phi : {-golden, golden}) {
                Point point = Point::Zero();
                point[axis] = one;
                point[(axis + 1) % 3] = phi;
                points.push_back(point);
            }
        }
    }
    const auto adjacent = [&](std::size_t a, std::size_t b) {
        return std::abs((points[a] - points[b]).norm() - 2) < 1e-9;
    };
    Faces faces;
    for (std::size_t a = 0; a < 12; ++a) {
        for (std::size_t b = a + 1; b < 12; ++b) {
            for (std::size_t c = b + 1; c < 12; ++c) {
                if (!adjacent(a, b) || !adjacent(b, c) || !adjacent(a, c)) continue;
                const bool is_outward = points[a].dot(points[b].cross(points[c])) > 0;
                faces.push_back({static_cast<Index>(a), static_cast<Index>(is_outward ? b : c),
                                 static_cast<Index>(is_outward ? c : b)});
            }
        }
    }
    return make_surface(faces, std::move(points));
}

inline Surface moved(const Surface& surface, const Eigen::Affine3d& motion) {
    std::vector<Point> points(surface.points().begin(), surface.points().end());
    for (Point& point : points)
        point = motion * point;
    return {surface.triangulation(), std::move(points)};
}

/// Each vertex v under the label order[v].
inline Surface relabelled(const Surface& surface, const std::vector<Index>& order) {
    const kernel::HalfedgeTable table = surface.triangulation().table();
    std::vector<kernel::HalfedgeRecord> records(table.begin(), table.end());
    for (auto& record : records) {
        record.origin.id = order[static_cast<std::size_t>(record.origin.id)];
    }
    std::vector<Point> points(order.size());
    for (std::size_t v = 0; v < order.size(); ++v) {
        points[static_cast<std::size_t>(order[v])] = surface.points()[v];
    }
    const auto count = static_cast<Index>(points.size());
    return {kernel::build(std::move(records), count).value(), std::move(points)};
}

/// The edge between two vertices; -1 where there is none.
inline Edge edge_between(const Surface& surface, Index a, Index b) {
    const Triangulation& t = surface.triangulation();
    for (Index h = 0; h < t.halfedge_count(); ++h) {
        if (t.origin(Halfedge{h}).id == a && t.target(Halfedge{h}).id == b) {
            return kernel::edge_of(Halfedge{h});
        }
    }
    return {};
}

}  // namespace tightflip::geometry
