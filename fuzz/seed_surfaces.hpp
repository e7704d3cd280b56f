/// \file
/// Surfaces that seeds are made of: all small classes, and one of every family.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <string>
#include <vector>

namespace tightflip::fuzz {

struct SeedSurface {
    std::string name;
    kernel::Triangulation surface;
};

/// At most 36 faces each; always the same.
[[nodiscard]] std::vector<SeedSurface> seed_surfaces();

}  // namespace tightflip::fuzz
