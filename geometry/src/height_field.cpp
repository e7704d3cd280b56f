#include "height_field.hpp"

#include <tightflip/geometry/exact_predicates.hpp>

#include <stdexcept>
#include <string>

namespace tightflip::geometry {
namespace {

bool is_seen_from_above(const BoundSurface& surface, const FaceCorners& face) {
    return orientation_in_plane(surface.exact(face.a), surface.exact(face.b),
                                surface.exact(face.c)) == Sign::positive;
}

}  // namespace

void require_height_field(const BoundSurface& surface, std::string_view criterion) {
    const std::string name(criterion);
    const auto count = static_cast<Index>(surface.view().points.size());
    if (surface.marked().id < 0 || surface.marked().id >= count) {
        throw std::invalid_argument("the criterion " + name +
                                    " is for heights over a plane: it needs the marked vertex that "
                                    "closes their boundary");
    }
    surface.for_each_face([&](const FaceCorners& face) {
        if (is_seen_from_above(surface, face)) return;
        throw std::invalid_argument("the criterion " + name +
                                    " is for heights over a plane, but the face of the vertices " +
                                    std::to_string(face.a.id) + ", " + std::to_string(face.b.id) +
                                    ", " + std::to_string(face.c.id) +
                                    " is not counter-clockwise seen from above");
    });
}

bool flip_keeps_plane(const BoundSurface& surface, const HingeCorners& hinge) {
    for (const FaceCorners& face : hinge.flipped().faces()) {
        if (!is_seen_from_above(surface, face)) return false;
    }
    return true;
}

}  // namespace tightflip::geometry
