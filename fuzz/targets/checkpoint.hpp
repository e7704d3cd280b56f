/// \file
/// The target checkpoint: bytes in place of what an exploration kept.
#pragma once

#include "target.hpp"

namespace tightflip::fuzz {

/// Which of the two files the bytes are, by the first of them, modulo 2: that of classes, or that
/// of a labelled search.
inline constexpr std::size_t checkpoint_kinds = 2;

/// What does not hold of a run that finds such a file: it is refused and left as it was, or the
/// result is that of a run without.
[[nodiscard]] std::string checkpoint_objection(std::size_t kind, Input file);

}  // namespace tightflip::fuzz
