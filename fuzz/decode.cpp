#include "decode.hpp"

#include <algorithm>

namespace tightflip::fuzz {
namespace {

class Bytes {
public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    std::uint32_t byte() {
        if (bytes_.empty()) return 0;
        const std::uint8_t value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value;
    }
    kernel::Index below(kernel::Index bound) { return static_cast<kernel::Index>(byte()) % bound; }

private:
    std::span<const std::uint8_t> bytes_;
};

}  // namespace

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
        const std::uint32_t low = bytes.byte();
        flip_case.picks.push_back(low + 256 * bytes.byte());
    }
    return flip_case;
}

}  // namespace tightflip::fuzz
