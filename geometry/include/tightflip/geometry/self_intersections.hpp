/// \file
/// Where a surface meets itself (Alboul et al., section 5): all pairs of faces that meet beyond
/// what they share, decided exactly.
///
/// Two faces share the vertices whose labels both have and the edges that are sides of both, and
/// meet beyond that where they have any other point in common. So two faces at one edge meet beyond
/// it only where it is folded, but two faces at parallel edges always do, for straight parallel
/// edges coincide; two faces with the same three corners always do. A pair is local where the faces
/// have a vertex in common, and global otherwise. A face of zero area is the segment or point that
/// its corners span; such a face is counted for itself, as it may meet nothing beyond what it
/// shares.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace tightflip::geometry {

/// Two faces, each named by its smallest halfedge; first < second.
struct FacePair {
    Halfedge first;
    Halfedge second;
    bool is_local = false;

    friend bool operator==(const FacePair&, const FacePair&) = default;
};

struct SelfIntersections {
    std::int64_t local_count = 0;
    std::int64_t global_count = 0;
    std::int64_t collapsed_count = 0;  ///< faces of zero area
    /// Whether all pairs were counted; otherwise there are at least so many.
    bool is_complete = true;
    /// The first pairs in ascending order, as many as were asked for.
    std::vector<FacePair> pairs;

    [[nodiscard]] bool is_embedded() const noexcept {
        return is_complete && local_count + global_count + collapsed_count == 0;
    }
};

/// Whether two different faces, each given by any of its sides, meet beyond what they share.
[[nodiscard]] bool faces_meet(const SurfaceView& surface, Halfedge f, Halfedge g);

/// All such pairs are counted and the first `kept` listed. By a tree of boxes for the global and by
/// directions at each vertex for the local pairs: O((n + k) log n) for n faces of bounded shape,
/// where k pairs of faces without a common vertex have boxes that meet, or meet locally; quadratic
/// at worst, as where most faces reach through one place. Memory: about 150 bytes a face.
/// Counting stops at `most_counted` pairs, local ones first; pairs listed then are the first of
/// those counted.
[[nodiscard]] SelfIntersections find_self_intersections(
    const SurfaceView& surface, std::size_t kept = 1000,
    std::int64_t most_counted = std::numeric_limits<std::int64_t>::max());

/// Whether no two faces meet beyond what they share and none has zero area: then the surface lies
/// in space without self-intersection. Stops at the first pair.
[[nodiscard]] bool is_embedded(const SurfaceView& surface);

/// For an embedded surface, whether it is still embedded after the flip of `e`; false where that
/// flip is refused. Compares the two new faces with all others: linear time, without allocation.
[[nodiscard]] bool flip_keeps_embedded(const SurfaceView& surface, Edge e);

}  // namespace tightflip::geometry
