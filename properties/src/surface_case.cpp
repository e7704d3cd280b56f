#include <tightflip/properties/surface_case.hpp>

#include <limits>
#include <sstream>
#include <utility>

namespace tightflip::properties {

geometry::Surface SurfaceCase::start() const {
    Triangulation triangulation = flips.start();
    const Index count = triangulation.vertex_count();
    std::vector<geometry::Point> placed =
        points.empty() ? point_kind->make(count, point_seed) : points;
    placed.resize(static_cast<std::size_t>(count), geometry::Point::Zero());
    return {std::move(triangulation), std::move(placed)};
}

std::string describe(const SurfaceCase& surface_case) {
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    out << describe(surface_case.flips) << "; points ";
    if (surface_case.points.empty()) {
        out << surface_case.point_kind->name << ", seed " << surface_case.point_seed;
        return out.str();
    }
    const geometry::Surface start = surface_case.start();
    const char* separator = "";
    for (const geometry::Point& point : start.points()) {
        out << separator << point.x() << ' ' << point.y() << ' ' << point.z();
        separator = ", ";
    }
    return out.str();
}

}  // namespace tightflip::properties
