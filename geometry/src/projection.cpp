#include "projection.hpp"

#include "surface_face.hpp"
#include <tightflip/kernel/circulation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

/// Points of a bow between its ends; fewer on large surfaces, where bows are small.
constexpr int most_inner_points = 15;
constexpr int least_inner_points = 3;
constexpr Index edges_with_many = 200;
/// How fast depth changes at most where a bow leaves the triangle of its face.
constexpr double steepest = 20;
/// Between neighbouring parallel edges, by the length of their chord; less where they are many.
constexpr double step_of_bows = 0.14;
constexpr double most_of_bows = 0.45;

struct ParallelEdge {
    Vertex smaller;
    Vertex larger;
    double side = 0;  // how far to the left of the chord the faces at this edge lie
    Edge edge;

    [[nodiscard]] auto order() const { return std::tie(smaller, larger, side, edge); }
    [[nodiscard]] bool joins_the_same(const ParallelEdge& other) const {
        return smaller == other.smaller && larger == other.larger;
    }
};

/// The halfedge of an edge that leaves its smaller end.
Halfedge from_smaller(kernel::HalfedgeTable table, Edge e) {
    const Halfedge h = halfedge_of(e);
    return at(table, h).origin < at(table, twin(h)).origin ? h : twin(h);
}

/// A parabola over a chord; its top is a quarter of `rise` away.
struct Bow {
    const Point& a;
    const Point& b;
    Point rise;
};

void append_bow(const Bow& bow, int inner_points, std::vector<Point>& line) {
    for (int i = 1; i <= inner_points; ++i) {
        const double t = static_cast<double>(i) / (inner_points + 1);
        line.push_back(bow.a + t * (bow.b - bow.a) + t * (1 - t) * bow.rise);
    }
}

/// Whether no other corner of the outline lies in the triangle at corner i, which turns the way of
/// the outline.
bool is_ear(const std::vector<Point>& outline, std::size_t i, double turn) {
    const std::size_t n = outline.size();
    const Point& a = outline[(i + n - 1) % n];
    const Point& b = outline[i];
    const Point& c = outline[(i + 1) % n];
    if (turn * seen_area(a, b, c) <= 0) return false;
    return std::ranges::none_of(outline, [&](const Point& p) {
        return turn * seen_area(a, b, p) > 0 && turn * seen_area(b, c, p) > 0 &&
               turn * seen_area(c, a, p) > 0;
    });
}

/// Cuts a polygon into triangles without new corners. One that crosses itself is cut somehow.
template <class Take>
void cut_ears(std::vector<Point>& outline, const Take& take) {
    double area = 0;
    for (std::size_t i = 2; i < outline.size(); ++i)
        area += seen_area(outline[0], outline[i - 1], outline[i]);
    while (outline.size() > 3) {
        std::size_t ear = 0;
        while (ear < outline.size() && !is_ear(outline, ear, area))
            ++ear;
        if (ear == outline.size()) ear = 0;
        const std::size_t n = outline.size();
        take(outline[(ear + n - 1) % n], outline[ear], outline[(ear + 1) % n]);
        outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    take(outline[0], outline[1], outline[2]);
}

std::vector<ParallelEdge> edges_by_ends(const SurfaceView& projected) {
    std::vector<ParallelEdge> edges;
    edges.reserve(static_cast<std::size_t>(projected.edge_count()));
    for (Index id = 0; id < projected.edge_count(); ++id) {
        const Halfedge h = from_smaller(projected.table, Edge{id});
        const Point& a = projected.origin(h);
        const Point& b = projected.target(h);
        edges.push_back(
            {at(projected.table, h).origin, at(projected.table, twin(h)).origin,
             seen_area(a, b, projected.opposite(h)) + seen_area(a, b, projected.opposite(twin(h))),
             Edge{id}});
    }
    std::ranges::sort(edges, [](const auto& a, const auto& b) { return a.order() < b.order(); });
    return edges;
}

}  // namespace

std::vector<Point> project(Points points, double azimuth, double elevation) {
    std::vector<Point> seen(points.begin(), points.end());
    if (seen.empty()) return seen;
    Point least = seen.front();
    Point greatest = seen.front();
    for (const Point& point : points) {
        least = least.cwiseMin(point);
        greatest = greatest.cwiseMax(point);
    }
    const Point middle = least * 0.5 + greatest * 0.5;
    // Halves of very large coordinates have finite differences.
    const double extent = (greatest * 0.5 - least * 0.5).maxCoeff();
    const int exponent = extent > 0 ? std::ilogb(extent) : 0;
    const auto scaled = [exponent](double x) { return std::ldexp(x, 1 - exponent); };
    constexpr double degree = std::numbers::pi / 180;
    const double a = std::remainder(azimuth, 360) * degree;
    const double e = elevation * degree;
    const Point right(-std::sin(a), std::cos(a), 0);
    const Point up(-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e));
    const Point towards(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
    for (Point& point : seen) {
        const Point half = point * 0.5 - middle * 0.5;
        const Point p = half.unaryExpr(scaled);
        point = {right.dot(p), up.dot(p), towards.dot(p)};
    }
    return seen;
}

EdgeLines::EdgeLines(const SurfaceView& projected)
    : projected_(projected),
      inner_points_(projected.edge_count() <= edges_with_many ? most_inner_points
                                                              : least_inner_points),
      bows_(static_cast<std::size_t>(projected.edge_count()), 0.0) {
    const std::vector<ParallelEdge> edges = edges_by_ends(projected);
    for (auto first = edges.begin(); first != edges.end();) {
        const auto last = std::find_if_not(
            first, edges.end(), [&](const ParallelEdge& e) { return e.joins_the_same(*first); });
        const auto gaps = static_cast<double>(last - first - 1);
        const double step = gaps > 0 ? std::min(step_of_bows, most_of_bows / gaps) : 0;
        const double least = -gaps / 2 * step;
        for (int place = 0; first != last; ++first, ++place) {
            bows_[static_cast<std::size_t>(first->edge.id)] = least + place * step;
        }
    }
}

/// Four times the way of the middle of `h`.
Eigen::Vector2d EdgeLines::bow_of(Halfedge h) const {
    const Edge e = edge_of(h);
    const Point chord = projected_.target(h) - projected_.origin(h);
    const double side = h == from_smaller(projected_.table, e) ? 4 : -4;
    return side * bows_[static_cast<std::size_t>(e.id)] * Eigen::Vector2d(-chord.y(), chord.x());
}

/// How depth changes in the plane of the face of `h`; 0 where the face has no plane.
Eigen::Vector2d EdgeLines::slope(Halfedge h) const {
    const Point& a = projected_.origin(h);
    const Point normal = (projected_.target(h) - a).cross(projected_.opposite(h) - a);
    const double height = std::max(std::abs(normal.z()), normal.head<2>().norm() / steepest);
    if (height == 0) return Eigen::Vector2d::Zero();
    return -normal.head<2>() / std::copysign(height, normal.z());
}

void EdgeLines::trace(Edge e, std::vector<Point>& line) const {
    const Halfedge h = halfedge_of(e);
    const Point& a = projected_.origin(h);
    const Point& b = projected_.target(h);
    line.assign(1, a);
    if (is_bowed(e)) {
        const Eigen::Vector2d bow = bow_of(h);
        const double rise = std::max(bow.dot(slope(h)), bow.dot(slope(twin(h))));
        append_bow({a, b, {bow.x(), bow.y(), rise}}, inner_points_, line);
    }
    line.push_back(b);
}

void EdgeLines::outline(Halfedge h, std::vector<Point>& corners) const {
    corners.clear();
    const Eigen::Vector2d rise = slope(h);
    for (const Halfedge side : kernel::FaceSides(projected_.table, h)) {
        const Point& a = projected_.origin(side);
        corners.push_back(a);
        if (!is_bowed(edge_of(side))) continue;
        const Eigen::Vector2d bow = bow_of(side);
        append_bow({a, projected_.target(side), {bow.x(), bow.y(), bow.dot(rise)}}, inner_points_,
                   corners);
    }
}

std::vector<Piece> face_pieces(const SurfaceView& projected, const EdgeLines& lines) {
    std::vector<Piece> pieces;
    std::vector<Point> outline;
    for (Index id = 0; id < static_cast<Index>(projected.table.size()); ++id) {
        const Halfedge h{id};
        if (name_of_face(projected.table, h) != h) continue;
        lines.outline(h, outline);
        const Point& a = projected.origin(h);
        const Point& b = projected.target(h);
        const Point& c = projected.opposite(h);
        const bool is_front = seen_area(a, b, c) > 0;
        cut_ears(outline, [&](const Point& p, const Point& q, const Point& r) {
            pieces.push_back({{p, q, r}, id, is_front});
        });
    }
    return pieces;
}

}  // namespace tightflip::geometry
