/// \file
/// Random starts: surfaces some flips away from a given one.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <cstdint>
#include <vector>

namespace tightflip::kernel {

struct RandomFlips {
    std::int64_t count = 0;
    std::uint64_t seed = 0;
    bool simple = false;  ///< none that makes a parallel edge
};

/// Flips edges drawn uniformly from those that can be flipped, and returns them in order: as many
/// as asked for, or fewer where one is reached from which there is none. The same for a seed on
/// every machine. Some tries a flip, each linear in a degree for simple ones.
std::vector<Edge> flip_at_random(Triangulation& surface, const RandomFlips& request);

}  // namespace tightflip::kernel
