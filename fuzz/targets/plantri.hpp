/// \file
/// The target plantri: bytes as planar_code or edge_code.
#pragma once

#include "target.hpp"
#include <tightflip/kernel/plantri_code.hpp>

#include <string>
#include <string_view>

namespace tightflip::fuzz {

/// What does not hold of bytes read as a stream of graphs, which are in this format where no header
/// says so.
[[nodiscard]] std::string plantri_objection(std::string_view bytes,
                                            kernel::PlantriFormat headerless);

}  // namespace tightflip::fuzz
