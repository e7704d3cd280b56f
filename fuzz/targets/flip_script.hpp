/// \file
/// The target flip_script: a start and a flip script under every claim about flips.
#pragma once

#include "script_input.hpp"

namespace tightflip::fuzz {

/// The first claim about flips that does not hold of a case, in words; empty where all do.
[[nodiscard]] std::string script_objection(const properties::FlipCase& flip_case);

/// Starts and scripts to begin with.
[[nodiscard]] std::vector<Seed> script_seeds();

/// A case in words.
void show_script(std::ostream& out, Input input);

}  // namespace tightflip::fuzz
