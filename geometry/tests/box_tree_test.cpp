#include "box_tree.hpp"

#include "shapes.hpp"

#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using Pairs = std::multiset<std::pair<Index, Index>>;

std::vector<BoxTree::Item> random_items(kernel::RandomStream& random, Index count, int tags) {
    std::vector<BoxTree::Item> items;
    for (Index id = 0; id < count; ++id) {
        BoxTree::Item item{Box(random_grid_point(random, 8)), {}, id};
        item.box.extend(item.box.min() + random_grid_point(random, 2));
        for (Index& tag : item.tags) {
            tag = tags == 0
                      ? BoxTree::no_tag
                      : static_cast<Index>(random.below(static_cast<std::uint32_t>(tags))) - 1;
        }
        items.push_back(item);
    }
    return items;
}

Pairs pairs_by_definition(const std::vector<BoxTree::Item>& items) {
    Pairs pairs;
    for (const auto& a : items) {
        for (const auto& b : items) {
            if (a.id >= b.id || a.box.intersection(b.box).isEmpty()) continue;
            bool has_common_tag = false;
            for (const Index tag : a.tags) {
                for (const Index other : b.tags)
                    has_common_tag = has_common_tag || (tag == other && tag >= 0);
            }
            if (!has_common_tag) pairs.emplace(a.id, b.id);
        }
    }
    return pairs;
}

TEST(BoxTree, FindsEachPairOnce) {
    kernel::RandomStream random(6);
    BoxTree tree;
    for (const Index count : {0, 1, 40, 300}) {
        for (const int tags : {0, 2, 4, 50}) {
            tree.items() = random_items(random, count, tags);
            const Pairs expected = pairs_by_definition(tree.items());
            tree.build();
            Pairs found;
            EXPECT_FALSE(tree.any_pair([&](Index a, Index b) {
                found.emplace(std::min(a, b), std::max(a, b));
                return false;
            }));
            ASSERT_EQ(found, expected) << count << ' ' << tags;
            if (count == 300) {
                EXPECT_GT(found.size(), 50U);
            }
        }
    }
}

TEST(BoxTree, StopsWhenItIsEnough) {
    kernel::RandomStream random(7);
    BoxTree tree;
    tree.items() = random_items(random, 300, 0);
    tree.build();
    int calls = 0;
    EXPECT_TRUE(tree.any_pair([&](Index, Index) { return ++calls == 3; }));
    EXPECT_EQ(calls, 3);
}

TEST(BoxTree, PassesOverTheItemsOfOneTag) {
    BoxTree tree;
    for (Index id = 0; id < 200000; ++id) {  // 2 * 10^10 pairs of equal boxes
        tree.items().push_back({Box(Point::Zero()), {id, 3, 5}, id});
        tree.items().back().tags[0] = BoxTree::no_tag;
    }
    tree.build();
    EXPECT_FALSE(tree.any_pair([](Index, Index) { return true; }));
}

}  // namespace
}  // namespace tightflip::geometry
