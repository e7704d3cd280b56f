#include <tightflip/geometry/exact_predicates.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tightflip::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 in_space(const Point& p) {
    return {p.x(), p.y(), p.z()};
}
Kernel::Point_2 in_plane(const Point& p) {
    return {p.x(), p.y()};
}
Sign sign(CGAL::Sign value) {
    return static_cast<Sign>(static_cast<int>(value));
}

}  // namespace

Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    return sign(CGAL::orientation(in_space(a), in_space(b), in_space(c), in_space(d)));
}

bool are_collinear(const Point& a, const Point& b, const Point& c) {
    return CGAL::collinear(in_space(a), in_space(b), in_space(c));
}

Sign coplanar_side(const Point& a, const Point& b, const Point& c, const Point& d) {
    return sign(CGAL::coplanar_orientation(in_space(a), in_space(b), in_space(c), in_space(d)));
}

Sign orientation_in_plane(const Point& a, const Point& b, const Point& c) {
    return sign(CGAL::orientation(in_plane(a), in_plane(b), in_plane(c)));
}

Sign in_circle_in_plane(const Point& a, const Point& b, const Point& c, const Point& d) {
    return sign(CGAL::side_of_oriented_circle(in_plane(a), in_plane(b), in_plane(c), in_plane(d)));
}

}  // namespace tightflip::geometry
