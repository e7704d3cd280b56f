/// \file
/// The kinds of surfaces that `make` and `campaign` make, by the names a person gives.
#pragma once

#include <tightflip/properties/generators.hpp>

#include <string>

namespace tightflip::tools {

/// All kinds with their descriptions, one a line, for --help.
[[nodiscard]] std::string kinds_in_words();

/// The kind of that name. Throws std::invalid_argument, saying what to ask for instead, where there
/// is none or where it has no surface of that genus to choose.
[[nodiscard]] const properties::StartKind& kind_named(const std::string& name, kernel::Index genus);

}  // namespace tightflip::tools
