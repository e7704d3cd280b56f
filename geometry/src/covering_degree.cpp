#include "surface_face.hpp"
#include <tightflip/geometry/covering_degree.hpp>
#include <tightflip/geometry/exact_predicates.hpp>

namespace tightflip::geometry {
namespace {

/// Of the direction (1, t, t^2), infinitely small t, and the normal of the triangle abx, the sign
/// of the scalar product: that of the normal's first component, or the second where the first is
/// zero, or the third. Zero for points on a line only.
Sign turn_about_ray(const Point& a, const Point& b, const Point& x) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto across = [axis](const Point& p) {
            return Point(p[(axis + 1) % 3], p[(axis + 2) % 3], 0);
        };
        const Sign sign = orientation_in_plane(across(a), across(b), across(x));
        if (sign != Sign::zero) return sign;
    }
    return Sign::zero;
}

/// 1 where the ray from x leaves through the face's outer side, -1 where it comes in, 0 where it
/// misses the face. Precondition: x does not lie on the face.
int crossing(const Triangle& face, const Point& x) {
    const auto& [a, b, c] = face;
    const Sign turn = turn_about_ray(a, b, x);
    // Zero is a point on the line of a side and not on the side: the line of the ray misses the
    // face.
    if (turn == Sign::zero || turn_about_ray(b, c, x) != turn || turn_about_ray(c, a, x) != turn) {
        return 0;
    }
    const bool lies_ahead = orientation(a, b, c, x) == -turn;
    return lies_ahead ? static_cast<int>(turn) : 0;
}

bool is_in_box(const Triangle& face, const Point& x) {
    const auto& [a, b, c] = face;
    return (a.cwiseMin(b).cwiseMin(c).array() <= x.array()).all() &&
           (x.array() <= a.cwiseMax(b).cwiseMax(c).array()).all();
}

}  // namespace

std::optional<Index> covering_degree(const SurfaceView& surface, const Point& x) {
    Index degree = 0;
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        const Halfedge h{id};
        if (name_of_face(surface.table, h) != h) continue;
        const Triangle face = SurfaceFace::at(surface, h).triangle;
        if (is_in_box(face, x) && triangle_contains(face, x)) return std::nullopt;
        degree += crossing(face, x);
    }
    return degree;
}

}  // namespace tightflip::geometry
