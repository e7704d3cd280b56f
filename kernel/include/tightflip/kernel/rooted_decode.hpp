/// \file
/// From the word of a rooted walk back to the surface: the inverse of rooted_code.hpp.
#pragma once

#include <tightflip/kernel/rooted_code.hpp>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace tightflip::kernel {

namespace detail {

/// Reads a code into a table of twice the size it needs: entry `side` of the upper half keeps, in
/// `next`, the halfedge that the side is.
class SideTable {
public:
    explicit SideTable(std::vector<HalfedgeRecord>& records, std::size_t sides)
        : records_(&records), sides_(sides) {
        records.assign(2 * sides, HalfedgeRecord{});
    }

    [[nodiscard]] std::size_t size() const noexcept { return sides_; }
    [[nodiscard]] Halfedge& halfedge(std::size_t side) const noexcept {
        return (*records_)[sides_ + side].next;
    }

    /// Gives every halfedge its `next`, and numbers the vertices in the order in which the walk
    /// meets them; returns how many there are. Precondition: all sides are glued.
    [[nodiscard]] Index finish() const {
        HalfedgeRecord* const records = records_->data();
        for (std::size_t side = 0; side < sides_; ++side) {
            const std::size_t next = side % 3 == 2 ? side - 2 : side + 1;
            records[static_cast<std::size_t>(halfedge(side).id)].next = halfedge(next);
        }
        const MutableHalfedgeTable table(records, sides_);
        Index vertices = 0;
        for (std::size_t side = 0; side < sides_; ++side) {
            Halfedge h = halfedge(side);
            if (at(table, h).origin.is_valid()) continue;
            for (; !at(table, h).origin.is_valid(); h = twin(at(table, at(table, h).next).next)) {
                at(table, h).origin = {vertices};
            }
            ++vertices;
        }
        records_->resize(sides_);
        return vertices;
    }

private:
    std::vector<HalfedgeRecord>* records_;
    std::size_t sides_;
};

}  // namespace detail

/// The surface whose rooted code without labels is `code`, in `records`; returns the number of its
/// vertices. Linear time; allocates only where `records` grows, to twice the halfedges.
///
/// The k-th symbol speaks of edge k: halfedge 2k is the side that says it and 2k + 1 the side it is
/// glued to, so the root is halfedge 0. Vertices are numbered in the order in which the walk meets
/// them: the root leaves vertex 0 for vertex 1. What comes out is closed, connected and oriented;
/// that edges are no loops only the audit knows. Throws std::invalid_argument where no walk spells
/// the word, and then leaves `records` as no table.
template <class Symbol>
Index decode(std::span<const Symbol> code, std::vector<HalfedgeRecord>& records) {
    const auto require = [](bool holds, const char* reason) {
        if (!holds) throw std::invalid_argument(reason);
    };
    require(!code.empty() && code.size() % 3 == 0, "the code of a closed surface has 3n symbols");
    require(code.size() < std::size_t{1} << 29, "the code is longer than tables can be");
    const detail::SideTable sides(records, 2 * code.size());
    std::size_t discovered = 3;
    Index halfedge = 0;
    auto symbol = code.begin();
    for (std::size_t side = 0; side < discovered; ++side) {
        if (sides.halfedge(side).is_valid()) continue;
        require(symbol != code.end(), "the code ends while sides are open");
        auto other = static_cast<std::size_t>(*symbol++);
        if (other == 0) {
            other = discovered;
            discovered += 3;
            require(discovered <= sides.size(), "the code has more faces than its length allows");
        }
        require(other > side && other < discovered && !sides.halfedge(other).is_valid(),
                "the code glues a side to one that is not open");
        sides.halfedge(side) = {halfedge};
        sides.halfedge(other) = {halfedge + 1};
        halfedge += 2;
    }
    require(symbol == code.end(), "the code goes on after the last side");
    return sides.finish();
}

}  // namespace tightflip::kernel
