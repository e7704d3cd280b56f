// Flips with a fault each, to be put into the kernel that this directory compiles.
#pragma once

#include <tightflip/kernel/flip.hpp>

namespace tightflip::broken {

using kernel::Edge;
using kernel::FlipVerdict;
using kernel::HalfedgeTable;
using kernel::MutableHalfedgeTable;

using CanFlip = FlipVerdict (*)(HalfedgeTable, Edge);
using Flip = FlipVerdict (*)(MutableHalfedgeTable, Edge);

/// Of the flip's steps one is wrong.
FlipVerdict wrong_origin(MutableHalfedgeTable table, Edge e);
FlipVerdict missing_next(MutableHalfedgeTable table, Edge e);

/// The flip says the wrong thing.
FlipVerdict never_refused(MutableHalfedgeTable table, Edge e);
FlipVerdict always_refused(MutableHalfedgeTable table, Edge e);
FlipVerdict nothing_done(MutableHalfedgeTable table, Edge e);
FlipVerdict cannot_flip(HalfedgeTable table, Edge e);

/// A flip, but not the one that is asked for.
FlipVerdict turned_forwards(MutableHalfedgeTable table, Edge e);
FlipVerdict turned_backwards(MutableHalfedgeTable table, Edge e);

/// What the kernel calls while this lives; a null pointer: its own. Calls of `flip` are counted,
/// and the first `sound_calls` of them are sound.
class BrokenKernel {
public:
    struct Calls {
        Flip flip = nullptr;
        Flip unflip = nullptr;
        CanFlip can_flip = nullptr;
        int sound_calls = 0;
    };
    explicit BrokenKernel(Calls calls);
    ~BrokenKernel();
    BrokenKernel(const BrokenKernel&) = delete;
    BrokenKernel& operator=(const BrokenKernel&) = delete;
};

}  // namespace tightflip::broken
