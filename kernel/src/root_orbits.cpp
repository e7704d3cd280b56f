#include <tightflip/kernel/root_orbits.hpp>

#include <algorithm>
#include <numeric>

namespace tightflip::kernel {

void RootOrbits::reset(std::span<const Root> roots, std::size_t halfedges) {
    roots_ = roots;
    place_.resize(2 * halfedges);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        place_[key(roots[i])] = static_cast<std::uint32_t>(i);
    }
    parent_.resize(roots.size());
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    image_.resize(halfedges);
}

void RootOrbits::add_generator(std::span<const Halfedge> from, std::span<const Halfedge> to,
                               bool reversing) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        image_[static_cast<std::size_t>(from[i].id)] = to[i];
    }
    for (std::size_t i = 0; i < roots_.size(); ++i) {
        const auto [halfedge, handedness] = roots_[i];
        const bool is_kept = (handedness == Handedness::kept) != reversing;
        const Root image{image_[static_cast<std::size_t>(halfedge.id)],
                         is_kept ? Handedness::kept : Handedness::mirrored};
        const std::size_t a = first_of_orbit(i);
        const std::size_t b = first_of_orbit(place_[key(image)]);
        parent_[std::max(a, b)] = static_cast<std::uint32_t>(std::min(a, b));
    }
}

std::size_t RootOrbits::first_of_orbit(std::size_t i) noexcept {
    while (parent_[i] != i) {
        parent_[i] = parent_[parent_[i]];  // halves the way for the next who asks
        i = parent_[i];
    }
    return i;
}

}  // namespace tightflip::kernel
