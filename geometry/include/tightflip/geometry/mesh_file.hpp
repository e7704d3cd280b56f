/// \file
/// Reading the connectivity and the positions of mesh files: OBJ, OFF, PLY and STL.
///
/// Either the whole file is understood or a FileError names the file, the line (text) or byte
/// (binary), the reason and the way out: nothing is skipped that would change the surface, and
/// nothing is returned in part. Memory stays within a small multiple of the file's size: a header's
/// counts are compared with the bytes that follow before anything is reserved.
///
/// The formats are parsed here because the readers at hand (CGAL 5.5, Stream_support) answer with
/// success or failure alone, not with the place; they also accept `f 1 2x 3`, and they size their
/// arrays by the header of a file of a few bytes.
///
/// - OBJ: `v`, `f` in all forms, relative indices, a backslash at a line's end; refused: free-form
///   curves, `call`.
/// - OFF: with any of ST, C, N before it, the keyword glued to or on the line of the counts;
///   refused: 4OFF, nOFF, BINARY.
/// - PLY: ASCII and binary of both byte orders, extra elements and properties; the gluing where
///   faces have the property `glued_sides` (docs/formats.md); refused: triangle strips.
/// - STL: ASCII (several solids too) and binary; equal coordinates are one vertex, -0 equals 0.
#pragma once

#include <tightflip/geometry/triangle_soup.hpp>
#include <tightflip/kernel/gluing.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tightflip::geometry {

enum class MeshFormat : std::uint8_t { obj, off, ply, stl };

/// The format's name, which is its usual extension: "obj", "off", "ply" or "stl".
[[nodiscard]] std::string_view name(MeshFormat format);

/// How to read.
struct MeshFileOptions {
    std::optional<MeshFormat> format{};  ///< empty: by content, then by the name's extension
    /// Cut polygons into fans about their first corner, without regard to their shape. Otherwise
    /// faces with more than three corners are refused.
    bool triangulate_polygons = false;
    bool faces_required = true;           ///< refuse a file that has none
    Index max_faces = kernel::max_faces;  ///< more triangles are refused; never above the kernel's
};

/// Reads a file. Linear time (STL: O(n log n)). Throws FileError.
[[nodiscard]] TriangleSoup read_mesh_file(const std::filesystem::path& path,
                                          const MeshFileOptions& options = {});

/// Reads a file's bytes; `source` names them in messages and lends its extension.
[[nodiscard]] TriangleSoup read_mesh(std::string_view bytes, const std::string& source,
                                     const MeshFileOptions& options = {});

/// The format by content, or else by the extension of `source`; empty where neither says.
[[nodiscard]] std::optional<MeshFormat> detect_mesh_format(std::string_view bytes,
                                                           const std::filesystem::path& source);

}  // namespace tightflip::geometry
