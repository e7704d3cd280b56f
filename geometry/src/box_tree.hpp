/// \file
/// Pairs among many boxes that meet.
#pragma once

#include "cone_box.hpp"
#include <tightflip/geometry/surface.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tightflip::geometry {

/// Boxes in a balanced binary tree, split at the median along the longest side of their middles.
///
/// An item has up to three tags, and items with a common tag make no pair. A node knows which tags
/// all its items have, so that the items about one tag (the faces at a vertex of high degree, whose
/// boxes all meet) are passed over together. Where the tags are corners and their points are known,
/// such a node is bounded by the hull of that corner and a box of the others, so that the faces
/// about two such vertices are told apart as well.
class BoxTree {
public:
    static constexpr Index no_tag = -1;
    using Tags = std::array<Index, 3>;

    struct Item {
        Box box;
        Tags tags{no_tag, no_tag, no_tag};
        Index id = 0;
    };

    /// What to fill before `build`, and what it reorders.
    [[nodiscard]] std::vector<Item>& items() noexcept { return items_; }

    /// O(n log n) for n items; allocates only where n is larger than ever before. With points, each
    /// item is the hull of those of its tags.
    void build(Points points = {}) {
        points_ = points;
        nodes_.clear();
        if (!items_.empty()) build(0, items_.size());
    }

    /// Calls `is_enough(id, id)` once for each pair of items whose boxes meet and that have no tag
    /// in common, until it returns true; returns whether it did. O((n + k) log n) for k pairs of
    /// boxes that meet, for boxes of bounded shape and overlap.
    template <class IsEnough>
    [[nodiscard]] bool any_pair(const IsEnough& is_enough) const {
        return !nodes_.empty() && any_pair_in(0, is_enough);
    }

private:
    static constexpr std::size_t leaf_size = 4;

    struct Node {
        Box box;
        Tags tags;
        std::size_t begin;
        std::size_t end;
        std::size_t right;  ///< the second child; the first is the next node; 0 for a leaf
        bool is_cone;       ///< whether the bound is better than the box
        ConeBox bound;
    };

    [[nodiscard]] static bool has(const Tags& tags, Index tag) {
        return std::ranges::find(tags, tag) != tags.end();
    }
    template <class T, class U>
    [[nodiscard]] static bool may_pair(const T& a, const U& b) {
        return a.box.intersects(b.box) && std::ranges::none_of(a.tags, [&](Index tag) {
                   return tag != no_tag && has(b.tags, tag);
               });
    }

    std::size_t build(std::size_t begin, std::size_t end) {
        Node node{items_[begin].box, items_[begin].tags, begin, end, 0, false, {}};
        Box middles;
        for (std::size_t i = begin; i < end; ++i) {
            middles.extend(ConeBox::middle(items_[i].box));
            node.box.extend(items_[i].box);
            for (Index& tag : node.tags) {
                if (!has(items_[i].tags, tag)) tag = no_tag;
            }
        }
        bound(node);
        const std::size_t place = nodes_.size();
        nodes_.push_back(node);
        if (end - begin <= leaf_size) return place;
        Eigen::Index axis = 0;
        (middles.max() * 0.5 - middles.min() * 0.5).maxCoeff(&axis);
        const std::size_t middle = begin + (end - begin) / 2;
        const auto first = items_.begin();
        std::nth_element(
            first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(middle),
            first + static_cast<std::ptrdiff_t>(end), [axis](const Item& a, const Item& b) {
                return a.box.min()[axis] + a.box.max()[axis] <
                       b.box.min()[axis] + b.box.max()[axis];
            });
        build(begin, middle);
        nodes_[place].right = build(middle, end);
        return place;
    }

    /// By the hull of a common corner and the others, where there is one.
    void bound(Node& node) const {
        node.bound = ConeBox::of(node.box);
        const auto common =
            std::ranges::find_if(node.tags, [](Index tag) { return tag != no_tag; });
        if (points_.empty() || common == node.tags.end()) return;
        node.is_cone = true;
        node.bound = {points_[static_cast<std::size_t>(*common)], {}};
        for (std::size_t i = node.begin; i < node.end; ++i) {
            for (const Index tag : items_[i].tags) {
                if (tag != *common) node.bound.far.extend(points_[static_cast<std::size_t>(tag)]);
            }
        }
    }

    [[nodiscard]] static bool may_pair_between(const Node& a, const Node& b) {
        return may_pair(a, b) && !((a.is_cone || b.is_cone) && are_separated(a.bound, b.bound));
    }

    template <class IsEnough>
    bool any_pair_in(std::size_t place, const IsEnough& is_enough) const {
        const Node& node = nodes_[place];
        if (node.tags != Tags{no_tag, no_tag, no_tag})
            return false;  // all items have one in common
        if (node.right != 0) {
            return any_pair_in(place + 1, is_enough) || any_pair_in(node.right, is_enough) ||
                   any_pair_between(place + 1, node.right, is_enough);
        }
        for (std::size_t i = node.begin; i < node.end; ++i) {
            for (std::size_t j = i + 1; j < node.end; ++j) {
                if (may_pair(items_[i], items_[j]) && is_enough(items_[i].id, items_[j].id)) {
                    return true;
                }
            }
        }
        return false;
    }

    template <class IsEnough>
    bool any_pair_between(std::size_t a, std::size_t b, const IsEnough& is_enough) const {
        const Node& left = nodes_[a];
        const Node& right = nodes_[b];
        if (!may_pair_between(left, right)) return false;
        if (left.right == 0 && right.right == 0) return any_pair_of_leaves(left, right, is_enough);
        if (right.right == 0 ||
            (left.right != 0 && left.end - left.begin > right.end - right.begin)) {
            return any_pair_between(a + 1, b, is_enough) ||
                   any_pair_between(left.right, b, is_enough);
        }
        return any_pair_between(a, b + 1, is_enough) || any_pair_between(a, right.right, is_enough);
    }

    template <class IsEnough>
    bool any_pair_of_leaves(const Node& left, const Node& right, const IsEnough& is_enough) const {
        for (std::size_t i = left.begin; i < left.end; ++i) {
            if (!may_pair(items_[i], right)) continue;
            for (std::size_t j = right.begin; j < right.end; ++j) {
                if (may_pair(items_[i], items_[j]) && is_enough(items_[i].id, items_[j].id)) {
                    return true;
                }
            }
        }
        return false;
    }

    std::vector<Item> items_;
    std::vector<Node> nodes_;
    Points points_;
};

}  // namespace tightflip::geometry
