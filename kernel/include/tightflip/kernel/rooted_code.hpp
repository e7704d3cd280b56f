/// \file
/// A surface as a word: what a walk over its faces meets, from one halfedge on.
///
/// The walk numbers the sides of faces in the order of discovery: the face of the root gets 0, 1,
/// 2, and the sides are then visited in the order of their numbers. A side whose neighbour is new
/// says 0, and the three sides of the new face, from the one just crossed, get the next numbers; a
/// side glued to one with a greater number says that number; one glued to a smaller number says
/// nothing. That makes one symbol an edge, and the word determines the surface and its root up to
/// isomorphism. With labels, the labels of the three corners of the root's face come first and each
/// 0 is followed by the label of the new face's far corner.
///
/// (The idea that a rooted map has no symmetries, so that a walk from its root is a code, is
/// Weinberg's; IEEE Trans. Circuit Theory 13 (1966).)
#pragma once

#include <tightflip/kernel/halfedge_table.hpp>

#include <cstdint>
#include <vector>

namespace tightflip::kernel {

/// Whether vertex labels belong to what is coded.
enum class Labels : std::uint8_t { ignored, kept };

/// The surface as it is, or its mirror image: every face turned over in its place.
enum class Handedness : std::uint8_t { kept, mirrored };

/// Where a walk starts, and which of the two surfaces it walks on.
struct Root {
    Halfedge halfedge;
    Handedness handedness = Handedness::kept;

    friend constexpr bool operator==(Root, Root) noexcept = default;
};

/// Vertex a halfedge leaves on the surface or on its mirror image, where it runs the other way.
[[nodiscard]] constexpr Vertex origin(HalfedgeTable table, Root root) noexcept {
    return at(table, root.handedness == Handedness::kept ? root.halfedge : twin(root.halfedge))
        .origin;
}

/// The number of symbols of a code: one an edge and, with labels, one more for each corner of the
/// first face and each later face.
[[nodiscard]] constexpr std::size_t code_length(std::size_t halfedges, Labels labels) noexcept {
    return halfedges / 2 + (labels == Labels::kept ? halfedges / 3 + 2 : 0);
}

/// Walks surfaces; keeps its memory from walk to walk.
class RootedWalk {
public:
    /// Gives `accept` the symbols in turn, for as long as it returns true; returns whether the walk
    /// came to its end. Precondition: the table is a valid connected surface. Linear time.
    template <class Accept>
    bool operator()(HalfedgeTable table, Root root, Labels labels, Accept&& accept) {
        prepare(table.size());
        return root.handedness == Handedness::kept
                   ? walk<Handedness::kept>(table, root.halfedge, labels, accept)
                   : walk<Handedness::mirrored>(table, root.halfedge, labels, accept);
    }

    /// The halfedges in the order of discovery; all of them when the last walk came to its end.
    [[nodiscard]] std::span<const Halfedge> order() const noexcept {
        return {order_.data(), discovered_};
    }

private:
    void prepare(std::size_t size) {
        // Numbers of earlier walks lie below base_ and count as unknown; so nothing is cleared.
        base_ += discovered_;
        discovered_ = 0;
        if (number_.size() < size) {
            number_.assign(size, 0);
            order_.resize(size);
            base_ = 1;
        }
    }

    template <Handedness handedness>
    void discover_face(HalfedgeTable table, Halfedge first) {
        const Halfedge second = at(table, first).next;
        const Halfedge third = at(table, second).next;
        discover(first);
        discover(handedness == Handedness::kept ? second : third);
        discover(handedness == Handedness::kept ? third : second);
    }

    void discover(Halfedge h) {
        number_[static_cast<std::size_t>(h.id)] = base_ + discovered_;
        order_[discovered_++] = h;
    }

    template <Handedness handedness, class Accept>
    bool walk(HalfedgeTable table, Halfedge root, Labels labels, Accept&& accept) {
        discover_face<handedness>(table, root);
        if (labels == Labels::kept) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (!accept(origin(table, {order_[i], handedness}).id)) return false;
            }
        }
        for (std::size_t side = 0; side < table.size(); ++side) {
            const Halfedge neighbour = twin(order_[side]);
            const std::uint64_t number = number_[static_cast<std::size_t>(neighbour.id)];
            if (number < base_) {
                if (!accept(Index{0})) return false;
                discover_face<handedness>(table, neighbour);
                if (labels == Labels::kept &&
                    !accept(origin(table, {order_[discovered_ - 1], handedness}).id)) {
                    return false;
                }
            } else if (number - base_ > side) {
                if (!accept(static_cast<Index>(number - base_))) return false;
            }
        }
        return true;
    }

    std::vector<std::uint64_t> number_;  // a halfedge's place in order_, plus base_
    std::vector<Halfedge> order_;
    std::uint64_t base_ = 1;
    std::size_t discovered_ = 0;
};

}  // namespace tightflip::kernel
