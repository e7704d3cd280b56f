/// \file
/// Writing a surface as OBJ, OFF, PLY or STL, or saying why the format cannot hold it.
///
/// Coordinates are written with the shortest digits that read back as the same double, in binary
/// PLY as doubles, in binary STL as floats, for it has nothing else. Vertices keep their order,
/// faces come in the order of `Triangulation::faces`; edge numbers and the order of faces in a
/// file that the surface was read from are not kept.
///
/// - OBJ and OFF list faces by their corners alone. That does not say which sides are glued where
///   two vertices are joined by several edges: such a surface is refused.
/// - PLY can say it: the property `glued_sides` of a face lists for its three sides the side that
///   each is glued to, numbered 3 * face + side. Other readers pass over it.
/// - STL has neither labels nor gluing: corners at one point are one vertex. Refused: parallel
///   edges, two vertices at one point (in binary: one point after rounding to float), and in binary
///   coordinates beyond the range of a float. Vertices come back in the order of their first
///   corner, and -0 as 0.
#pragma once

#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/geometry/surface.hpp>

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

namespace tightflip::geometry {

enum class MeshEncoding : std::uint8_t { text, binary };

struct MeshWriteOptions {
    MeshEncoding encoding = MeshEncoding::binary;  ///< OBJ and OFF are text whatever it says
    bool always_glued_sides = false;  ///< else PLY has `glued_sides` where there are parallel edges
};

/// Why a format cannot hold the surface, and the way out; empty where it can. O(n log n).
[[nodiscard]] std::optional<std::string> obstacle_to_writing(const SurfaceView& surface,
                                                             MeshFormat format,
                                                             MeshEncoding encoding);

/// Writes a surface. O(n log n). Throws std::invalid_argument with the obstacle, before it writes
/// anything, where there is one. Precondition: the table is that of a Triangulation.
void write_mesh(std::ostream& out, const SurfaceView& surface, MeshFormat format,
                const MeshWriteOptions& options = {});

}  // namespace tightflip::geometry
