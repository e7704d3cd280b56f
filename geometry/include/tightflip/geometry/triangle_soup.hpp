/// \file
/// Triangles as a file lists them, with the place in the file where each of them stood.
#pragma once

#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/handles.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace tightflip::geometry {

using kernel::FileError;
using kernel::Index;

/// Points and corner labels; nothing says yet that they form a surface. `glue` of soup_gluing.hpp
/// says which sides meet.
struct TriangleSoup {
    std::vector<Eigen::Vector3d> points;          ///< finite
    std::vector<std::array<Index, 3>> triangles;  ///< 0 <= corner < points.size(); may repeat
    /// The side that each side of each triangle is glued to, numbered 3 * triangle + side, or -1.
    /// Empty where the file does not say (all formats but PLY with `glued_sides`). They exist;
    /// nothing else is known of them.
    std::vector<std::array<Index, 3>> glued_sides;

    std::string source;                            ///< the file's name, for messages
    FileError::Unit unit = FileError::Unit::none;  ///< of the positions: lines from 1, bytes from 0
    std::vector<std::uint64_t> point_positions;    ///< where each point stood (first stood, in STL)
    std::vector<std::uint64_t> triangle_positions;  ///< where each triangle, or its polygon, stood

    [[nodiscard]] Index vertex_count() const noexcept { return static_cast<Index>(points.size()); }
};

}  // namespace tightflip::geometry
