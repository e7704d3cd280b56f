/// \file
/// The kinds of surfaces that `make` and `campaign` make, by the names a person gives.
#pragma once

#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/properties/generators.hpp>

#include <string>

namespace tightflip::tools {

/// All kinds, and the data sets with their points, with their descriptions, one a line, for --help.
[[nodiscard]] std::string kinds_in_words();

/// The kind of that name. Throws std::invalid_argument, saying what to ask for instead, where there
/// is none or where it has no surface of that genus to choose.
[[nodiscard]] const properties::StartKind& kind_named(const std::string& name, kernel::Index genus);

/// The data set of that name, or nullptr. Throws std::invalid_argument where a genus is asked for:
/// that of a data set cannot be chosen.
[[nodiscard]] const geometry::DataSet* data_set_named(const std::string& name, kernel::Index genus);

}  // namespace tightflip::tools
