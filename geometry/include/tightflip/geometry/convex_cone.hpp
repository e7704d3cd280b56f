/// \file
/// The convex cone that rays from one point span, decided exactly.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tightflip::geometry {

/// Whether b and c lie in the same direction from the apex, neither at it. Exact.
[[nodiscard]] bool same_direction(const Point& apex, const Point& b, const Point& c);

/// Whether b and c lie in opposite directions from the apex, neither at it. Exact.
[[nodiscard]] bool opposite_direction(const Point& apex, const Point& b, const Point& c);

/// A cone and the memory to compute the next one in.
class ConvexCone {
public:
    /// Replaces the cone by that of the rays from `apex` through `targets`; targets at the apex are
    /// left out. By insertion, each ray located by bisection: O(d log d) exact predicates for d
    /// rays. Allocates only where d is larger than ever before.
    void span(const Point& apex, Points targets);

    /// Whether an open half-space, bounded by a plane through the apex, holds all rays: if not, the
    /// cone contains a line (it is a wedge, a half-space, a plane, the whole space ...).
    [[nodiscard]] bool is_pointed() const noexcept { return pointed_; }

    /// Of a pointed cone, the extreme rays as indices of `targets`, one a direction: none where all
    /// targets are at the apex, one for a single ray, two for a flat wedge; otherwise in the order
    /// in which a face fan about a convex vertex has them, counter-clockwise seen from outside.
    [[nodiscard]] std::span<const Index> extreme_rays() const noexcept { return rays_; }

    /// Of a cone that is not pointed, at most four of its rays that contain a line together, as
    /// indices of `targets`: while these stay, so does the line.
    [[nodiscard]] std::span<const Index> line() const noexcept {
        return {line_.data(), line_size_};
    }

private:
    struct Insertion;

    std::vector<Index> rays_;
    std::array<Index, 4> line_{};
    std::size_t line_size_ = 0;
    bool pointed_ = true;
};

}  // namespace tightflip::geometry
