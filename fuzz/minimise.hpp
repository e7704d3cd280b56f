/// \file
/// Makes a failing input short.
#pragma once

#include "target.hpp"

namespace tightflip::fuzz {

/// What a target says of an input: its objection, or, where it comes to no answer, "crash: ..." or
/// "time: ...".
[[nodiscard]] std::string guarded_objection(const Target& target, Input input,
                                            unsigned seconds = 10);

/// An input that breaks the same claim, from which no record can be left out (of text: no line and
/// no byte) and in which no byte alone can be made smaller. Deterministic. The input itself where
/// nothing is objected to it. Attempts run in a child process, and each in one of its own where one
/// of them ends it, so that crashes are minimised as well.
[[nodiscard]] InputBytes minimise(const Target& target, Input input);

}  // namespace tightflip::fuzz
