#include "disguises.hpp"
#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <cmath>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using testing::mirrored;
using testing::with_labels;

/// What is wrong with the path between two surfaces; empty where it is as promised.
std::string objection(const Triangulation& from, const Triangulation& to) {
    const ConnectResult found = connect(from, to);
    if (!found) return "refused: " + std::string(describe(found.refusal));
    const FlipLog& path = *found.path;
    if (path.start != from) return "the path starts elsewhere";
    const Replay replayed = replay(path);
    if (!replayed.is_complete()) {
        return "flip " + std::to_string(replayed.done) + ": " + replayed.reason;
    }
    if (!same_labelled_surface(replayed.surface, to)) return "the path ends elsewhere";
    if (static_cast<std::int64_t>(path.flips.size()) > connect_bound(from.vertex_count())) {
        return std::to_string(path.flips.size()) + " flips, more than the bound";
    }
    return {};
}

/// Every labelled sphere that flips reach from the book, each once.
std::vector<Triangulation> labelled_spheres(Index vertices) {
    std::vector<Triangulation> found{families::book(vertices)};
    std::multimap<std::uint64_t, std::size_t> by_hash{{surface_hash(found.front()), 0}};
    const auto is_known = [&](const Triangulation& surface) {
        const auto [begin, end] = by_hash.equal_range(surface_hash(surface));
        return std::any_of(begin, end, [&](const auto& entry) {
            return same_labelled_surface(surface, found[entry.second]);
        });
    };
    for (std::size_t k = 0; k < found.size(); ++k) {
        for (Index e = 0; e < found[k].edge_count(); ++e) {
            Triangulation next = found[k];
            if (!next.flip({e}) || is_known(next)) continue;
            by_hash.emplace(surface_hash(next), found.size());
            found.push_back(std::move(next));
        }
    }
    return found;
}

Triangulation randomly_labelled(const Triangulation& surface, std::uint64_t seed) {
    RandomStream random(seed);
    return testing::relabelled(surface, random);
}

Triangulation with_labels_reversed(const Triangulation& surface) {
    std::vector<Index> labels(static_cast<std::size_t>(surface.vertex_count()));
    std::iota(labels.rbegin(), labels.rend(), 0);
    return with_labels(surface, labels);
}

TEST(Connect, JoinsAnyTwoLabelledSpheresOfFourOrFiveVertices) {
    for (const auto& [vertices, count] : {std::pair{4, 8U}, std::pair{5, 160U}}) {
        const auto spheres = labelled_spheres(vertices);
        ASSERT_EQ(spheres.size(), count);
        for (std::size_t a = 0; a < spheres.size(); ++a) {
            for (std::size_t b = 0; b < spheres.size(); ++b) {
                ASSERT_EQ(objection(spheres[a], spheres[b]), "")
                    << vertices << ": " << a << ", " << b;
            }
        }
    }
}

TEST(Connect, JoinsEveryLabelledSphereOfSixVerticesToSome) {
    const auto spheres = labelled_spheres(6);
    ASSERT_EQ(spheres.size(), 5280U);
    for (std::size_t a = 0; a < spheres.size(); ++a) {
        const std::size_t b = (37 * a + 11) % spheres.size();
        ASSERT_EQ(objection(spheres[a], spheres[b]), "") << a << ", " << b;
        ASSERT_EQ(objection(spheres[b], spheres[a]), "") << b << ", " << a;
    }
}

TEST(Connect, JoinsExtremeSpheresUnderAnyLabels) {
    for (const Index vertices : {6, 7, 8, 13, 64, 200}) {
        const std::vector<Triangulation> shapes{
            families::book(vertices), families::double_wheel(vertices),
            families::stacked(vertices, 3), families::random(vertices, 0, 4)};
        std::vector<Triangulation> spheres;
        for (std::size_t k = 0; k < shapes.size(); ++k) {
            spheres.push_back(shapes[k]);
            spheres.push_back(mirrored(shapes[k]));
            spheres.push_back(with_labels_reversed(shapes[k]));
            spheres.push_back(randomly_labelled(shapes[k], k));
        }
        for (std::size_t a = 0; a < spheres.size(); ++a) {
            for (std::size_t b = 0; b < spheres.size(); ++b) {
                EXPECT_EQ(objection(spheres[a], spheres[b]), "")
                    << vertices << ": " << a << ", " << b;
            }
        }
    }
}

TEST(Connect, JoinsLargeSpheres) {
    constexpr Index vertices = 100'000;
    EXPECT_EQ(objection(families::random(vertices, 0, 1), families::random(vertices, 0, 2)), "");
    EXPECT_EQ(objection(families::book(vertices), randomly_labelled(families::book(vertices), 5)),
              "");
}

TEST(Connect, NeedsNoFlipsBetweenEqualSurfaces) {
    const Triangulation sphere = families::random(50, 0, 9);
    EXPECT_EQ(connect(sphere, sphere).value().flips, std::vector<Edge>{});
    RandomStream random(3);
    const Triangulation renumbered = testing::renumbered(sphere, random);
    ASSERT_NE(renumbered, sphere);
    EXPECT_EQ(connect(sphere, renumbered).value().flips, std::vector<Edge>{});
    EXPECT_EQ(connect(sphere, renumbered).value().start, sphere);
}

TEST(Connect, KnowsTheOneSphereOfThreeVertices) {
    const Triangulation sphere = families::book(3);
    const ConnectResult found = connect(sphere, mirrored(sphere));
    ASSERT_TRUE(found);
    EXPECT_TRUE(found.path->flips.empty());
}

TEST(Connect, TakesLinearlyManyFlipsWherePagesStandInOrderOrInReverse) {
    constexpr Index vertices = 5000;
    const Triangulation book = families::book(vertices);
    EXPECT_LE(connect(book, mirrored(book)).value().flips.size(), std::size_t{12 * vertices});
    // Two pages exchanged, all others in order.
    std::vector<Index> labels(static_cast<std::size_t>(vertices));
    std::iota(labels.begin(), labels.end(), 0);
    std::swap(labels[100], labels[101]);
    const auto swapped = connect(book, with_labels(book, labels));
    EXPECT_LE(swapped.value().flips.size(), std::size_t{12 * vertices});
}

// Vertices 0 and 1 are hubs of the one book, 1 and 2 of the other: at the common one nothing needs
// to be gathered, at another 2 V - 6 flips are needed for that alone.
TEST(Connect, GathersWhereBothEndsHaveLeastToGather) {
    constexpr Index vertices = 100;
    const Triangulation book = families::book(vertices);
    std::vector<Index> labels(static_cast<std::size_t>(vertices));
    std::iota(labels.begin(), labels.end(), 0);
    std::swap(labels[0], labels[2]);
    const Triangulation other = with_labels(book, labels);
    EXPECT_LE(connect(book, other).value().flips.size(), std::size_t{4 * vertices});
    EXPECT_LE(connect(other, book).value().flips.size(), std::size_t{4 * vertices});
}

TEST(ConnectBound, IsTheFormulaOfItsDocumentation) {
    const std::map<Index, std::int64_t> by_hand{
        {3, 0}, {4, 12}, {5, 28}, {6, 40}, {7, 62}, {10, 104}, {11, 136}, {1'000'000, 47'999'896}};
    for (const auto& [vertices, bound] : by_hand)
        EXPECT_EQ(connect_bound(vertices), bound) << vertices;
    EXPECT_GT(connect_bound(500'000'000), 28'000'000'000);
}

TEST(ConnectBound, StaysBelowThreeVLogVPlusTwelveV) {
    for (Index vertices = 3; vertices < 100'000; ++vertices) {
        const double v = vertices;
        EXPECT_LE(static_cast<double>(connect_bound(vertices)), 3 * v * std::log2(v) + 12 * v);
    }
}

TEST(ConnectRefusal, SaysWhyThereIsNoPath) {
    const Triangulation sphere = families::random(20, 0, 1);
    struct Case {
        Triangulation from, to;
        ConnectRefusal refusal;
        int code;
        std::string word;
    };
    const std::vector<Case> cases{
        {sphere, families::random(21, 0, 1), ConnectRefusal::different_vertex_counts, 1,
         "numbers of vertices"},
        {sphere, families::random(21, 1, 1), ConnectRefusal::different_vertex_counts, 1,
         "numbers of vertices"},
        {sphere, families::random(20, 1, 1), ConnectRefusal::different_genus, 2, "genus"},
        {families::random(20, 1, 1), families::random(20, 1, 2), ConnectRefusal::not_a_sphere, 3,
         "sphere"}};
    for (const auto& [from, to, refusal, code, word] : cases) {
        const ConnectResult found = connect(from, to);
        EXPECT_FALSE(found);
        EXPECT_EQ(found.refusal, refusal);
        EXPECT_EQ(static_cast<int>(found.refusal), code);
        EXPECT_THAT(std::string(describe(refusal)), ::testing::HasSubstr(word));
        try {
            static_cast<void>(found.value());
            ADD_FAILURE() << "a refusal has no value";
        } catch (const std::invalid_argument& error) {
            EXPECT_EQ(error.what(), describe(refusal));
        }
    }
    EXPECT_EQ(describe(ConnectRefusal::none), "");
}

}  // namespace
}  // namespace tightflip::kernel
