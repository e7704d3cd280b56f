/// \file
/// Whether points are in general position: no two coincide, no three lie on a line, no four in a
/// plane. Decided exactly.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace tightflip::geometry {

/// Which triples and quadruples were looked at. Pairs always are, all of them.
enum class PositionScope : std::uint8_t {
    all_points,  ///< every triple and quadruple of points
    flips,       ///< those that flips meet: the corners of each face, and of the two faces that a
                 ///< flip of each edge would make; the four corners of the two faces at each edge
};

/// Sets of `size` points by their labels, ascending: how many, and the first ones in ascending
/// order.
template <std::size_t size>
struct OffendingSets {
    std::int64_t count = 0;
    std::vector<std::array<Vertex, size>> first;
};

/// Every offence is counted once, in the smallest set that shows it: collinear triples have no two
/// points that coincide, coplanar quadruples no three points on a line.
struct GeneralPosition {
    PositionScope scope = PositionScope::all_points;
    OffendingSets<2> coincident;
    OffendingSets<3> collinear;
    OffendingSets<4> coplanar;

    [[nodiscard]] bool holds() const noexcept {
        return coincident.count + collinear.count + coplanar.count == 0;
    }
};

struct GeneralPositionOptions {
    /// Up to so many points, all triples and quadruples of a surface's points are looked at. For 64
    /// points these are 677,040 predicates and some ten milliseconds, seconds where coordinates
    /// like 1e300 make every one of them need exact arithmetic; it grows with the fourth power.
    std::size_t all_up_to = 64;
    /// Of each kind, how many sets are listed.
    std::size_t kept = 10;
};

/// All pairs, triples and quadruples of points, however many there are: O(n^4).
[[nodiscard]] GeneralPosition general_position(Points points, std::size_t kept = 10);

/// All points of small surfaces, else those sets that flips meet: O(n log n). Corners that coincide
/// as labels make no set.
[[nodiscard]] GeneralPosition general_position(const SurfaceView& surface,
                                               const GeneralPositionOptions& options = {});

}  // namespace tightflip::geometry
