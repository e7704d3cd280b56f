/// \file
/// The extended diagonal flip (EDF; Alboul et al., section 4.2.1) on a plain halfedge table.
///
/// On edge ab between the faces (a, b, c) and (b, a, d) the flip keeps `twin` and conjugates `next`
/// by one 4-cycle of halfedges; ab becomes the edge dc between the faces (d, c, a) and (c, d, b).
/// The four outer halfedges keep their edge, direction and origin, so every handle but the flipped
/// edge's own keeps its meaning.
///
/// All functions take constant time, never allocate, and work in constant expressions.
/// Precondition: `e` lies in the table and the table's two faces at `e` are triangles.
#pragma once

#include <tightflip/kernel/allowed_class.hpp>
#include <tightflip/kernel/halfedge_table.hpp>

#include <string_view>

namespace tightflip::kernel {

/// Why a flip is not defined. Values are stable.
enum class FlipRefusal : std::uint8_t {
    none = 0,
    opposite_corners_coincide = 1,  ///< c = d: the new edge would be a loop
};

/// A refusal in one line of plain words; empty for `none`.
[[nodiscard]] constexpr std::string_view describe(FlipRefusal refusal) noexcept {
    return refusal == FlipRefusal::none
               ? std::string_view{}
               : "the two corners opposite the edge are the same vertex: the new edge would be a "
                 "loop";
}

/// The answer of a flip: true when it is defined (and was done, where it was asked for).
class FlipVerdict {
public:
    constexpr FlipVerdict(FlipRefusal refusal) noexcept  // NOLINT(google-explicit-constructor)
        : refusal_(refusal) {}
    [[nodiscard]] constexpr explicit operator bool() const noexcept {
        return refusal_ == FlipRefusal::none;
    }
    [[nodiscard]] constexpr FlipRefusal refusal() const noexcept { return refusal_; }
    friend constexpr bool operator==(FlipVerdict, FlipVerdict) noexcept = default;

private:
    FlipRefusal refusal_;
};

/// The six halfedges of the two faces at an edge, named as the flip sees them:
/// h = ab, h1 = bc, h2 = ca and t = ba, t1 = ad, t2 = db.
struct Quadrilateral {
    Halfedge h, h1, h2, t, t1, t2;

    [[nodiscard]] static constexpr Quadrilateral around(HalfedgeTable table, Edge e) noexcept {
        const Halfedge h = halfedge_of(e);
        const Halfedge t = twin(h);
        const Halfedge h1 = at(table, h).next;
        const Halfedge t1 = at(table, t).next;
        return {h, h1, at(table, h1).next, t, t1, at(table, t1).next};
    }
};

namespace detail {
[[nodiscard]] constexpr FlipVerdict judge(HalfedgeTable table, const Quadrilateral& q) noexcept {
    return flip_keeps_corners_distinct(at(table, q.h2).origin, at(table, q.t2).origin)
               ? FlipRefusal::none
               : FlipRefusal::opposite_corners_coincide;
}
}  // namespace detail

/// Whether the EDF is defined on `e`, or why not.
[[nodiscard]] constexpr FlipVerdict can_flip(HalfedgeTable table, Edge e) noexcept {
    return detail::judge(table, Quadrilateral::around(table, e));
}

namespace detail {
/// Turns edge ab where that is allowed; `turned` becomes its side dc and twin(turned) its side cd.
/// The halfedges are plain locals and not a Quadrilateral: compilers keep these in registers.
[[nodiscard]] constexpr FlipVerdict turn_edge(MutableHalfedgeTable table, Edge e,
                                              Halfedge turned) noexcept {
    const Halfedge h = halfedge_of(e);
    const Halfedge t = twin(h);
    const Halfedge h1 = at(table, h).next;
    const Halfedge t1 = at(table, t).next;
    const Halfedge h2 = at(table, h1).next;
    const Halfedge t2 = at(table, t1).next;
    const Vertex c = at(table, h2).origin;
    const Vertex d = at(table, t2).origin;
    if (!flip_keeps_corners_distinct(c, d)) return FlipRefusal::opposite_corners_coincide;
    const Halfedge dc = turned;
    const Halfedge cd = twin(turned);
    at(table, dc).next = h2;
    at(table, dc).origin = d;
    at(table, cd).next = t2;
    at(table, cd).origin = c;
    at(table, h2).next = t1;
    at(table, t1).next = dc;
    at(table, t2).next = h1;
    at(table, h1).next = cd;
    return FlipRefusal::none;
}
}  // namespace detail

/// The EDF on `e`; where it is refused the table is unchanged. Four times is the identity; twice
/// exchanges the two halfedges of `e`.
constexpr FlipVerdict flip(MutableHalfedgeTable table, Edge e) noexcept {
    return detail::turn_edge(table, e, halfedge_of(e));
}

/// The exact inverse of `flip`, bit for bit; refused where the flip is, for then no flip led here.
constexpr FlipVerdict unflip(MutableHalfedgeTable table, Edge e) noexcept {
    return detail::turn_edge(table, e, twin(halfedge_of(e)));
}

}  // namespace tightflip::kernel
