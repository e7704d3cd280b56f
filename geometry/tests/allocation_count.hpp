/// \file
/// How much memory a test program has requested from operator new so far.
#pragma once

#include <cstddef>

namespace tightflip::geometry {

[[nodiscard]] std::size_t bytes_requested() noexcept;

}  // namespace tightflip::geometry
