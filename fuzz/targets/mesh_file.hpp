/// \file
/// The target mesh_file: bytes as an OBJ, OFF, PLY or STL file.
#pragma once

#include "target.hpp"
#include <tightflip/geometry/mesh_file.hpp>

#include <string>
#include <string_view>

namespace tightflip::fuzz {

/// How the first byte says to read the rest: modulo 5 by content, or as OBJ, OFF, PLY, STL; then
/// modulo 2 whether polygons are cut into triangles, then whether there must be faces.
[[nodiscard]] geometry::MeshFileOptions decode_mesh_options(std::uint8_t byte);
[[nodiscard]] std::uint8_t encode_mesh_options(const geometry::MeshFileOptions& options);

/// What does not hold of bytes read as a mesh.
[[nodiscard]] std::string mesh_objection(std::string_view bytes,
                                         const geometry::MeshFileOptions& options);

}  // namespace tightflip::fuzz
