/// \file
/// Pictures of surfaces as SVG.
///
/// The view is orthographic, along a direction given by two angles, and fills the picture. Faces
/// are painted from far to near, cut where they intersect or overlap in a cycle; edges and vertices
/// are drawn over them as far as no face hides them, which is worked out exactly but for roundings.
/// Of parallel edges each is bowed aside by another amount, in the order of the faces behind them,
/// and the faces follow: so the two faces at a vertex of degree 2 are told apart. Edges wear their
/// shapes and vertices their types, decided exactly; a legend counts them.
///
/// Limits: a face bowed aside may show where a straight one would be hidden; where very many faces
/// intersect, not all are cut and a few may be painted in the wrong order.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <cstdint>
#include <iosfwd>
#include <string>

namespace tightflip::geometry {

enum class DrawingStyle : std::uint8_t {
    shaded,     ///< faces with light from the upper left; the inner sides of faces are darker
    wireframe,  ///< visible edges
};

enum class VertexColouring : std::uint8_t {
    type,       ///< convex, saddle, mixed and flat, each with a colour and a mark of its own
    curvature,  ///< the angle deficit, from blue (negative) over white to red
    none,       ///< no marks
};

struct DrawingOptions {
    double azimuth = 30;    ///< degrees from the x axis towards the y axis, of where one looks from
    double elevation = 20;  ///< degrees above the plane of x and y, -90 .. 90
    DrawingStyle style = DrawingStyle::shaded;
    VertexColouring colouring = VertexColouring::type;
    bool hidden_edges = false;  ///< dashed
    int size = 640;             ///< width in pixels, 100 .. 10000; legend and title add to height
    std::string title{};        ///< UTF-8; what is not, or not allowed in XML, becomes '?'
};

/// Writes a picture; the same for the same surface and options. Any finite coordinates will do: the
/// picture has only numbers of pixels. O(n log n) for n faces that do not intersect, memory linear
/// in n; more where many overlap in the picture. Throws std::invalid_argument for options out of
/// their range. Precondition: the table is that of a triangulation with as many vertices as there
/// are points. A stream that fails is for the caller to see.
void write_svg(std::ostream& out, const SurfaceView& surface, const DrawingOptions& options = {});

}  // namespace tightflip::geometry
