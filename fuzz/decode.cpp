#include "decode.hpp"

#include "bytes.hpp"

namespace tightflip::fuzz {

properties::FlipCase decode(std::span<const std::uint8_t> data) {
    const auto kinds = properties::start_kinds();
    Bytes bytes(data);
    properties::FlipCase flip_case;
    flip_case.kind = &kinds[bytes.byte() % kinds.size()];
    const kernel::Index spare = bytes.below(most_spare_vertices + 1);
    const kernel::Index genus = bytes.below(most_genus + 1);
    if (flip_case.kind->any_genus) flip_case.request.genus = genus;
    flip_case.request.vertices = flip_case.kind->least_vertices(flip_case.request.genus) + spare;
    flip_case.request.seed = bytes.byte();
    while (!bytes.empty() && flip_case.picks.size() < most_flips) {
        flip_case.picks.push_back(bytes.pair());
    }
    return flip_case;
}

}  // namespace tightflip::fuzz
