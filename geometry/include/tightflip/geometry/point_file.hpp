/// \file
/// Points alone, out of any file that holds some.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::geometry {

/// The points of a mesh (OBJ, OFF, PLY, STL; its faces, if any, are left aside but must be
/// readable), of a `tightflip-surface`, or of a text with three coordinates a line. Finite; in the
/// order of the file. Throws FileError with the line or byte.
[[nodiscard]] std::vector<Point> read_point_file(const std::filesystem::path& path);

/// Reads a file's bytes; `source` names them in messages and lends its extension.
[[nodiscard]] std::vector<Point> read_points(std::string_view bytes, const std::string& source);

}  // namespace tightflip::geometry
