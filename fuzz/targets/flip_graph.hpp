/// \file
/// The target flip_graph: an exploration of few vertices beside a naive one.
#pragma once

#include "target.hpp"
#include <tightflip/kernel/explore.hpp>

#include <cstdint>

namespace tightflip::fuzz {

struct FlipGraphCase {
    kernel::ExploreRequest request;
    unsigned threads = 1;
    std::uint64_t seed = 0;  ///< of the surfaces between which paths are looked for
};

/// The case that the bytes say: fuzz/README.md gives the layout.
[[nodiscard]] FlipGraphCase decode_flip_graph(Input input);

/// What does not hold of the exploration, and of a shortest path.
[[nodiscard]] std::string flip_graph_objection(const FlipGraphCase& graph);

}  // namespace tightflip::fuzz
