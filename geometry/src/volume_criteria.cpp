#include "criteria.hpp"
#include "height_field.hpp"
#include <tightflip/geometry/exact_predicates.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

double determinant(const Point& u, const Point& v, const Point& w) {
    return u.cross(v).dot(w);
}

/// Minus the volume that the faces enclose.
struct EnclosedVolume {
    static constexpr int dimension = 3;
    static constexpr bool needs_heights = false;

    static double of_face(const Point& base, const Point& a, const Point& b, const Point& c) {
        return -determinant(a - base, b - base, c - base) / 6;
    }
    /// A flip adds the tetrahedron above a concave edge and cuts off the one below a convex edge.
    static Sign sign_of_change(const Hinge& h) { return -orientation(h.a, h.b, h.c, h.d); }
    static double size_of_change(const Hinge& h) {
        return determinant(h.b - h.a, h.c - h.a, h.d - h.a) / 6;
    }
};

/// The volume under the faces lifted to the paraboloid over the plane.
struct LiftedVolume {
    static constexpr int dimension = 4;
    static constexpr bool needs_heights = true;

    static Point lifted(const Point& base, const Point& p) {
        const Eigen::Vector2d q = p.head<2>() - base.head<2>();
        return {q.x(), q.y(), q.squaredNorm()};
    }
    static double of_face(const Point& base, const Point& a, const Point& b, const Point& c) {
        const Point p = lifted(base, a);
        const Point u = lifted(base, b) - p;
        const Point v = lifted(base, c) - p;
        return (u.x() * v.y() - u.y() * v.x()) / 2 * (p.z() + (u.z() + v.z()) / 3);
    }
    static Sign sign_of_change(const Hinge& h) { return -in_circle_in_plane(h.a, h.b, h.c, h.d); }
    static double size_of_change(const Hinge& h) {
        return determinant(lifted(h.a, h.b), lifted(h.a, h.c), lifted(h.a, h.d)) / 6;
    }
};

/// A volume under or within the surface; a flip changes it by a tetrahedron.
template <class Volume>
class VolumeCriterion final : public Criterion {
public:
    VolumeCriterion(const SurfaceView& surface, Vertex marked, std::string_view name)
        : surface_(surface, marked) {
        if constexpr (Volume::needs_heights) require_height_field(surface_, name);
    }

    [[nodiscard]] bool has_exact_sign() const override { return true; }

    [[nodiscard]] Energy value() const override {
        double sum = 0;
        if (surface_.view().points.empty()) return sum;
        const Point& base = surface_.scaled(Vertex{0});
        surface_.for_each_face([&](const FaceCorners& f) {
            sum += Volume::of_face(base, surface_.scaled(f.a), surface_.scaled(f.b),
                                   surface_.scaled(f.c));
        });
        return surface_.in_units(sum, Volume::dimension);
    }

    [[nodiscard]] Energy change(Edge e) override {
        const HingeCorners corners = HingeCorners::at(surface_.table(), e);
        if (!surface_.counts(corners)) return Energy::forbidden();
        if constexpr (Volume::needs_heights) {
            if (!flip_keeps_plane(surface_, corners)) return Energy::forbidden();
        }
        const Sign sign = Volume::sign_of_change(surface_.exact(corners));
        if (sign == Sign::zero) return 0.0;
        const double size = surface_.in_units(
            std::abs(Volume::size_of_change(surface_.scaled(corners))), Volume::dimension);
        // Where roundings left nothing of the size, the sign still stands.
        return std::copysign(std::clamp(size, std::numeric_limits<double>::min(),
                                        std::numeric_limits<double>::max()),
                             static_cast<double>(sign));
    }

    void flipped(Edge /*e*/) override {}

    void append_affected(Edge e, std::vector<Edge>& edges) const override {
        append_edges_of_faces(surface_.table(), e, edges);
    }

private:
    BoundSurface surface_;
};

}  // namespace

std::unique_ptr<Criterion> make_volume_criterion(CriterionKind kind, const SurfaceView& surface,
                                                 Vertex marked) {
    const std::string_view name = info(kind).name;
    switch (kind) {
        case CriterionKind::volume:
            return std::make_unique<VolumeCriterion<EnclosedVolume>>(surface, marked, name);
        case CriterionKind::delaunay_plane:
            return std::make_unique<VolumeCriterion<LiftedVolume>>(surface, marked, name);
        default:
            return nullptr;
    }
}

}  // namespace tightflip::geometry
