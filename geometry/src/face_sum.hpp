/// \file
/// Criteria that add up a measure of each face.
#pragma once

#include "height_field.hpp"

#include <utility>

namespace tightflip::geometry {

/// `Measure` has `dimension`, the power of a length that it is, `needs_heights`, and a call with
/// the surface and a face. (Those with more than one level are numbers without a unit.)
template <class Measure>
class FaceSum final : public Criterion {
public:
    FaceSum(const SurfaceView& surface, Vertex marked, std::string_view name)
        : surface_(surface, marked) {
        if constexpr (Measure::needs_heights) require_height_field(surface_, name);
        measure_.prepare(surface_);
    }

    [[nodiscard]] std::size_t level_count() const override { return Measure::level_count; }

    [[nodiscard]] Energy value() const override {
        Energy sum;
        surface_.for_each_face([&](const FaceCorners& face) { sum += measure_(surface_, face); });
        return in_units(sum);
    }

    [[nodiscard]] Energy change(Edge e) override {
        const HingeCorners hinge = HingeCorners::at(surface_.table(), e);
        if (!surface_.counts(hinge)) return Energy::forbidden();
        if constexpr (Measure::needs_heights) {
            if (!flip_keeps_plane(surface_, hinge)) return Energy::forbidden();
        }
        const auto before = hinge.faces();
        const auto after = hinge.flipped().faces();
        return in_units((measure_(surface_, after[0]) + measure_(surface_, after[1])) -
                        (measure_(surface_, before[0]) + measure_(surface_, before[1])));
    }

    void flipped(Edge /*e*/) override {}

    void append_affected(Edge e, std::vector<Edge>& edges) const override {
        append_edges_of_faces(surface_.table(), e, edges);
    }

private:
    [[nodiscard]] Energy in_units(Energy energy) const {
        energy.levels[0] = surface_.in_units(energy.levels[0], Measure::dimension);
        return energy;
    }

    BoundSurface surface_;
    Measure measure_;
};

}  // namespace tightflip::geometry
