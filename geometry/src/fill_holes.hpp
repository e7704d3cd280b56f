/// \file
/// Closing the boundary of a soup, loop by loop.
#pragma once

#include <tightflip/geometry/triangle_soup.hpp>

namespace tightflip::geometry {

struct FilledHoles {
    Index holes = 0;
    Index faces = 0;
    Index sides_left_open = 0;
};

/// Adds a vertex and a fan of faces to each loop of boundary sides. O(n log n). Throws FileError
/// where the faces would exceed the limit.
FilledHoles fill_holes(TriangleSoup& soup);

}  // namespace tightflip::geometry
