/// \file
/// Whether a flip is among those that the options allow.
#pragma once

#include <tightflip/geometry/optimise.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/kernel/simple_flip.hpp>

namespace tightflip::geometry {

/// Precondition: the flip is defined.
[[nodiscard]] inline bool is_allowed(AllowedFlips allowed, const Triangulation& surface,
                                     Points points, Edge e) {
    switch (allowed) {
        case AllowedFlips::all:
            return true;
        case AllowedFlips::simple:
            return kernel::can_flip_simply(surface.table(), e);
        case AllowedFlips::embedded:
            return flip_keeps_embedded({surface.table(), points}, e);
    }
    return false;
}

}  // namespace tightflip::geometry
