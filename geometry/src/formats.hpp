/// \file
/// What a format's source file offers to mesh_file.cpp: one recogniser and one reader each.
#pragma once

#include <tightflip/geometry/mesh_file.hpp>

#include <string_view>

namespace tightflip::geometry {

struct MeshInput {
    std::string_view bytes;
    std::string_view source;
    const MeshFileOptions& options;
};

[[nodiscard]] bool looks_like_obj(std::string_view bytes);
[[nodiscard]] bool looks_like_off(std::string_view bytes);
[[nodiscard]] bool looks_like_ply(std::string_view bytes);
[[nodiscard]] bool looks_like_stl(std::string_view bytes);

[[nodiscard]] TriangleSoup read_obj(const MeshInput& input);
[[nodiscard]] TriangleSoup read_off(const MeshInput& input);
[[nodiscard]] TriangleSoup read_ply(const MeshInput& input);
[[nodiscard]] TriangleSoup read_stl(const MeshInput& input);

}  // namespace tightflip::geometry
