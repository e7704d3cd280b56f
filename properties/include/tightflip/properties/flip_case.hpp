/// \file
/// One test of a claim by description: a start and a script, small enough to draw, shrink, show and
/// write down in bytes.
#pragma once

#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/generators.hpp>

#include <iosfwd>

namespace tightflip::properties {

/// Any values make a valid case: sizes are rounded to what the kind can have, and picks to edges.
struct FlipCase {
    const StartKind* kind = start_kinds().data();  ///< never null
    StartRequest request;
    /// The script; each pick names an edge of the start, modulo their number.
    std::vector<std::uint32_t> picks;

    /// Made anew at each call, at the cost of `make_nearest`; so are those that follow.
    [[nodiscard]] Triangulation start() const { return make_nearest(*kind, request); }
    /// The start with the whole script, refused flips included.
    [[nodiscard]] kernel::FlipLog log() const;
    [[nodiscard]] FlipScript script() const { return log().flips; }
};

/// One line: kind, sizes, seed and the script's edges. Makes the start, to count its edges.
[[nodiscard]] std::string describe(const FlipCase& flip_case);

/// The script in words, one line a flip: which vertices the edge joined and joins now, or why it
/// was refused. Made for reading, and robust where the kernel is broken.
void write_in_words(std::ostream& out, const kernel::FlipLog& log);

}  // namespace tightflip::properties
