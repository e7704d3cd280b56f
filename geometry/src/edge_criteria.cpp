#include "angle_sum.hpp"
#include "criteria.hpp"
#include "height_field.hpp"
#include <tightflip/geometry/curvature.hpp>

#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

/// The angle between normals as the sine and cosine it is made of, up to a common factor; not
/// where a face is so thin that roundings would matter.
struct NormalTurn {
    double length;  ///< of the edge
    double sine;
    double cosine;
    bool is_reliable;

    explicit NormalTurn(const Hinge& h) {
        const Point u = h.b - h.a;
        const Point p = h.c - h.a;
        const Point q = h.d - h.a;
        const Point first = u.cross(p);
        const Point second = q.cross(u);
        constexpr double thin = 1e-8;  // the square of a sine
        const double u2 = u.squaredNorm();
        length = std::sqrt(u2);
        // The cross product of the normals is u times the determinant of u, p and q.
        sine = length * std::abs(first.dot(q));
        cosine = first.dot(second);
        is_reliable = first.squaredNorm() > thin * u2 * p.squaredNorm() &&
                      second.squaredNorm() > thin * u2 * q.squaredNorm();
    }
};

/// 0 .. pi.
double angle_between_normals(const BoundSurface& surface, const HingeCorners& h,
                             const NormalTurn& turn) {
    if (turn.is_reliable) return std::atan2(turn.sine, turn.cosine);
    return std::abs(exterior_angle(surface.exact(h)));
}

double angle_between_normals(const BoundSurface& surface, const HingeCorners& h) {
    return angle_between_normals(surface, h, NormalTurn(surface.scaled(h)));
}

double length_of(const BoundSurface& surface, const HingeCorners& h) {
    return (surface.scaled(h.b) - surface.scaled(h.a)).norm();
}

/// A measure of one edge, added up until that reaches a limit.
struct PlainSum {
    static constexpr int dimension = 0;
    static constexpr bool needs_heights = false;
    template <class Measure>
    static double sum(const Measure& measure, const BoundSurface& surface,
                      std::span<const HingeCorners> hinges, double limit) {
        double total = 0;
        for (const HingeCorners& h : hinges) {
            if (surface.counts(h)) total += measure(surface, h);
            if (total >= limit) break;
        }
        return total;
    }
};

/// The angles between normals, each times a factor: one arc tangent for all.
template <int halves>
struct AngleBetweenNormals : PlainSum {
    double operator()(const BoundSurface& surface, const HingeCorners& h) const {
        return angle_between_normals(surface, h) * halves / 2;
    }
    static double sum(const AngleBetweenNormals& measure, const BoundSurface& surface,
                      std::span<const HingeCorners> hinges, double limit) {
        AngleSum angles;
        for (const HingeCorners& h : hinges) {
            if (!surface.counts(h)) continue;
            const NormalTurn turn(surface.scaled(h));
            if (!turn.is_reliable) return PlainSum::sum(measure, surface, hinges, limit);
            angles.add(turn.sine, turn.cosine);
        }
        if (!angles.is_reliable()) return PlainSum::sum(measure, surface, hinges, limit);
        return angles.total() * halves / 2;
    }
};

struct WeightedMean : PlainSum {
    static constexpr int dimension = 1;
    double operator()(const BoundSurface& surface, const HingeCorners& h) const {
        const NormalTurn turn(surface.scaled(h));
        return angle_between_normals(surface, h, turn) / 2 * turn.length;
    }
};

struct SquaredAngle : PlainSum {
    double operator()(const BoundSurface& surface, const HingeCorners& h) const {
        const double angle = angle_between_normals(surface, h);
        return angle * angle;
    }
};

struct Length : PlainSum {
    static constexpr int dimension = 1;
    double operator()(const BoundSurface& surface, const HingeCorners& h) const {
        return length_of(surface, h);
    }
};

/// The jump of the slope across the edge's projection: with the height of d over the plane of abc,
/// divided by its distance from the line ab.
struct SlopeJump : PlainSum {
    static constexpr bool needs_heights = true;
    double operator()(const BoundSurface& surface, const HingeCorners& corners) const {
        const Hinge h = surface.scaled(corners);
        const Point u = h.b - h.a;
        const Point p = h.c - h.a;
        const Point q = h.d - h.a;
        const double left = u.x() * p.y() - u.y() * p.x();
        const double right = u.x() * q.y() - u.y() * q.x();
        // In this order no product is much smaller than what it is divided by.
        return std::abs(u.cross(p).dot(q) / left) * std::abs(u.head<2>().norm() / right);
    }
};

/// Keeps the measure of each edge, so that what a flip takes away need not be computed.
template <class Measure>
class EdgeSum final : public Criterion {
public:
    EdgeSum(const SurfaceView& surface, Vertex marked, std::string_view name)
        : surface_(surface, marked), kept_(static_cast<std::size_t>(surface.edge_count())) {
        if constexpr (Measure::needs_heights) require_height_field(surface_, name);
        for (Index e = 0; e < surface.edge_count(); ++e)
            keep(Edge{e}, HingeCorners::at(surface.table, Edge{e}));
    }

    [[nodiscard]] Energy value() const override {
        double sum = 0;
        for (Index e = 0; e < surface_.edge_count(); ++e) {
            const HingeCorners hinge = HingeCorners::at(surface_.table(), Edge{e});
            if (surface_.counts(hinge)) sum += measure_(surface_, hinge);
        }
        return in_units(sum);
    }

    [[nodiscard]] Energy change(Edge e) override {
        return change_up_to(e, std::numeric_limits<double>::infinity());
    }
    [[nodiscard]] Energy improvement(Edge e) override { return change_up_to(e, 0); }

    void flipped(Edge e) override {
        const auto now = AffectedEdges::before_flip(surface_.table(), e);
        for (std::size_t i = 0; i < now.edges().size(); ++i)
            keep(now.edges()[i], now.hinges()[i]);
    }

    void append_affected(Edge e, std::vector<Edge>& edges) const override {
        append_edges_of_faces_beside(surface_.table(), e, edges);
    }

private:
    /// The change or, where it is not below a limit, what is enough to say so: no measure is below
    /// zero.
    [[nodiscard]] Energy change_up_to(Edge e, double limit) const {
        const auto after = AffectedEdges::after_flip(surface_.table(), e);
        const HingeCorners& middle = after.hinges().front();
        if (!surface_.counts(middle)) return Energy::forbidden();
        if constexpr (Measure::needs_heights) {
            if (!flip_keeps_plane(surface_, HingeCorners::at(surface_.table(), e))) {
                return Energy::forbidden();
            }
        }
        double before = 0;
        for (const Edge edge : after.edges())
            before += kept_[static_cast<std::size_t>(edge.id)];
        return in_units(Measure::sum(measure_, surface_, after.hinges(), before + limit) - before);
    }

    void keep(Edge e, const HingeCorners& hinge) {
        kept_[static_cast<std::size_t>(e.id)] =
            surface_.counts(hinge) ? measure_(surface_, hinge) : 0;
    }
    [[nodiscard]] double in_units(double value) const {
        return surface_.in_units(value, Measure::dimension);
    }

    BoundSurface surface_;
    Measure measure_;
    std::vector<double> kept_;
};

}  // namespace

std::unique_ptr<Criterion> make_edge_criterion(CriterionKind kind, const SurfaceView& surface,
                                               Vertex marked) {
    const std::string_view name = info(kind).name;
    switch (kind) {
        case CriterionKind::mean:
            return std::make_unique<EdgeSum<AngleBetweenNormals<1>>>(surface, marked, name);
        case CriterionKind::abn:
            return std::make_unique<EdgeSum<AngleBetweenNormals<2>>>(surface, marked, name);
        case CriterionKind::mean_weighted:
            return std::make_unique<EdgeSum<WeightedMean>>(surface, marked, name);
        case CriterionKind::abn_squares:
            return std::make_unique<EdgeSum<SquaredAngle>>(surface, marked, name);
        case CriterionKind::edge_length:
            return std::make_unique<EdgeSum<Length>>(surface, marked, name);
        case CriterionKind::jnd:
            return std::make_unique<EdgeSum<SlopeJump>>(surface, marked, name);
        default:
            return nullptr;
    }
}

}  // namespace tightflip::geometry
