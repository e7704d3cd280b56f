#include "criteria.hpp"
#include "face_sum.hpp"
#include <tightflip/geometry/exact_predicates.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace tightflip::geometry {
namespace {

/// The squares of the sides bc, ca, ab of a face, and twice its area.
struct Triangle {
    std::array<double, 3> sides;
    double double_area;

    Triangle(const BoundSurface& surface, const FaceCorners& f) {
        const Point& a = surface.scaled(f.a);
        const Point& b = surface.scaled(f.b);
        const Point& c = surface.scaled(f.c);
        sides = {(c - b).squaredNorm(), (a - c).squaredNorm(), (b - a).squaredNorm()};
        // Two long sides of a needle would lose its width, and each rotation of its corners another
        // part of it.
        const Point& near_c = sides[1] < sides[0] ? a : b;
        double_area = (b - a).cross(c - near_c).norm();
    }
};

struct PlainMeasure {
    static constexpr int dimension = 0;
    static constexpr std::size_t level_count = 1;
    static constexpr bool needs_heights = false;
    void prepare(const BoundSurface& /*surface*/) {}
};

struct Area : PlainMeasure {
    static constexpr int dimension = 2;
    double operator()(const BoundSurface& surface, const FaceCorners& f) const {
        const Point& a = surface.scaled(f.a);
        const Point u = surface.scaled(f.b) - a;
        const Point v = surface.scaled(f.c) - a;
        const double square = u.cross(v).squaredNorm();
        constexpr double sharp = 1e-8;  // the square of a sine
        if (square > sharp * u.squaredNorm() * v.squaredNorm()) return std::sqrt(square) / 2;
        return Triangle(surface, f).double_area / 2;
    }
};

struct MinAngle : PlainMeasure {
    double operator()(const BoundSurface& surface, const FaceCorners& f) const {
        const Triangle t(surface, f);
        const auto& [p, q, r] = t.sides;
        const double shortest = std::min({p, q, r});
        // The angle opposite the shortest side, by the law of cosines.
        const double twice_dot = p + q + r - 2 * shortest;
        return std::numbers::pi / 3 - std::atan2(2 * t.double_area, twice_dot);
    }
};

struct Cotangents : PlainMeasure {
    static constexpr std::size_t level_count = 2;
    Energy operator()(const BoundSurface& surface, const FaceCorners& f) const {
        const Triangle t(surface, f);
        const double sum = t.sides[0] + t.sides[1] + t.sides[2];
        const bool may_be_collinear = t.double_area <= 1e-6 * sum;
        if (may_be_collinear &&
            are_collinear(surface.exact(f.a), surface.exact(f.b), surface.exact(f.c))) {
            return 1;
        }
        Energy energy;
        // Where roundings left no area, it is still not zero.
        energy.levels[1] = sum / std::max(2 * t.double_area, 0x1p-500);
        return energy;
    }
};

/// The energy of the cubic patch over a face that has the heights and gradients of its corners and
/// reproduces quadratic functions: nine control heights from these, the one in the middle the mean
/// of the six around it and half of what that exceeds the mean of the corners by.
struct Bending : PlainMeasure {
    static constexpr bool needs_heights = true;

    /// The means of the gradients of the faces at each vertex, weighted by area.
    void prepare(const BoundSurface& surface) {
        gradients_.assign(surface.view().points.size(), Eigen::Vector2d::Zero());
        std::vector<double> weights(gradients_.size(), 0);
        surface.for_each_face([&](const FaceCorners& f) {
            const Point& a = surface.scaled(f.a);
            const Point normal = (surface.scaled(f.b) - a).cross(surface.scaled(f.c) - a);
            for (const Vertex v : {f.a, f.b, f.c}) {
                gradients_[static_cast<std::size_t>(v.id)] -= normal.head<2>();
                weights[static_cast<std::size_t>(v.id)] += normal.z();
            }
        });
        for (std::size_t v = 0; v < gradients_.size(); ++v) {
            if (weights[v] > 0) gradients_[v] /= weights[v];
        }
    }

    double operator()(const BoundSurface& surface, const FaceCorners& f) const {
        const std::array corners{f.a, f.b, f.c};
        std::array<Eigen::Vector2d, 3> place;
        std::array<double, 3> height{};
        for (std::size_t i = 0; i < 3; ++i) {
            place[i] = surface.scaled(corners[i]).head<2>();
            height[i] = surface.scaled(corners[i]).z();
        }
        // ordinate[i][j]: the control height a third of the way from corner i to corner j.
        std::array<std::array<double, 3>, 3> ordinate{};
        double around = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                if (i == j) continue;
                ordinate[i][j] =
                    height[i] +
                    gradients_[static_cast<std::size_t>(corners[i].id)].dot(place[j] - place[i]) /
                        3;
                around += ordinate[i][j] / 6;
            }
        }
        const double middle = around + (around - (height[0] + height[1] + height[2]) / 3) / 2;
        return energy(place, height, ordinate, middle);
    }

private:
    /// The second derivatives of a cubic patch are linear in the patch. At corner i, along the
    /// sides to the corners j and k, they are six times the second differences of the control net.
    static double energy(const std::array<Eigen::Vector2d, 3>& place,
                         const std::array<double, 3>& height,
                         const std::array<std::array<double, 3>, 3>& ordinate, double middle) {
        std::array<Eigen::Matrix2d, 3> hessian;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t k = (i + 2) % 3;
            Eigen::Matrix2d along;
            along(0, 0) = 6 * (height[i] - 2 * ordinate[i][j] + ordinate[j][i]);
            along(1, 1) = 6 * (height[i] - 2 * ordinate[i][k] + ordinate[k][i]);
            along(0, 1) = along(1, 0) = 6 * (height[i] - ordinate[i][j] - ordinate[i][k] + middle);
            Eigen::Matrix2d sides;
            sides << place[j] - place[i], place[k] - place[i];
            const Eigen::Matrix2d inverse = sides.inverse();
            hessian[i] = inverse.transpose() * along * inverse;
        }
        const double area = ((place[1] - place[0]).x() * (place[2] - place[0]).y() -
                             (place[1] - place[0]).y() * (place[2] - place[0]).x()) /
                            2;
        // The integral of the square of a linear function with values p, q, r at the corners.
        const Eigen::Matrix2d sum = hessian[0] + hessian[1] + hessian[2];
        double squares = sum.squaredNorm();
        for (const Eigen::Matrix2d& h : hessian)
            squares += h.squaredNorm();
        return area / 12 * squares;
    }

    std::vector<Eigen::Vector2d> gradients_;
};

}  // namespace

std::unique_ptr<Criterion> make_face_criterion(CriterionKind kind, const SurfaceView& surface,
                                               Vertex marked) {
    const std::string_view name = info(kind).name;
    switch (kind) {
        case CriterionKind::area:
            return std::make_unique<FaceSum<Area>>(surface, marked, name);
        case CriterionKind::min_angle:
            return std::make_unique<FaceSum<MinAngle>>(surface, marked, name);
        case CriterionKind::delaunay:
            return std::make_unique<FaceSum<Cotangents>>(surface, marked, name);
        case CriterionKind::bending:
            return std::make_unique<FaceSum<Bending>>(surface, marked, name);
        default:
            return nullptr;
    }
}

}  // namespace tightflip::geometry
