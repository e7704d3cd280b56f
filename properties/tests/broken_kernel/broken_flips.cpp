#include "broken_flips.hpp"

namespace tightflip::broken {
namespace {

using kernel::Halfedge;
using kernel::Quadrilateral;
using kernel::Vertex;

Flip broken_flip = nullptr;
int sound_calls = 0;

FlipVerdict broken_in_the_end(MutableHalfedgeTable table, Edge e) {
    if (sound_calls == 0) return broken_flip(table, e);
    --sound_calls;
    return turned_forwards(table, e);
}

}  // namespace

FlipVerdict turned_forwards(MutableHalfedgeTable table, Edge e) {
    return kernel::detail::turn_edge(table, e, halfedge_of(e));
}

FlipVerdict turned_backwards(MutableHalfedgeTable table, Edge e) {
    return kernel::detail::turn_edge(table, e, twin(halfedge_of(e)));
}

FlipVerdict wrong_origin(MutableHalfedgeTable table, Edge e) {
    const FlipVerdict verdict = turned_forwards(table, e);
    const Halfedge dc = halfedge_of(e);
    if (verdict) at(table, dc).origin = at(table, twin(dc)).origin;
    return verdict;
}

FlipVerdict missing_next(MutableHalfedgeTable table, Edge e) {
    const Quadrilateral q = Quadrilateral::around(table, e);
    const FlipVerdict verdict = turned_forwards(table, e);
    if (verdict) at(table, q.t1).next = q.t2;
    return verdict;
}

FlipVerdict never_refused(MutableHalfedgeTable table, Edge e) {
    const Quadrilateral q = Quadrilateral::around(table, e);
    const Vertex d = at(table, q.t2).origin;
    if (at(table, q.h2).origin != d) return turned_forwards(table, e);
    at(table, q.t2).origin = {d.id + 1};  // another name for the while of the flip
    const FlipVerdict verdict = turned_forwards(table, e);
    at(table, q.t2).origin = d;
    at(table, q.h).origin = d;
    return verdict;
}

FlipVerdict always_refused(MutableHalfedgeTable /*table*/, Edge /*e*/) {
    return kernel::FlipRefusal::opposite_corners_coincide;
}

FlipVerdict nothing_done(MutableHalfedgeTable /*table*/, Edge /*e*/) {
    return kernel::FlipRefusal::none;
}

FlipVerdict cannot_flip(HalfedgeTable /*table*/, Edge /*e*/) {
    return kernel::FlipRefusal::opposite_corners_coincide;
}

BrokenKernel::BrokenKernel(Calls calls) {
    broken_flip = calls.flip;
    sound_calls = calls.sound_calls;
    kernel::replaced::flip = calls.flip != nullptr ? broken_in_the_end : nullptr;
    kernel::replaced::unflip = calls.unflip;
    kernel::replaced::can_flip = calls.can_flip;
}

BrokenKernel::~BrokenKernel() {
    kernel::replaced::flip = nullptr;
    kernel::replaced::unflip = nullptr;
    kernel::replaced::can_flip = nullptr;
}

}  // namespace tightflip::broken
