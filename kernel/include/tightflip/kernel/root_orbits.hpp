/// \file
/// Which of a list of roots are known to be alike: orbits under the automorphisms found so far.
#pragma once

#include <tightflip/kernel/rooted_code.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace tightflip::kernel {

/// The partition of a list of roots into orbits of a group that grows one generator at a time.
/// The list must be closed under all automorphisms that are added.
class RootOrbits {
public:
    /// Every root is an orbit of its own. Linear in the table and the list.
    void reset(std::span<const Root> roots, std::size_t halfedges);

    /// Adds the automorphism that sends from[i] to to[i], two lists of all halfedges; `reversing`
    /// where it turns the surface over. Linear time (but for the inverse Ackermann function).
    void add_generator(std::span<const Halfedge> from, std::span<const Halfedge> to,
                       bool reversing);

    /// The first root in the list that is in the orbit of the i-th.
    [[nodiscard]] std::size_t first_of_orbit(std::size_t i) noexcept;

private:
    static std::size_t key(Root root) noexcept {
        return 2 * static_cast<std::size_t>(root.halfedge.id) +
               (root.handedness == Handedness::kept ? 0 : 1);
    }

    std::span<const Root> roots_;
    std::vector<std::uint32_t> place_;   // of a root in the list, by its key
    std::vector<std::uint32_t> parent_;  // union-find; the least place stands for an orbit
    std::vector<Halfedge> image_;
};

}  // namespace tightflip::kernel
