// The target flip_path for its two programs.

#include "flip_path.hpp"
#include "target.hpp"
#include <tightflip/kernel/surface_text.hpp>

#include <ostream>

namespace tightflip::fuzz {

std::string objection(std::span<const std::uint8_t> data) {
    return path_objection(decode_path_case(data));
}

void show(std::ostream& out, std::span<const std::uint8_t> data) {
    const PathCase ends = decode_path_case(data);
    out << ends.words << "\n";
    write_text(out, ends.from);
    write_text(out, ends.to);
}

}  // namespace tightflip::fuzz
