/// \file
/// Paths of the tree in a hub form (hub_form.hpp), merged by slides: what sorts the pages of a book
/// into one path, and draws a tree out into one.
#pragma once

#include "hub_form.hpp"

#include <span>

namespace tightflip::kernel::hub_form {

/// The place of each vertex in an order, indexed by vertex.
using Ranks = std::vector<Index>;

/// Merges what hangs on u and on v, side by side, into one: the head of higher rank slides along
/// the lower one, behind its other edges, and the comparison goes on there until the lower one has
/// none. Two ascending paths of k vertices together become one ascending path in at most k - 1
/// slides. Returns the halfedge to the first vertex.
inline Halfedge merge(FlipTrail& trail, const Ranks& ranks, Fork fork) {
    const auto rank_of = [&](Halfedge h) {
        return ranks[static_cast<std::size_t>(target(trail.table(), h).id)];
    };
    Index rank_u = rank_of(fork.u);
    Index rank_v = rank_of(fork.v);
    const Halfedge head = rank_u < rank_v ? fork.u : fork.v;
    for (;;) {
        if (rank_u < rank_v) {
            const Edge passed = edge_of(fork.u);
            fork.v = slide_second(trail, fork);
            fork.u = clockwise(trail.table(), fork.v);
            if (edge_of(fork.u) == passed) return head;
            rank_u = rank_of(fork.u);
        } else {
            const Edge passed = edge_of(fork.v);
            fork.u = slide_first(trail, fork);
            fork.v = counter_clockwise(trail.table(), fork.u);
            if (edge_of(fork.v) == passed) return head;
            rank_v = rank_of(fork.v);
        }
    }
}

/// Merges neighbouring paths, given by their heads in counter-clockwise order, half by half: each
/// vertex takes part in at most ceil(log2 of their number) merges. (Half by half rather than level
/// by level: the small merges then work on what is in the cache.)
inline Halfedge merge_all(FlipTrail& trail, const Ranks& ranks, std::span<const Halfedge> heads) {
    if (heads.size() == 1) return heads.front();
    const std::size_t half = heads.size() / 2;
    const Halfedge first = merge_all(trail, ranks, heads.first(half));
    const Halfedge second = merge_all(trail, ranks, heads.subspan(half));
    return merge(trail, ranks, {first, second});
}

/// Cuts the pages into runs that ascend or descend and rolls each into an ascending path, one slide
/// a page but the first. Every run but perhaps the last has two pages or more. Returns the heads.
inline std::vector<Halfedge> roll_runs(FlipTrail& trail, const Ranks& ranks,
                                       std::span<const Halfedge> pages) {
    const auto ascends = [&](std::size_t k) {
        const auto rank = [&](Halfedge h) {
            return ranks[static_cast<std::size_t>(target(trail.table(), h).id)];
        };
        return rank(pages[k]) < rank(pages[k + 1]);
    };
    std::vector<Halfedge> heads;
    for (std::size_t begin = 0, end = 0; begin < pages.size(); begin = end) {
        end = begin + 1;
        if (end == pages.size()) {
            heads.push_back(pages[begin]);
            break;
        }
        const bool ascending = ascends(begin);
        while (end < pages.size() && ascends(end - 1) == ascending)
            ++end;
        // From the highest rank to the lowest: then each merge ends after its first slide.
        Halfedge head = ascending ? pages[end - 1] : pages[begin];
        for (std::size_t k = 1; k < end - begin; ++k) {
            head = merge(trail, ranks,
                         ascending ? Fork{pages[end - 1 - k], head} : Fork{head, pages[begin + k]});
        }
        heads.push_back(head);
    }
    return heads;
}

/// Sorts the pages of the book about the origin of `first`, counter-clockwise from it, into one
/// ascending path, by merging natural runs. With n pages in r runs, n - r slides roll the runs and
/// at most n ceil(log2 r) - (r - 1) merge them; as r <= ceil(n / 2) that is at most n ceil(log2 n)
/// in all. Returns the halfedge to the first vertex of the path.
inline Halfedge sort_pages(FlipTrail& trail, const Ranks& ranks, Halfedge first) {
    std::vector<Halfedge> pages;
    Halfedge page = first;
    do {
        pages.push_back(page);
        page = counter_clockwise(trail.table(), page);
    } while (page != first);
    return merge_all(trail, ranks, roll_runs(trail, ranks, pages));
}

/// A depth-first walk of the tree from the origin of `first`, counter-clockwise: the rank at which
/// each vertex is met (the root: 0), and the halfedge that led there, indexed by rank.
struct Walk {
    Ranks ranks;
    std::vector<Halfedge> descents;
};
inline Walk depth_first(HalfedgeTable table, Index vertex_count, Halfedge first) {
    Walk walk{Ranks(static_cast<std::size_t>(vertex_count), -1), {Halfedge{}}};
    const auto rank = [&](Vertex v) -> Index& {
        return walk.ranks[static_cast<std::size_t>(v.id)];
    };
    rank(at(table, first).origin) = 0;
    Halfedge h = first;
    do {
        if (rank(target(table, h)) < 0) {
            rank(target(table, h)) = static_cast<Index>(walk.descents.size());
            walk.descents.push_back(h);
        }
        h = counter_clockwise(table, twin(h));
    } while (h != first);
    return walk;
}

/// Draws a tree out into the path of its vertices in the walk's order. From the last vertex to the
/// first, one that has a brother before it slides, with the path that hangs on it, down the last
/// branch of that brother to the vertex before it in the order. Backwards these are the walk's
/// ascents: fewer slides than the tree has edges.
inline void draw_out(FlipTrail& trail, const Walk& walk) {
    const auto rank = [&](Vertex v) { return walk.ranks[static_cast<std::size_t>(v.id)]; };
    for (std::size_t k = walk.descents.size() - 1; k > 0; --k) {
        const Halfedge descent = walk.descents[k];
        const Halfedge before = clockwise(trail.table(), descent);
        const Index rank_before = rank(target(trail.table(), before));
        const bool is_brother = rank_before < static_cast<Index>(k) &&
                                rank_before > rank(at(trail.table(), descent).origin);
        if (is_brother) static_cast<void>(merge(trail, walk.ranks, {before, descent}));
    }
}

}  // namespace tightflip::kernel::hub_form
