/// \file
/// The audit's yes, without its reasons: whether every rung of the ladder holds for a halfedge
/// table, in two passes over it. The full ladder names what is wrong; this says that nothing is.
///
/// Shares no code with the ladder, which stays the reference it is tested against. Usable in
/// constant expressions.
#pragma once

#include <tightflip/kernel/halfedge_table.hpp>

#include <array>
#include <vector>

namespace tightflip::kernel {
namespace detail {

/// Whether every halfedge lies in a triangle, joins two distinct vertices and runs against its
/// twin. All reads of one halfedge are independent of those of the others, and no branch but the
/// way out depends on them, so that many are under way at a time.
[[nodiscard]] constexpr bool faces_hold(HalfedgeTable table, Index vertex_count) noexcept {
    const auto count = static_cast<Index>(table.size());
    const auto exists = [&](Halfedge h) { return h.id >= 0 && h.id < count; };
    for (Index id = 0; id < count; ++id) {
        const Halfedge h{id};
        const auto [next, origin] = at(table, h);
        if (!exists(next) || origin.id < 0 || origin.id >= vertex_count) return false;
        const auto [previous, target] = at(table, next);
        if (!exists(previous) || at(table, previous).next != h) return false;
        if (origin == target || at(table, twin(h)).origin != target) return false;
    }
    return true;
}

/// Whether turning about vertices reaches every vertex from the first halfedge's, and every
/// halfedge: then the surface is connected and the faces at each vertex form one cycle.
/// Precondition: `faces_hold`. Several vertices are turned about side by side, for each turn is a
/// chain of reads that wait for one another.
[[nodiscard]] constexpr bool fans_hold(HalfedgeTable table, Index vertex_count) {
    struct Turn {
        Halfedge start, current;
    };
    std::vector<std::uint8_t> reached(static_cast<std::size_t>(vertex_count), 0);
    std::vector<Halfedge> queue(static_cast<std::size_t>(vertex_count) + 1);  // one a vertex
    std::size_t begin = 0;
    std::size_t end = 0;
    const auto reach = [&](Vertex v, Halfedge leaving) {  // no branch: which are new is random
        std::uint8_t& mark = reached[static_cast<std::size_t>(v.id)];
        queue[end] = leaving;
        end += mark == 0 ? 1 : 0;
        mark = 1;
    };
    reach(table[0].origin, Halfedge{0});

    std::array<Turn, 16> turns{};
    std::size_t turning = 0;
    std::size_t met = 0;
    while (true) {
        for (; turning < turns.size() && begin < end; ++begin)
            turns[turning++] = {queue[begin], queue[begin]};
        if (turning == 0) break;
        for (std::size_t i = turning; i-- > 0;) {
            Turn& turn = turns[i];
            const auto [next, target] = at(table, twin(turn.current));
            reach(target, twin(turn.current));
            turn.current = next;
            ++met;
            if (turn.current == turn.start) turn = turns[--turning];
        }
    }
    return met == table.size() && end == reached.size();
}

}  // namespace detail

/// Whether a table passes the audit, believing nothing. Linear time, two passes over the table,
/// 5 bytes of scratch a vertex.
[[nodiscard]] constexpr bool passes_audit(HalfedgeTable table, Index vertex_count) {
    const bool counts_are_possible = !table.empty() && table.size() % 2 == 0 && vertex_count > 0 &&
                                     static_cast<std::size_t>(vertex_count) <= table.size();
    // Two rungs follow from the others. Orientability: both halfedges of every edge run against
    // one another. The three-neighbour rule: three coinciding neighbours make a component of two
    // faces, which is its named exception.
    return counts_are_possible && detail::faces_hold(table, vertex_count) &&
           detail::fans_hold(table, vertex_count);
}

}  // namespace tightflip::kernel
