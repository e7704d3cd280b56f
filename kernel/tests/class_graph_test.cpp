#include "disguises.hpp"
#include "temporary_directory.hpp"
#include <tightflip/kernel/class_graph.hpp>
#include <tightflip/kernel/counting.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <map>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::HasSubstr;

ClassGraph explored(const Triangulation& start, ClassRules rules = {},
                    const ExplorationLimits& limits = {}) {
    return explore_classes(std::span(&start, 1), rules, limits);
}

void expect_equal(const ClassGraph& a, const ClassGraph& b) {
    EXPECT_EQ(a.codes, b.codes);
    EXPECT_EQ(a.symmetries, b.symmetries);
    EXPECT_EQ(a.arcs.offsets, b.arcs.offsets);
    EXPECT_EQ(a.arcs.targets, b.arcs.targets);
    EXPECT_EQ(a.relabellings, b.relabellings);
}

constexpr ClassRules identified{
    .mirror = Mirror::identified, .simple_only = false, .keep_relabellings = false};
constexpr ClassRules with_relabellings{
    .mirror = Mirror::distinct, .simple_only = false, .keep_relabellings = true};

TEST(ExploreClasses, FindsAsManyClassesOfTheSphereAsAreKnown) {
    const std::map<Index, std::size_t> oriented{{3, 1}, {4, 2}, {5, 4}, {6, 14}, {7, 66}, {8, 409}};
    for (const auto& [vertices, classes] : oriented) {
        const ClassGraph graph = explored(families::book(vertices));
        EXPECT_EQ(graph.size(), classes);
        EXPECT_EQ(graph.rooted_count(), rooted_spheres(vertices));
    }
    const std::map<Index, std::size_t> with_mirrors{{4, 2}, {5, 4}, {6, 14}, {7, 54}, {8, 291}};
    for (const auto& [vertices, classes] : with_mirrors) {
        const ClassGraph graph = explored(families::book(vertices), identified);
        EXPECT_EQ(graph.size(), classes);
        EXPECT_EQ(graph.rooted_count(), rooted_spheres(vertices));
    }
}

TEST(ExploreClasses, FindsAllSimpleSpheresByTheClassicalFlip) {
    // OEIS A000109 by V.
    const std::map<Index, std::size_t> simple{{4, 1}, {5, 1}, {6, 2}, {7, 5}, {8, 14}, {9, 50}};
    for (const auto& [vertices, classes] : simple) {
        const ClassGraph graph = explored(
            families::stacked(vertices, 3),
            {.mirror = Mirror::identified, .simple_only = true, .keep_relabellings = false});
        EXPECT_EQ(graph.size(), classes);
        EXPECT_EQ(graph.rooted_count(), rooted_simple_spheres(vertices));
        for (std::size_t i = 0; i < graph.size(); ++i) {
            EXPECT_EQ(audit(graph.surface(i)).is_simple(), true);
        }
    }
}

TEST(ExploreClasses, DependsOnNeitherStartNorThreads) {
    ExplorationLimits one;
    one.threads = 1;
    ExplorationLimits three;
    three.threads = 3;
    const ClassGraph graph = explored(families::book(8), with_relabellings, one);
    expect_equal(graph, explored(families::book(8), with_relabellings, three));
    expect_equal(graph, explored(families::double_wheel(8), with_relabellings, three));
}

TEST(ExploreClasses, HasAnArcForEachLegalFlip) {
    const ClassGraph graph = explored(families::book(7));
    for (std::size_t i = 0; i < graph.size(); ++i) {
        std::multiset<std::size_t> reached;
        const Triangulation surface = graph.surface(i);
        for (Index e = 0; e < surface.edge_count(); ++e) {
            Triangulation flipped = surface;
            if (flipped.flip({e})) reached.insert(graph.find(flipped));
        }
        const auto row = graph.arcs.row(i);
        EXPECT_EQ(reached, std::multiset<std::size_t>(row.begin(), row.end()));
    }
}

/// Between two orbits of labelled surfaces there are as many edges seen from either side.
TEST(ExploreClasses, ArcsBalanceWithSymmetries) {
    for (const ClassRules rules : {ClassRules{}, identified}) {
        const ClassGraph graph = explored(families::book(7), rules);
        for (std::uint32_t a = 0; a < graph.size(); ++a) {
            for (const std::uint32_t b : graph.arcs.row(a)) {
                const auto there = std::ranges::count(graph.arcs.row(a), b);
                const auto back = std::ranges::count(graph.arcs.row(b), a);
                EXPECT_EQ(there * graph.symmetries[b], back * graph.symmetries[a]);
            }
        }
    }
}

TEST(ExploreClasses, RelabellingsSayWhereVerticesGo) {
    for (const Triangulation& start : {families::book(6), families::surface_of_genus(1, 4, 0)}) {
        const ClassGraph graph = explored(start, with_relabellings);
        std::size_t arc = 0;
        for (std::size_t i = 0; i < graph.size(); ++i) {
            const Triangulation surface = graph.surface(i);
            for (Index e = 0; e < surface.edge_count(); ++e) {
                Triangulation flipped = surface;
                if (!flipped.flip({e})) continue;
                const auto to = graph.relabelling(arc);
                const Triangulation renamed =
                    testing::with_labels(flipped, std::vector<Index>(to.begin(), to.end()));
                EXPECT_TRUE(same_labelled_surface(renamed, graph.surface(graph.arcs.targets[arc])));
                ++arc;
            }
        }
        EXPECT_EQ(arc, graph.arcs.targets.size());
    }
}

TEST(ExploreClasses, StatesArePlanarAsBoyerAndMyrvoldSee) {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
    const ClassGraph graph = explored(families::book(8));
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const Triangulation surface = graph.surface(i);
        Graph skeleton(8);
        for (Index e = 0; e < surface.edge_count(); ++e) {
            const Halfedge h = halfedge_of(Edge{e});
            boost::add_edge(static_cast<std::size_t>(surface.origin(h).id),
                            static_cast<std::size_t>(surface.target(h).id), skeleton);
        }
        EXPECT_TRUE(boost::boyer_myrvold_planarity_test(skeleton));
    }
}

TEST(ClassGraph, FindsEachStateAndNothingElse) {
    const ClassGraph graph = explored(families::book(7), identified);
    RandomStream random(5);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const Triangulation surface = graph.surface(i);
        EXPECT_EQ(graph.find(testing::mirrored(testing::renumbered(surface, random))), i);
    }
    EXPECT_EQ(graph.find(families::book(8)), graph.size());
    const ClassGraph simple = explored(families::stacked(7, 0), {Mirror::identified, true, false});
    EXPECT_EQ(simple.find(families::book(7)), simple.size());
}

TEST(ExploreClasses, TakesSeveralStartsTogether) {
    const std::vector<Triangulation> both{families::book(5), families::double_wheel(5)};
    EXPECT_EQ(explore_classes(both, {}).size(), 4U);
    const std::vector<Triangulation> unequal{families::book(5), families::book(6)};
    EXPECT_THROW(static_cast<void>(explore_classes(unequal, {})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(explore_classes({}, {})), std::invalid_argument);
}

TEST(ExploreClasses, RefusesStartsThatTheRulesExclude) {
    EXPECT_THROW(static_cast<void>(explored(families::book(6), {Mirror::distinct, true, false})),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(explored(families::book(60))), std::invalid_argument);
}

TEST(ExploreClasses, KeepsToTheMemoryLimit) {
    ExplorationLimits limits;
    limits.memory_bytes = 1 << 10;
    try {
        static_cast<void>(explored(families::book(8), {}, limits));
        FAIL();
    } catch (const ExplorationStopped& stopped) {
        EXPECT_EQ(stopped.reason(), ExplorationStopped::Reason::memory);
        EXPECT_THAT(stopped.what(), HasSubstr("limit"));
    }
}

class ExploreClassesCheckpoint : public ::testing::Test {
protected:
    ExploreClassesCheckpoint() {
        limits.checkpoint_directory = directory.path();
        limits.threads = 2;
    }
    /// Stops after some rounds of the run.
    void interrupt_after(int rounds) {
        limits.interrupted = [rounds]() mutable { return rounds-- == 0; };
        try {
            static_cast<void>(explored(start, with_relabellings, limits));
            FAIL() << "the run ended before it could be interrupted";
        } catch (const ExplorationStopped& stopped) {
            EXPECT_EQ(stopped.reason(), ExplorationStopped::Reason::interrupted);
        }
        limits.interrupted = nullptr;
    }

    testing::TemporaryDirectory directory;
    std::filesystem::path file = directory / "classes.checkpoint";
    ExplorationLimits limits;
    Triangulation start = families::book(9);
};

TEST_F(ExploreClassesCheckpoint, AnInterruptedRunGoesOnToTheSameEnd) {
    interrupt_after(3);
    interrupt_after(1);
    std::uint64_t taken_over = 0;
    limits.progress = [&](const ExplorationProgress& p) { taken_over = p.done_before; };
    const ClassGraph resumed = explored(start, with_relabellings, limits);
    EXPECT_GT(taken_over, 0U);
    EXPECT_EQ(resumed.size(), 3078U);
    expect_equal(resumed, explored(start, with_relabellings));
}

TEST_F(ExploreClassesCheckpoint, AFinishedRunIsTakenAsItIs) {
    const ClassGraph graph = explored(start, {}, limits);
    bool has_worked = false;
    limits.progress = [&](const ExplorationProgress&) { has_worked = true; };
    expect_equal(graph, explored(start, {}, limits));
    EXPECT_FALSE(has_worked);
}

TEST_F(ExploreClassesCheckpoint, OtherParametersAreRefused) {
    interrupt_after(1);
    const std::string before = read_file(file);
    EXPECT_THROW(static_cast<void>(explored(start, {}, limits)), FileError);
    EXPECT_THROW(static_cast<void>(explored(families::book(8), with_relabellings, limits)),
                 FileError);
    EXPECT_EQ(read_file(file), before);
}

TEST_F(ExploreClassesCheckpoint, DamageIsRefusedAndLeftAsItIs) {
    interrupt_after(3);
    const std::string kept = read_file(file);
    for (std::size_t i = 0; i < kept.size(); i += 3) {
        std::string damaged = kept;
        damaged[i] ^= 4;
        write_file(file, [&](std::ostream& out) { out << damaged; });
        EXPECT_THROW(static_cast<void>(explored(start, with_relabellings, limits)), FileError)
            << "byte " << i;
        EXPECT_EQ(read_file(file), damaged);
    }
}

}  // namespace
}  // namespace tightflip::kernel
