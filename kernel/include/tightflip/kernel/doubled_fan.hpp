/// \file
/// The doubled fan: a sphere brought into a form that an order of its vertices prescribes.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <span>
#include <vector>

namespace tightflip::kernel {

/// A sphere of two equal fans, glued along their boundary: the polygon hub, order[0], order[1], ...
/// triangulated from the hub, once seen from either side.
struct DoubledFan {
    Triangulation surface;
    std::vector<Edge> flips;  ///< from the start to `surface`
    /// path[k] leads from order[k] to order[k + 1]. It and its twin have the hub as third corner of
    /// their faces, and these are all the faces there are.
    std::vector<Halfedge> path;
};

/// Flips any sphere with V vertices into the doubled fan of `hub` over the others in the given
/// order: gathered at the hub, the plane tree beside it is spread into a book and its pages sorted,
/// as on the way of `connect`. At most 2 n ceil(log2 n) + 4 V flips for n = V - 2, and O(V log V)
/// time.
///
/// Throws std::invalid_argument where the surface is no sphere, or `order` does not hold every
/// vertex but the hub once.
[[nodiscard]] DoubledFan doubled_fan(const Triangulation& sphere, Vertex hub,
                                     std::span<const Vertex> order);

}  // namespace tightflip::kernel
