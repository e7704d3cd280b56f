/// \file
/// Whether the inner side of a surface is seen from outside: what the paper says of global
/// self-intersections (Alboul et al., section 5).
///
/// A ray that comes from far away and first meets a face on its inner side has then reached points
/// about which the surface has the covering degree -1. So a surface whose covering degree is
/// nowhere negative shows its inner side to no ray; and it is nowhere negative where the surface is
/// the boundary of a sum of tetrahedra, each bounded once and outwards, since the degree about a
/// point is then the number of tetrahedra that contain it.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tightflip::properties {

/// The corners of a tetrahedron in any order.
using Tetrahedron = std::array<kernel::Vertex, 4>;

/// Whether the faces of the surface are those of the tetrahedra, each turned outwards and counted
/// as often as it occurs, when faces that occur both ways have cancelled. False where one of the
/// tetrahedra has no volume. Exact.
[[nodiscard]] bool is_sum_of_tetrahedra(const geometry::SurfaceView& surface,
                                        std::span<const Tetrahedron> tetrahedra);

/// At most so many tetrahedra of which the surface is the sum, if there are. Tries at most
/// (V - 3)^most ways.
[[nodiscard]] std::optional<std::vector<Tetrahedron>> as_sum_of_tetrahedra(
    const geometry::SurfaceView& surface, std::size_t most);

/// A segment from outside the convex hull to its end behind a face that it meets on its inner side,
/// and meets no other.
struct NegativeView {
    geometry::Point from;
    geometry::Point to;
    kernel::Halfedge face;
};

/// Whether the segment is such a view of the surface; exact.
[[nodiscard]] bool is_negative_view(const geometry::SurfaceView& surface, const NegativeView& view);

/// Looks along random rays for a view of the inner side; linear time each.
[[nodiscard]] std::optional<NegativeView> find_negative_view(const geometry::SurfaceView& surface,
                                                             int rays, std::uint64_t seed);

}  // namespace tightflip::properties
