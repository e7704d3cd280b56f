#include "face_mesh.hpp"
#include <tightflip/geometry/functional_surface.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tightflip::geometry {
namespace {

/// Below the middle of the points by more than twice their extent, within the range of doubles.
Point far_below(Points points) {
    Point low = points.front();
    Point high = low;
    for (const Point& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    constexpr double largest = std::numeric_limits<double>::max();
    const double extent = (high - low).maxCoeff();
    const double depth = 2 * std::max(extent, std::abs(low.z()) * 0x1p-40);
    Point below = low * 0.5 + high * 0.5;
    below.z() = std::max(-largest, low.z() - depth);
    return below;
}

}  // namespace

Outcome<FunctionalSurface> functional_surface(std::vector<Point> points) {
    Outcome<PlaneTriangulation> plane = delaunay_in_plane(points);
    if (!plane) return plane.refusal();
    auto [faces, boundary] = std::move(plane).value();
    const Vertex marked{static_cast<Index>(points.size())};
    Index before = boundary.back();
    for (const Index v : boundary) {
        faces.push_back({v, before, marked.id});
        before = v;
    }
    points.push_back(far_below(points));
    return FunctionalSurface{surface_of_faces(faces, std::move(points)), marked};
}

}  // namespace tightflip::geometry
