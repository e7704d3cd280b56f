/// \file
/// Sets of labelled surfaces, and all that flips reach.
#pragma once

#include <tightflip/kernel/surface_equality.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <unordered_set>
#include <vector>

namespace tightflip::properties {

struct SurfaceHash {
    std::size_t operator()(const kernel::Triangulation& s) const noexcept {
        return surface_hash(s);
    }
};
struct SameSurface {
    bool operator()(const kernel::Triangulation& a, const kernel::Triangulation& b) const {
        return same_labelled_surface(a, b);
    }
};
using LabelledSurfaces = std::unordered_set<kernel::Triangulation, SurfaceHash, SameSurface>;

/// All labelled surfaces that flips reach.
inline LabelledSurfaces reached_by_flips(const kernel::Triangulation& start) {
    LabelledSurfaces reached{start};
    std::vector<kernel::Triangulation> open{start};
    while (!open.empty()) {
        const kernel::Triangulation surface = std::move(open.back());
        open.pop_back();
        for (kernel::Index e = 0; e < surface.edge_count(); ++e) {
            kernel::Triangulation flipped = surface;
            if (flipped.flip({e}) && reached.insert(flipped).second) {
                open.push_back(std::move(flipped));
            }
        }
    }
    return reached;
}

}  // namespace tightflip::properties
