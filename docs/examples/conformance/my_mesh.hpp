// A small mesh as somebody might have written it: half-edges in one array.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

class MyMesh {
public:
    struct HalfEdge {
        int next, twin, origin;
    };

    explicit MyMesh(const std::vector<std::array<int, 3>>& triangles) {
        std::map<std::pair<int, int>, int> by_ends;
        for (const auto& corners : triangles) {
            const int first = static_cast<int>(halfedges.size());
            for (int i = 0; i < 3; ++i) {
                const auto from = corners[static_cast<std::size_t>(i)];
                const auto to = corners[static_cast<std::size_t>((i + 1) % 3)];
                by_ends[{from, to}] = first + i;
                halfedges.push_back({first + (i + 1) % 3, -1, from});
            }
        }
        for (const auto& [ends, h] : by_ends)
            at(h).twin = by_ends.at({ends.second, ends.first});
    }

    /// Whether the flipped edge would join vertices that no edge joins yet.
    bool can_flip(int h) const {
        const int c = at(previous(h)).origin;
        const int d = at(previous(at(h).twin)).origin;
        if (c == d) return false;
#ifndef MY_MESH_FORGETS_PARALLEL_EDGES
        for (const HalfEdge& other : halfedges) {
            if (other.origin == c && at(other.twin).origin == d) return false;
        }
#endif
        return true;
    }

    void flip(int h) {
        const int t = at(h).twin;
        const int h1 = at(h).next, h2 = previous(h), t1 = at(t).next, t2 = previous(t);
        at(h) = {h2, t, at(t2).origin};
        at(t) = {t2, h, at(h2).origin};
        at(h2).next = t1;
        at(t1).next = h;
        at(t2).next = h1;
        at(h1).next = t;
    }

    bool is_valid() const {
        std::map<std::pair<int, int>, int> edges;
        for (const HalfEdge& h : halfedges) {
            const HalfEdge& twin = at(h.twin);
            if (at(at(at(h.next).next).next).next != h.next) return false;
            if (&at(twin.twin) != &h || at(h.next).origin != twin.origin) return false;
            if (++edges[{h.origin, twin.origin}] > 1) return false;
        }
        return true;
    }

    HalfEdge& at(int h) {
        return halfedges[static_cast<std::size_t>(h)];
    }
    const HalfEdge& at(int h) const {
        return halfedges[static_cast<std::size_t>(h)];
    }
    int previous(int h) const {
        return at(at(h).next).next;
    }

    std::vector<HalfEdge> halfedges;
};
