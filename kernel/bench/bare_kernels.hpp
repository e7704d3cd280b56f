/// \file
/// Floors: the least that a flip has to do in four layouts of plain int32, with no handle and no
/// check. They flip whatever they are told, so they get only edges whose flip is legal.
#pragma once

#include "workload.hpp"

#include <numeric>
#include <utility>

namespace tightflip::kernel::bench {

using Raw = std::int32_t;

inline std::size_t place(Raw i) noexcept {
    return static_cast<std::size_t>(i);
}

/// Storage of `next` and `origin` for the kernels whose twin is implicit (h xor 1).
class RecordTable {
public:
    explicit RecordTable(std::size_t count) : records_(count) {}
    Raw& next(Raw h) noexcept { return records_[place(h)].next; }
    Raw& origin(Raw h) noexcept { return records_[place(h)].origin; }

private:
    struct Record {
        Raw next, origin;
    };
    std::vector<Record> records_;
};

class ArrayTable {
public:
    explicit ArrayTable(std::size_t count) : next_(count), origin_(count) {}
    Raw& next(Raw h) noexcept { return next_[place(h)]; }
    Raw& origin(Raw h) noexcept { return origin_[place(h)]; }

private:
    std::vector<Raw> next_, origin_;
};

/// Twin implicit, next stored: the layout of this library.
template <class Table>
class BareEdges {
public:
    explicit BareEdges(const Triangulation& start)
        : table_(start.table().size()), count_(start.halfedge_count()) {
        for (Raw h = 0; h < count_; ++h) {
            table_.next(h) = start.next({h}).id;
            table_.origin(h) = start.origin({h}).id;
        }
    }

    std::size_t flip_each(std::span<const Edge> edges) {
        for (const Edge e : edges)
            flip(2 * e.id);
        return edges.size();
    }
    [[nodiscard]] FaceList faces() {
        FaceList faces;
        for (Raw h = 0; h < count_; ++h) {
            const Raw n = table_.next(h);
            const Raw p = table_.next(n);
            if (h < n && h < p)
                faces.push_back({table_.origin(h), table_.origin(n), table_.origin(p)});
        }
        return faces;
    }

private:
    void flip(Raw h) noexcept {
        const Raw t = h ^ 1;
        const Raw h1 = table_.next(h), h2 = table_.next(h1);
        const Raw t1 = table_.next(t), t2 = table_.next(t1);
        table_.next(h) = h2;
        table_.next(t) = t2;
        table_.origin(h) = table_.origin(t2);
        table_.origin(t) = table_.origin(h2);
        table_.next(h2) = t1;
        table_.next(t1) = h;
        table_.next(t2) = h1;
        table_.next(h1) = t;
    }

    Table table_;
    Raw count_;
};

/// Storage of `twin` and `origin` for the kernels whose next is implicit in the face.
class FaceTable {
public:
    explicit FaceTable(std::size_t count) : faces_(count / 3) {}
    Raw& twin(Raw s) noexcept { return faces_[place(s / 3)].twin[s % 3]; }
    Raw& origin(Raw s) noexcept { return faces_[place(s / 3)].origin[s % 3]; }

private:
    struct Face {
        Raw twin[3], origin[3];
    };
    std::vector<Face> faces_;
};

class SideArrays {
public:
    explicit SideArrays(std::size_t count) : twin_(count), origin_(count) {}
    Raw& twin(Raw s) noexcept { return twin_[place(s)]; }
    Raw& origin(Raw s) noexcept { return origin_[place(s)]; }

private:
    std::vector<Raw> twin_, origin_;
};

/// Next implicit in the place (3 f + i), twin stored. The flip keeps four labels and moves the
/// flipped edge and two outer ones to other places, so an edge has no lasting name: the list of
/// edges is translated beforehand to the places where they will be at their turn.
template <class Table>
class BareFaces {
public:
    explicit BareFaces(const Triangulation& start)
        : table_(start.table().size()), count_(start.halfedge_count()), place_(places(start)) {
        for (Raw h = 0; h < count_; ++h) {
            table_.twin(place_[place(h)]) = place_[place(h ^ 1)];
            table_.origin(place_[place(h)]) = start.origin({h}).id;
        }
    }

    /// The places that edges will have when they are flipped in order.
    [[nodiscard]] std::vector<Edge> translated(std::span<const Edge> edges) const {
        BareFaces scratch = *this;
        std::vector<Raw> edge_at(place(count_));
        std::vector<Raw> place_of(place(count_ / 2));
        for (Raw h = 0; h < count_; ++h) {
            edge_at[place(place_[place(h)])] = h / 2;
            place_of[place(h / 2)] = place_[place(h)];
        }
        std::vector<Edge> result;
        result.reserve(edges.size());
        for (const Edge e : edges) {
            const Raw s = place_of[place(e.id)];
            const Raw t = scratch.table_.twin(s);
            const Raw s2 = previous(s), t2 = previous(t);
            result.push_back({s});
            scratch.flip(s);
            // The edges of s2 and t2 moved to t and s; the flipped one lies where they were.
            place_of[place(edge_at[place(s2)])] = t;
            place_of[place(edge_at[place(t2)])] = s;
            place_of[place(e.id)] = s2;
            edge_at[place(t)] = std::exchange(edge_at[place(s2)], e.id);
            edge_at[place(s)] = std::exchange(edge_at[place(t2)], e.id);
        }
        return result;
    }

    std::size_t flip_each(std::span<const Edge> places) {
        for (const Edge p : places)
            flip(p.id);
        return places.size();
    }
    [[nodiscard]] FaceList faces() {
        FaceList faces;
        for (Raw s = 0; s < count_; s += 3)
            faces.push_back({table_.origin(s), table_.origin(s + 1), table_.origin(s + 2)});
        return faces;
    }

private:
    static Raw next(Raw s) noexcept { return s % 3 == 2 ? s - 2 : s + 1; }
    static Raw previous(Raw s) noexcept { return s % 3 == 0 ? s + 2 : s - 1; }

    static std::vector<Raw> places(const Triangulation& surface) {
        std::vector<Raw> places(surface.table().size());
        Raw next_place = 0;
        for (const Halfedge h : surface.faces()) {
            for (const Halfedge side : surface.face_sides(h))
                places[place(side.id)] = next_place++;
        }
        return places;
    }

    void join(Raw s, Raw t) noexcept {
        table_.twin(s) = t;
        table_.twin(t) = s;
    }
    void flip(Raw s) noexcept {
        const Raw t = table_.twin(s);
        const Raw s2 = previous(s), t2 = previous(t);
        table_.origin(s) = table_.origin(t2);
        table_.origin(t) = table_.origin(s2);
        join(s, table_.twin(t2));
        join(t, table_.twin(s2));
        join(s2, t2);
    }

    Table table_;
    Raw count_;
    std::vector<Raw> place_;  // of a halfedge of the start
};

struct BareRecords : BareEdges<RecordTable> {
    static constexpr const char* name = "bare loop, records {next, origin}";
    using BareEdges::BareEdges;
};
struct BareArrays : BareEdges<ArrayTable> {
    static constexpr const char* name = "bare loop, arrays next and origin";
    using BareEdges::BareEdges;
};
struct BareFaceRecords : BareFaces<FaceTable> {
    static constexpr const char* name = "bare loop, face records {twin, origin}";
    using BareFaces::BareFaces;
};
struct BareSideArrays : BareFaces<SideArrays> {
    static constexpr const char* name = "bare loop, arrays twin and origin";
    using BareFaces::BareFaces;
};

}  // namespace tightflip::kernel::bench
