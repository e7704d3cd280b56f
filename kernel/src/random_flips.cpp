#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/random_flips.hpp>
#include <tightflip/kernel/simple_flip.hpp>

namespace tightflip::kernel {

std::vector<Edge> flip_at_random(Triangulation& surface, const RandomFlips& request) {
    const auto is_possible = [&](Edge e) {
        return request.simple ? can_flip_simply(surface.table(), e)
                              : static_cast<bool>(surface.can_flip(e));
    };
    const auto is_any_possible = [&] {
        for (Index e = 0; e < surface.edge_count(); ++e) {
            if (is_possible(Edge{e})) return true;
        }
        return false;
    };
    RandomStream random(request.seed);
    std::vector<Edge> flips;
    Index misses = 0;  // in a row
    while (static_cast<std::int64_t>(flips.size()) < request.count) {
        const Edge e{
            static_cast<Index>(random.below(static_cast<std::uint32_t>(surface.edge_count())))};
        if (is_possible(e)) {
            surface.flip(e);
            flips.push_back(e);
            misses = 0;
        } else if (++misses % surface.edge_count() == 0 && !is_any_possible()) {
            break;
        }
    }
    return flips;
}

}  // namespace tightflip::kernel
