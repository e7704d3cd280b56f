/// \file
/// What two triangles have in common, decided exactly.
///
/// Triangles are closed, and any three points form one: those on a line form the segment they span,
/// three equal ones a point. What two of them have in common is a convex set, and the mechanism is
/// to list its extreme points: each is a corner of one triangle that lies in the other, or a proper
/// crossing (of a side with the interior of the other triangle, or of two sides), which is never a
/// corner. Signs of exact predicates tell them apart; no point is computed.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace tightflip::geometry {

using Triangle = std::array<Point, 3>;

/// The dimension of what two triangles have in common.
enum class Contact : std::uint8_t {
    none,
    point,
    segment,
    area,  ///< they are coplanar and overlap
};

/// Exact for all finite coordinates, like all of this file; constant time, no allocation except
/// inside predicates whose filter fails.
[[nodiscard]] Contact contact(const Triangle& f, const Triangle& g);

/// Whether two triangles have a point in common.
[[nodiscard]] bool triangles_meet(const Triangle& f, const Triangle& g);

/// Whether two triangles have a point in common outside the hull of `shared`, which holds none, one
/// or two points that are corners of both. Quicker than `contact` where they have not.
[[nodiscard]] bool triangles_meet_beyond(const Triangle& f, const Triangle& g,
                                         std::span<const Point> shared);

/// Whether a point lies in a triangle.
[[nodiscard]] bool triangle_contains(const Triangle& triangle, const Point& x);

}  // namespace tightflip::geometry
