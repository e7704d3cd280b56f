/// \file
/// A triangulation with a point at each vertex.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>

namespace tightflip::geometry {

using kernel::Edge;
using kernel::Halfedge;
using kernel::Index;
using kernel::Triangulation;
using kernel::Vertex;

using Point = Eigen::Vector3d;
/// One point a vertex, in the order of labels; nobody's own memory.
using Points = std::span<const Point>;

/// What measures and criteria read: a halfedge table and the points of its vertices. A view; both
/// outlive it. The points are finite.
struct SurfaceView {
    kernel::HalfedgeTable table;
    Points points;

    [[nodiscard]] const Point& point(Vertex v) const noexcept {
        return points[static_cast<std::size_t>(v.id)];
    }
    [[nodiscard]] const Point& origin(Halfedge h) const noexcept {
        return point(at(table, h).origin);
    }
    [[nodiscard]] const Point& target(Halfedge h) const noexcept { return origin(twin(h)); }
    /// The third corner of the face of `h`.
    [[nodiscard]] const Point& opposite(Halfedge h) const noexcept {
        return origin(at(table, at(table, h).next).next);
    }
    [[nodiscard]] Index edge_count() const noexcept { return static_cast<Index>(table.size() / 2); }
};

/// A value: a triangulation and its points. Flips change the first and never the second.
class Surface {
public:
    /// Throws std::invalid_argument where the numbers of points and vertices differ or a coordinate
    /// is not finite, naming the vertex.
    Surface(Triangulation triangulation, std::vector<Point> points);

    [[nodiscard]] const Triangulation& triangulation() const noexcept { return triangulation_; }
    [[nodiscard]] Triangulation& triangulation() noexcept { return triangulation_; }
    [[nodiscard]] Points points() const noexcept { return points_; }
    [[nodiscard]] const Point& point(Vertex v) const {
        return points_.at(static_cast<std::size_t>(v.id));
    }
    [[nodiscard]] SurfaceView view() const noexcept { return {triangulation_.table(), points_}; }

private:
    Triangulation triangulation_;
    std::vector<Point> points_;
};

}  // namespace tightflip::geometry
