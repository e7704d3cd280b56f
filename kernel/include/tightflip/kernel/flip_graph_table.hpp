/// \file
/// A finite graph in compressed rows: what an explored flip graph is kept as.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tightflip::kernel {

/// The arcs that leave state s go to targets[offsets[s]] .. targets[offsets[s + 1] - 1]. Each arc
/// is a legal flip: an edge of the flip graph is there from both its ends, parallel arcs and arcs
/// from a state to itself where two flips lead to isomorphic surfaces.
struct FlipGraphTable {
    std::vector<std::uint64_t> offsets{0};
    std::vector<std::uint32_t> targets;

    [[nodiscard]] std::size_t size() const noexcept { return offsets.size() - 1; }
    [[nodiscard]] std::size_t degree(std::size_t state) const noexcept {
        return static_cast<std::size_t>(offsets[state + 1] - offsets[state]);
    }
    [[nodiscard]] std::span<const std::uint32_t> row(std::size_t state) const noexcept {
        return {targets.data() + offsets[state], degree(state)};
    }
};

}  // namespace tightflip::kernel
