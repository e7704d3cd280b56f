#include "decode.hpp"

namespace tightflip::fuzz {

properties::FlipCase decode_start(Bytes& bytes) {
    const auto kinds = properties::start_kinds();
    properties::FlipCase flip_case;
    flip_case.kind = &kinds[bytes.byte() % kinds.size()];
    const kernel::Index spare = bytes.below(most_spare_vertices + 1);
    const kernel::Index genus = bytes.below(most_genus + 1);
    if (flip_case.kind->any_genus) flip_case.request.genus = genus;
    flip_case.request.vertices = flip_case.kind->least_vertices(flip_case.request.genus) + spare;
    flip_case.request.seed = bytes.byte();
    return flip_case;
}

properties::FlipCase decode(std::span<const std::uint8_t> data) {
    Bytes bytes(data);
    properties::FlipCase flip_case = decode_start(bytes);
    while (!bytes.empty() && flip_case.picks.size() < most_flips) {
        flip_case.picks.push_back(bytes.pair());
    }
    return flip_case;
}

}  // namespace tightflip::fuzz
