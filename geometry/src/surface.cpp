#include <tightflip/geometry/surface.hpp>

#include <stdexcept>
#include <string>

namespace tightflip::geometry {

Surface::Surface(Triangulation triangulation, std::vector<Point> points)
    : triangulation_(std::move(triangulation)), points_(std::move(points)) {
    if (points_.size() != static_cast<std::size_t>(triangulation_.vertex_count())) {
        throw std::invalid_argument(std::to_string(points_.size()) + " points for " +
                                    std::to_string(triangulation_.vertex_count()) + " vertices");
    }
    for (std::size_t v = 0; v < points_.size(); ++v) {
        if (!points_[v].allFinite()) {
            throw std::invalid_argument("vertex " + std::to_string(v) +
                                        " has a coordinate that is not finite");
        }
    }
}

}  // namespace tightflip::geometry
