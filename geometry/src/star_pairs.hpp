/// \file
/// Pairs of faces of one star that may meet beyond the vertex.
#pragma once

#include "box_tree.hpp"

namespace tightflip::geometry {

/// A halfedge that leaves each vertex, by its label.
[[nodiscard]] std::vector<Halfedge> halfedge_of_each_vertex(const SurfaceView& surface);

/// The faces at a vertex as sets of directions from it, that is arcs on the sphere of directions:
/// two faces have a point other than the vertex in common just where their arcs meet. The arcs are
/// approximate and their boxes wide enough for that; what they leave is for exact predicates.
class StarPairs {
public:
    /// Replaces the star by that of the origin of `h`. O(d log d) for degree d; allocates only
    /// where d is larger than ever before.
    void read(const SurfaceView& surface, Halfedge h);

    /// Calls `is_enough(f, g)` with pairs of halfedges that leave the vertex in different faces, so
    /// that none is left out whose faces meet beyond what they share, until it returns true;
    /// returns whether it did. O((d + k) log d) for k pairs of arcs whose boxes meet.
    template <class IsEnough>
    [[nodiscard]] bool any(const IsEnough& is_enough) const {
        return tree_.any_pair(
            [&](Index f, Index g) { return is_enough(Halfedge{f}, Halfedge{g}); });
    }

private:
    BoxTree tree_;
};

}  // namespace tightflip::geometry
