// The target flip_script for its two programs.

#include "decode.hpp"
#include "flip_script.hpp"
#include "target.hpp"

#include <ostream>

namespace tightflip::fuzz {

std::string objection(std::span<const std::uint8_t> data) {
    const auto broken = first_broken_claim(decode(data).log());
    if (!broken) return {};
    return std::string(broken->claim) + " does not hold: " + describe(broken->finding);
}

void show(std::ostream& out, std::span<const std::uint8_t> data) {
    const properties::FlipCase flip_case = decode(data);
    out << describe(flip_case) << "\n";
    properties::write_in_words(out, flip_case.log());
}

}  // namespace tightflip::fuzz
