/// \file
/// The numbers that a walk gives to vertices.
#pragma once

#include <tightflip/kernel/rooted_code.hpp>

namespace tightflip::kernel {

/// Numbers the vertices in the order in which the walk from `root` meets them, as `decode` does
/// with the walk's code: numbers[v] for v < vertices. Linear time.
template <class Number>
void number_vertices(RootedWalk& walk, HalfedgeTable table, Root root, Index vertices,
                     std::vector<Number>& numbers) {
    walk(table, root, Labels::ignored, [](Index) { return true; });
    constexpr auto unknown = static_cast<Number>(~Number{0});
    numbers.assign(static_cast<std::size_t>(vertices), unknown);
    Number count = 0;
    for (const Halfedge h : walk.order()) {
        Number& number = numbers[static_cast<std::size_t>(origin(table, {h, root.handedness}).id)];
        if (number == unknown) number = count++;
    }
}

}  // namespace tightflip::kernel
