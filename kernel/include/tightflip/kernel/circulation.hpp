/// \file
/// Ranges over the halfedges met while turning about a vertex or walking round a face.
#pragma once

#include <tightflip/kernel/halfedge_table.hpp>

#include <cstddef>
#include <iterator>

namespace tightflip::kernel {

/// A forward range: from `start`, apply `Step` until it comes back, showing `Show` of each
/// halfedge. Constant time a step; valid until the surface is flipped.
template <class Step, class Show>
class Circulation {
public:
    class iterator {
    public:
        using value_type = decltype(Show{}(HalfedgeTable{}, Halfedge{}));
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::input_iterator_tag;
        using iterator_concept = std::forward_iterator_tag;

        constexpr iterator() noexcept = default;
        constexpr iterator(HalfedgeTable table, Halfedge current, bool ended) noexcept
            : table_(table), start_(current), current_(current), ended_(ended) {}

        constexpr value_type operator*() const noexcept { return Show{}(table_, current_); }
        constexpr iterator& operator++() noexcept {
            current_ = Step{}(table_, current_);
            ended_ = current_ == start_;
            return *this;
        }
        constexpr iterator operator++(int) noexcept {
            iterator before = *this;
            ++*this;
            return before;
        }
        friend constexpr bool operator==(const iterator& a, const iterator& b) noexcept {
            return a.current_ == b.current_ && a.ended_ == b.ended_;
        }

    private:
        HalfedgeTable table_;
        Halfedge start_;
        Halfedge current_;
        bool ended_ = false;
    };

    constexpr Circulation(HalfedgeTable table, Halfedge start) noexcept
        : table_(table), start_(start) {}
    [[nodiscard]] constexpr iterator begin() const noexcept { return {table_, start_, false}; }
    [[nodiscard]] constexpr iterator end() const noexcept { return {table_, start_, true}; }

private:
    HalfedgeTable table_;
    Halfedge start_;
};

namespace circulate {

/// To the next halfedge that leaves the same vertex, counter-clockwise seen from outside.
struct AboutVertex {
    constexpr Halfedge operator()(HalfedgeTable table, Halfedge h) const noexcept {
        return twin(at(table, at(table, h).next).next);
    }
};
/// To the next side of the same face.
struct AboutFace {
    constexpr Halfedge operator()(HalfedgeTable table, Halfedge h) const noexcept {
        return at(table, h).next;
    }
};

struct ShowHalfedge {
    constexpr Halfedge operator()(HalfedgeTable, Halfedge h) const noexcept { return h; }
};
struct ShowNext {
    constexpr Halfedge operator()(HalfedgeTable table, Halfedge h) const noexcept {
        return at(table, h).next;
    }
};
struct ShowTarget {
    constexpr Vertex operator()(HalfedgeTable table, Halfedge h) const noexcept {
        return at(table, twin(h)).origin;
    }
};
struct ShowOrigin {
    constexpr Vertex operator()(HalfedgeTable table, Halfedge h) const noexcept {
        return at(table, h).origin;
    }
};

}  // namespace circulate

/// The halfedges that leave a vertex: one for each face of its star.
using Star = Circulation<circulate::AboutVertex, circulate::ShowHalfedge>;
/// The sides of those faces that are opposite the vertex.
using Link = Circulation<circulate::AboutVertex, circulate::ShowNext>;
/// The other ends of its edges; a vertex joined by parallel edges comes once for each.
using Neighbours = Circulation<circulate::AboutVertex, circulate::ShowTarget>;
/// The three sides of a face.
using FaceSides = Circulation<circulate::AboutFace, circulate::ShowHalfedge>;
/// The three corners of a face.
using FaceCorners = Circulation<circulate::AboutFace, circulate::ShowOrigin>;

}  // namespace tightflip::kernel
