#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/geometry/exact_predicates.hpp>

namespace tightflip::geometry {

EdgeShape edge_shape(const Hinge& hinge) {
    const auto& [a, b, c, d] = hinge;
    switch (orientation(a, b, c, d)) {
        case Sign::negative:
            return EdgeShape::convex;
        case Sign::positive:
            return EdgeShape::concave;
        case Sign::zero:
            break;
    }
    if (are_collinear(a, b, c) || are_collinear(a, b, d)) return EdgeShape::degenerate;
    return coplanar_side(a, b, c, d) == Sign::negative ? EdgeShape::flat : EdgeShape::folded;
}

}  // namespace tightflip::geometry
