/// \file
/// A surface on its way, with the flips done so far.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <stdexcept>
#include <utility>
#include <vector>

namespace tightflip::kernel {

/// Flips that theory says are defined: each is asked of the kernel, and a refusal is an error in
/// the program. (A RecordedSurface keeps its start too and takes refusals as they come.)
class FlipTrail {
public:
    explicit FlipTrail(Triangulation surface) : surface_(std::move(surface)) {}

    [[nodiscard]] const Triangulation& surface() const noexcept { return surface_; }
    [[nodiscard]] HalfedgeTable table() const noexcept { return surface_.table(); }
    [[nodiscard]] const std::vector<Edge>& flips() const noexcept { return flips_; }

    void reserve(std::size_t flips) { flips_.reserve(flips); }
    void flip(Edge e) {
        if (!surface_.flip(e)) throw std::logic_error("a flip was refused that theory allows");
        flips_.push_back(e);
    }
    [[nodiscard]] std::vector<Edge> take_flips() && { return std::move(flips_); }

private:
    Triangulation surface_;
    std::vector<Edge> flips_;
};

}  // namespace tightflip::kernel
