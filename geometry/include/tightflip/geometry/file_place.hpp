/// \file
/// From a finding of the judge back to the file: where the face or vertex in question stood.
#pragma once

#include <tightflip/geometry/triangle_soup.hpp>
#include <tightflip/kernel/violation.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace tightflip::geometry {

/// The line or byte (`soup.unit`) where the face, side or vertex of a finding stood. Empty where it
/// concerns the whole surface or something that no file lists. Precondition: the finding is about
/// `soup.triangles`, in their order.
[[nodiscard]] std::optional<std::uint64_t> file_position(const TriangleSoup& soup,
                                                         const kernel::Violation& violation);

/// The place in words, file first: "mesh.obj:12: face 3, side 1", "mesh.stl: byte 84: face 0" or
/// "mesh.obj: surface".
[[nodiscard]] std::string where(const TriangleSoup& soup, const kernel::Violation& violation);

}  // namespace tightflip::geometry
