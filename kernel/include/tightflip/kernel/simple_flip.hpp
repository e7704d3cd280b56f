/// \file
/// Flips that keep a simple graph simple.
#pragma once

#include <tightflip/kernel/circulation.hpp>
#include <tightflip/kernel/flip.hpp>

namespace tightflip::kernel {

/// Whether the flip is defined and joins two vertices that no edge joins yet. Linear in the degree
/// of one of them.
[[nodiscard]] constexpr bool can_flip_simply(HalfedgeTable table, Edge e) noexcept {
    const auto q = Quadrilateral::around(table, e);
    const Vertex d = at(table, q.t2).origin;
    if (at(table, q.h2).origin == d) return false;
    for (const Vertex v : Neighbours(table, q.h2)) {
        if (v == d) return false;
    }
    return true;
}

}  // namespace tightflip::kernel
