/// \file
/// The same surface under other numbers.
#pragma once

#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/triangulation.hpp>

namespace tightflip::fuzz {

/// Edges in random order, their two halves changed about at random; labels stay.
[[nodiscard]] kernel::Triangulation with_other_halfedges(const kernel::Triangulation& surface,
                                                         kernel::RandomStream& random);
/// Vertex labels in random order; numbers of halfedges stay.
[[nodiscard]] kernel::Triangulation with_other_labels(const kernel::Triangulation& surface,
                                                      kernel::RandomStream& random);
/// Every face turned over in its place: halfedge h runs the other way.
[[nodiscard]] kernel::Triangulation mirrored(const kernel::Triangulation& surface);

}  // namespace tightflip::fuzz
