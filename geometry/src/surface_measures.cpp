#include <tightflip/geometry/surface_measures.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

/// Coordinates from the first point on, in units of a power of two in which the extent of the
/// surface is about one, so that no sum on the way overflows or vanishes.
class Frame {
public:
    explicit Frame(Points points) : base_(points.front()) {
        double extent = 0;
        for (const Point& point : points) {
            extent = std::max(extent, (point * 0.5 - base_ * 0.5).cwiseAbs().maxCoeff());
        }
        if (extent > 0) exponent_ = std::clamp(std::ilogb(extent) + 2, -1000, 1000);
        unit_ = std::ldexp(1.0, -exponent_);
    }
    [[nodiscard]] Point local(const Point& point) const { return span(base_, point); }
    /// From one point to another in these units; for near points by fewer roundings than between
    /// their local coordinates.
    [[nodiscard]] Point span(const Point& from, const Point& to) const {
        return to * unit_ - from * unit_;
    }
    /// A measure of the given dimension in the units of the coordinates.
    [[nodiscard]] double global(double value, int dimension) const {
        return std::ldexp(value, dimension * exponent_);
    }

private:
    Point base_;
    int exponent_ = 0;
    double unit_ = 1;
};

void measure_vertices(const SurfaceView& surface, SurfaceMeasures& sums) {
    std::vector<Halfedge> outgoing(surface.points.size());
    for (Index h = 0; h < static_cast<Index>(surface.table.size()); ++h) {
        const Vertex v = at(surface.table, Halfedge{h}).origin;
        outgoing[static_cast<std::size_t>(v.id)] = Halfedge{h};
    }
    StarMeter meter;
    for (const Halfedge h : outgoing) {
        const VertexCurvature curvature = meter.measure(surface, h);
        sums.total_curvature += curvature.deficit();
        sums.total_positive_curvature += curvature.positive;
        sums.total_absolute_curvature += curvature.absolute();
        ++sums.vertex_types.at(static_cast<std::size_t>(curvature.type));
    }
}

void measure_edges(const SurfaceView& surface, const Frame& frame, SurfaceMeasures& sums) {
    for (Index id = 0; id < surface.edge_count(); ++id) {
        const Edge e{id};
        const Hinge hinge = Hinge::at(surface, e);
        const EdgeShape shape = edge_shape(hinge);
        const double mean = exterior_angle(hinge, shape) / 2;
        const double span = frame.span(hinge.a, hinge.b).stableNorm();
        sums.mean_absolute_curvature += std::abs(mean);
        sums.mean_absolute_curvature_weighted += std::abs(mean) * span;
        if (shape != EdgeShape::folded) sums.integral_mean_curvature += mean * span;
        ++sums.edge_shapes.at(static_cast<std::size_t>(shape));
    }
}

/// Of a face, by the shorter of two sides: two long ones of a needle would lose its width.
double area(const Frame& frame, const Point& a, const Point& b, const Point& c) {
    const Point ac = frame.span(a, c);
    const Point bc = frame.span(b, c);
    return frame.span(a, b).cross(ac.squaredNorm() < bc.squaredNorm() ? ac : bc).norm() / 2;
}

void measure_faces(const SurfaceView& surface, const Frame& frame, SurfaceMeasures& sums) {
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        const Halfedge h{id};
        const Halfedge h1 = at(surface.table, h).next;
        const Halfedge h2 = at(surface.table, h1).next;
        if (h1 < h || h2 < h) continue;  // each face once, at its smallest halfedge
        sums.area += area(frame, surface.origin(h), surface.origin(h1), surface.origin(h2));
        const Point b = frame.local(surface.origin(h1));
        const Point c = frame.local(surface.origin(h2));
        sums.volume += frame.local(surface.origin(h)).dot(b.cross(c)) / 6;
    }
}

}  // namespace

SurfaceMeasures measure(const SurfaceView& surface) {
    SurfaceMeasures sums;
    if (surface.points.empty()) return sums;
    sums.euler_characteristic = static_cast<Index>(surface.points.size()) - surface.edge_count() +
                                static_cast<Index>(surface.table.size() / 3);
    const Frame frame(surface.points);
    measure_vertices(surface, sums);
    measure_edges(surface, frame, sums);
    measure_faces(surface, frame, sums);
    sums.mean_absolute_curvature_weighted = frame.global(sums.mean_absolute_curvature_weighted, 1);
    sums.integral_mean_curvature = frame.global(sums.integral_mean_curvature, 1);
    sums.area = frame.global(sums.area, 2);
    sums.volume = frame.global(sums.volume, 3);
    return sums;
}

}  // namespace tightflip::geometry
