/// \file
/// `tightflip-surface 1`: the kernel's halfedge table with a point for each vertex, so that edge
/// and halfedge numbers survive; docs/formats.md specifies it.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::geometry {

/// What a file gives; the table is for the audit to judge.
struct RawSurface {
    kernel::RawTable table;
    std::vector<Point> points;  ///< finite, as many as the table announces vertices
};

/// Whether a text begins like this format.
[[nodiscard]] bool is_surface_text(std::string_view text) noexcept;

/// Throws FileError naming `source`, the line and the reason where the text is not in the format.
/// Memory and time are linear in the text.
[[nodiscard]] RawSurface parse_surface(std::string_view text, const std::string& source);

/// Numbers are written with the shortest digits that read back as the same double.
void write_text(std::ostream& out, const SurfaceView& surface);

}  // namespace tightflip::geometry
