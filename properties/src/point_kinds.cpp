#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/point_kinds.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tightflip::properties {
namespace {

using geometry::Point;
using kernel::RandomStream;
using Points = std::vector<Point>;

/// Uniform in -1 .. 1.
double uniform(RandomStream& random) {
    return static_cast<double>(random.bits() >> 11) * 0x1p-52 - 1;
}

/// Uniform in least .. most.
int between(RandomStream& random, int least, int most) {
    return least + static_cast<int>(random.below(static_cast<std::uint32_t>(most - least + 1)));
}

Point general_point(RandomStream& random) {
    Point point;
    for (double& coordinate : point)
        coordinate = uniform(random);
    return point;
}

Point grid_point(RandomStream& random, int size) {
    Point point;
    for (double& coordinate : point)
        coordinate = between(random, -size, size);
    return point;
}

/// A grid point other than the origin.
Point grid_direction(RandomStream& random, int size) {
    for (;;) {
        Point point = grid_point(random, size);
        if (!point.isZero(0)) return point;
    }
}

/// An ulp or two up or down, or none; zero stays.
void nudge(Point& point, RandomStream& random) {
    for (double& coordinate : point)
        coordinate += between(random, -2, 2) * 0x1p-52 * coordinate;
}

template <class Draw>
Points drawn(Index count, Draw&& draw) {
    Points points(static_cast<std::size_t>(count));
    for (Point& point : points)
        point = draw();
    return points;
}

Points general(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    return drawn(count, [&] { return general_point(random); });
}

Points grid(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const int size = between(random, 1, 4);
    return drawn(count, [&] { return grid_point(random, size); });
}

Points coincident(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const Points places = general(between(random, 1, 4), random.bits());
    const auto choices = static_cast<std::uint32_t>(places.size());
    return drawn(count, [&] { return places[random.below(choices)]; });
}

Points collinear(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const Point start = grid_point(random, 4);
    const Point along = grid_direction(random, 4);
    return drawn(count, [&] { return Point(start + between(random, -9, 9) * along); });
}

Points near_collinear(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const Point start = general_point(random);
    const Point along = general_point(random);
    return drawn(count, [&] {
        Point point = start + uniform(random) * along;
        nudge(point, random);
        return point;
    });
}

/// Two directions across each other.
std::array<Point, 2> grid_plane(RandomStream& random) {
    for (;;) {
        std::array<Point, 2> plane{grid_direction(random, 3), grid_direction(random, 3)};
        if (std::abs(plane[0].dot(plane[1])) < plane[0].norm() * plane[1].norm()) return plane;
    }
}

Points coplanar(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const std::array<Point, 2> plane = grid_plane(random);
    return drawn(count, [&] {
        const int along = between(random, -4, 4);
        return Point(along * plane[0] + between(random, -4, 4) * plane[1]);
    });
}

Points near_coplanar(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const std::array<Point, 2> plane{general_point(random), general_point(random)};
    return drawn(count, [&] {
        const double along = uniform(random);
        Point point = along * plane[0] + uniform(random) * plane[1];
        nudge(point, random);
        return point;
    });
}

Points near_grid(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const int size = between(random, 1, 4);
    return drawn(count, [&] {
        Point point = grid_point(random, size) + Point::Constant(size + 1);  // none is zero
        nudge(point, random);
        return point;
    });
}

Points sphere(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    return drawn(count, [&] {
        for (;;) {  // by rejection, so that it takes nothing but a square root
            const Point point = general_point(random);
            const double square =
                point.x() * point.x() + point.y() * point.y() + point.z() * point.z();
            if (square <= 1 && square > 0.01) return Point(point / std::sqrt(square));
        }
    });
}

Points cospherical(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    // Of 30 lattice points, (3, 0, 0) and (2, 2, 1) among them, or 102; many on common circles.
    const int radius = random.below(2) == 0 ? 3 : 9;
    Points lattice;
    for (int x = -radius; x <= radius; ++x) {
        for (int y = -radius; y <= radius; ++y) {
            for (int z = -radius; z <= radius; ++z) {
                if (x * x + y * y + z * z == radius * radius) lattice.emplace_back(x, y, z);
            }
        }
    }
    const auto choices = static_cast<std::uint32_t>(lattice.size());
    return drawn(count, [&] { return lattice[random.below(choices)]; });
}

Points far(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const Point centre = std::ldexp(1.0, between(random, 20, 50)) * grid_direction(random, 1);
    return drawn(count, [&] { return Point(centre + general_point(random)); });
}

Points needles(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    Point stretch(1, 1, 1);
    stretch[between(random, 0, 2)] = std::ldexp(1.0, between(random, 10, 60));
    return drawn(count, [&] { return Point(stretch.cwiseProduct(general_point(random))); });
}

/// General points in units of 2^exponent, that between `least` and `most`.
template <int least, int most>
Points scaled(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    const int exponent = between(random, least, most);
    return drawn(count, [&] {
        Point point = general_point(random);
        for (double& coordinate : point)
            coordinate = std::ldexp(coordinate, exponent);
        return point;
    });
}

Points subnormal(Index count, std::uint64_t seed) {
    Points points = grid(count, seed);
    for (Point& point : points)
        point *= std::numeric_limits<double>::denorm_min();
    return points;
}

Points scales(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    return drawn(count, [&] {
        const double size = std::ldexp(1.0, between(random, -30, 30));
        return Point(size * general_point(random));
    });
}

Points wild(Index count, std::uint64_t seed) {
    RandomStream random(seed);
    return drawn(count, [&] {
        Point point = general_point(random);
        for (double& coordinate : point) {
            coordinate =
                random.below(8) == 0 ? 0 : std::ldexp(coordinate, between(random, -1074, 1023));
        }
        return point;
    });
}

constexpr std::array kinds{
    PointKind{"general", "uniform in the cube from -1 to 1", general},
    PointKind{"grid", "integers from -k to k, k = 1 to 4", grid},
    PointKind{"coincident", "at most four places, at times one", coincident},
    PointKind{"collinear", "on one line, exactly", collinear},
    PointKind{"near-collinear", "beside a line by an ulp or so", near_collinear},
    PointKind{"coplanar", "in one plane, exactly, on a small grid in it", coplanar},
    PointKind{"near-coplanar", "beside a plane by an ulp or so", near_coplanar},
    PointKind{"near-grid", "beside a grid by an ulp or so", near_grid},
    PointKind{"sphere", "on the unit sphere, rounded", sphere},
    PointKind{"cospherical", "lattice points on the sphere of radius 3 or 9, exactly", cospherical},
    PointKind{"far", "general points 2^20 to 2^50 from the origin", far},
    PointKind{"needles", "general points stretched 2^10 to 2^60 times in one direction", needles},
    PointKind{"huge", "general points times 2^500 to 2^1023", scaled<500, 1023>},
    PointKind{"tiny", "general points times 2^-500 to 2^-1070", scaled<-1070, -500>},
    PointKind{"subnormal", "a grid in multiples of the least double", subnormal},
    PointKind{"scales", "each point with a magnitude of its own, 2^-30 to 2^30", scales},
    PointKind{"wild", "each coordinate with a magnitude of its own, 2^-1074 to 2^1023, or zero",
              wild},
};

}  // namespace

std::span<const PointKind> point_kinds() noexcept {
    return kinds;
}

const PointKind* find_point_kind(std::string_view name) noexcept {
    const auto* const kind = std::ranges::find(kinds, name, &PointKind::name);
    return kind == kinds.end() ? nullptr : kind;
}

}  // namespace tightflip::properties
