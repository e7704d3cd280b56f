/// \file
/// Into how many pieces planes cut a surface: the two-piece property of tight surfaces (Alboul et
/// al., remark in section 4.1.2, after Kuiper and Banchoff).
///
/// A plane cuts a surface into the connected parts of what it leaves on its two open sides. On one
/// side these are as many as the components of the graph of the vertices there with the edges
/// between them, since what a face has on that side shrinks to its corners there.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>

namespace tightflip::properties {

/// A plane by what it does to the vertices, and the pieces on both sides.
struct PlaneCut {
    kernel::Index above = 0;
    kernel::Index below = 0;
    /// The plane is as close as can be to that through these three points; above it is the side
    /// from which they are seen counter-clockwise.
    std::array<kernel::Vertex, 3> through{};
    /// Whether each of the three, in the same order, is above.
    std::array<bool, 3> is_above{};

    [[nodiscard]] kernel::Index pieces() const noexcept { return above + below; }
};

/// A plane that cuts the surface into the most pieces; exact. Moving a plane a little away from the
/// vertices on it takes no piece away, so planes without vertices are enough, and all they can do
/// to the vertices is found by placing the plane at three points, tilting it about two of them,
/// then about one, and moving it off that. Points in one plane are looked at from that plane only,
/// as lines cut them. At least 2 for any surface with an edge that a plane can cross; 0 where all
/// points lie on one line. O(V^4) time for V points, more by a factor of up to 6 where many are
/// coplanar: some milliseconds for 12 vertices, seconds for 60.
[[nodiscard]] PlaneCut most_pieces(const geometry::SurfaceView& surface);

}  // namespace tightflip::properties
