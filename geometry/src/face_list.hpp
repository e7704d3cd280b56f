/// \file
/// A surface as the faces of a mesh file.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tightflip::geometry {

using FaceCorners = std::array<Index, 3>;

/// The corners of each face, in the order of the faces' smallest halfedges, which come first.
[[nodiscard]] std::vector<FaceCorners> corners_of_faces(kernel::HalfedgeTable table);

/// What the sides of these faces are glued to, numbered 3 * face + side.
[[nodiscard]] std::vector<FaceCorners> glued_sides_of_faces(kernel::HalfedgeTable table);

/// Two vertices that several edges join, so that the corners do not say which sides are glued.
[[nodiscard]] std::optional<std::pair<Vertex, Vertex>> parallel_edges(kernel::HalfedgeTable table);

}  // namespace tightflip::geometry
