/// \file
/// Mending what keeps a soup from being a closed surface; nothing is done that is not asked for.
#pragma once

#include <tightflip/geometry/triangle_soup.hpp>

#include <optional>
#include <string>
#include <vector>

namespace tightflip::geometry {

/// What to mend, in the order in which it is done.
struct RepairOptions {
    /// Make points no further apart than this one vertex; 0: those with equal coordinates (-0
    /// equals 0). Each point in turn goes to the first earlier one that was kept and is near
    /// enough, so nothing moves further than the distance.
    std::optional<double> weld{};
    /// Drop faces that repeat a corner, and faces that repeat the corners of an earlier one, in
    /// whatever direction; not the second of two faces, which are a sphere, nor where the file says
    /// how its faces are glued.
    bool drop_faces = false;
    bool drop_unused = false;  ///< drop vertices that belong to no face
    /// Close each loop of boundary sides with a fan of faces about a new vertex, the mean of the
    /// loop's vertices. A side that belongs to no loop stays open.
    bool fill_holes = false;

    [[nodiscard]] bool any() const noexcept {
        return weld || drop_faces || drop_unused || fill_holes;
    }
    friend bool operator==(const RepairOptions&, const RepairOptions&) = default;
};

/// All repairs; points are welded where their coordinates are equal.
inline constexpr RepairOptions all_repairs{
    .weld = 0.0, .drop_faces = true, .drop_unused = true, .fill_holes = true};

/// What was done.
struct RepairReport {
    Index points_welded = 0;  ///< points that became another one's vertex
    Index faces_repeating_corners = 0;
    Index faces_repeating_faces = 0;
    Index vertices_unused = 0;
    Index holes_filled = 0;
    Index faces_added = 0;
    Index sides_left_open = 0;    ///< only counted where holes were to be filled
    bool gluing_dropped = false;  ///< the file's gluing no longer fitted the faces

    friend bool operator==(const RepairReport&, const RepairReport&) = default;
};

/// One line for each thing done, or "nothing to repair".
[[nodiscard]] std::vector<std::string> in_words(const RepairReport& report);

/// Repairs a soup in place; vertices and faces that stay keep their order and their positions, new
/// ones get the position of a face whose side they close. O(n log n) time for welding equal points
/// and for the rest; welding within a distance takes linear time where few points are that near.
/// A gluing given by the file is dropped where points are welded or faces dropped. Throws
/// std::invalid_argument for a distance that is negative or not finite, FileError where so many
/// faces would be added that they exceed the limit, or no face is left.
RepairReport repair(TriangleSoup& soup, const RepairOptions& options);

}  // namespace tightflip::geometry
