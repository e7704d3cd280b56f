#include <tightflip/properties/surface_case.hpp>

#include <vector>

namespace tightflip::properties {
namespace {

double draw(kernel::RandomStream& random, std::uint32_t grid) {
    if (grid == 0) return static_cast<double>(random.bits() >> 11) * 0x1p-52 - 1;
    return static_cast<double>(random.below(2 * grid + 1)) - grid;
}

}  // namespace

geometry::Surface SurfaceCase::start() const {
    Triangulation triangulation = flips.start();
    kernel::RandomStream random(point_seed);
    std::vector<geometry::Point> points(static_cast<std::size_t>(triangulation.vertex_count()));
    for (geometry::Point& point : points) {
        for (double& coordinate : point)
            coordinate = draw(random, grid);
    }
    return {std::move(triangulation), std::move(points)};
}

std::string describe(const SurfaceCase& surface_case) {
    const std::string points = surface_case.grid == 0
                                   ? "points in general position"
                                   : "points of integers to " + std::to_string(surface_case.grid);
    return describe(surface_case.flips) + "; " + points + ", seed " +
           std::to_string(surface_case.point_seed);
}

}  // namespace tightflip::properties
