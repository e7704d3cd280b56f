#include <tightflip/kernel/explore.hpp>
#include <tightflip/kernel/families.hpp>

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::HasSubstr;

Exploration explored(States states, Index vertices, Index genus = 0, bool simple_only = false) {
    return explore({.vertices = vertices,
                    .genus = genus,
                    .states = states,
                    .simple_only = simple_only,
                    .distances = DistanceEffort::extremes});
}

struct Row {
    Index vertices;
    std::uint64_t states;
    Distance diameter;
};

/// Whether all that exist are found, connected, and as far apart as is known.
void expect_as_known(States kind, const Row& row) {
    SCOPED_TRACE(row.vertices);
    const Exploration result = explored(kind, row.vertices);
    EXPECT_EQ(result.states, row.states);
    EXPECT_EQ(result.expected.states, row.states);
    EXPECT_EQ(result.is_complete(), true);
    EXPECT_EQ(result.components, 1U);
    ASSERT_TRUE(result.eccentricities);
    EXPECT_EQ(result.eccentricities->diameter, row.diameter);
    EXPECT_EQ(result.min_degree, static_cast<std::size_t>(row.vertices) - 2);
    EXPECT_EQ(result.max_degree, 3 * (static_cast<std::size_t>(row.vertices) - 2));
}

TEST(Explore, ClassesOfTheSphereWithMirrorImagesIdentified) {
    for (const Row& row : {Row{4, 2, 1}, Row{5, 4, 2}, Row{6, 14, 4}, Row{7, 54, 7}}) {
        expect_as_known(States::mirror_classes, row);
    }
}

TEST(Explore, LabelledSpheres) {
    for (const Row& row : {Row{4, 8, 2}, Row{5, 160, 6}, Row{6, 5280, 10}, Row{7, 244608, 15}}) {
        expect_as_known(States::labelled, row);
    }
}

TEST(Explore, AllLabelledSpheresOfEightVerticesAreConnected) {
    const Exploration result = explore({.vertices = 8,
                                        .genus = 0,
                                        .states = States::labelled,
                                        .simple_only = false,
                                        .distances = DistanceEffort::none});
    EXPECT_EQ(result.states, 14622720U);
    EXPECT_EQ(result.expected.states, 14622720U);
    EXPECT_EQ(result.components, 1U);
    EXPECT_FALSE(result.eccentricities);
}

TEST(Explore, TheBookIsPeripheral) {
    const Exploration result = explored(States::classes, 7);
    const auto book = static_cast<std::uint32_t>(result.classes.find(families::book(7)));
    EXPECT_THAT(result.eccentricities->peripheral(), ::testing::Contains(book));
}

TEST(Explore, ArcsAreTheLegalFlipsOfAllStates) {
    const Exploration classes = explored(States::classes, 6);
    EXPECT_EQ(classes.arcs, classes.classes.arcs.targets.size());
    const Exploration labelled = explored(States::labelled, 4);
    // Two labelled tetrahedra with six flips each, six surfaces of the other class with two.
    EXPECT_EQ(labelled.arcs, 2U * 6 + 6U * 2);
}

TEST(Explore, TheTorusIsConnectedForFewVertices) {
    for (const auto& [vertices, states] :
         {std::pair<Index, std::uint64_t>{3, 1}, {4, 7}, {5, 65}}) {
        const Exploration result = explored(States::classes, vertices, 1);
        EXPECT_EQ(result.states, states);
        EXPECT_EQ(result.components, 1U);
        EXPECT_EQ(result.is_complete(), true);
    }
    EXPECT_EQ(explored(States::classes, 4, 1).expected.rooted, 51U);
    EXPECT_EQ(explored(States::classes, 5, 1).expected.rooted, 1413U);
}

/// The theorem is about the sphere: no flip is defined where there are three vertices.
TEST(Explore, ThreeVerticesOnHigherGenusAreIsolatedClasses) {
    for (const auto& [genus, states] : {std::pair<Index, std::uint64_t>{2, 2}, {3, 10}}) {
        const Exploration result = explored(States::classes, 3, genus);
        EXPECT_EQ(result.states, states);
        EXPECT_EQ(result.components, states);
        EXPECT_EQ(result.arcs, 0U);
        EXPECT_FALSE(result.eccentricities);
        EXPECT_EQ(explored(States::labelled, 3, genus).components,
                  explored(States::labelled, 3, genus).states);
    }
}

TEST(Explore, SimpleGraphsUnderTheClassicalFlip) {
    const Exploration result = explored(States::mirror_classes, 8, 0, true);
    EXPECT_EQ(result.states, 14U);
    EXPECT_EQ(result.is_complete(), true);
    EXPECT_EQ(result.components, 1U);
    // The torus of seven vertices: one class, and no flip keeps it simple.
    const Exploration torus = explored(States::mirror_classes, 7, 1, true);
    EXPECT_EQ(torus.states, 1U);
    EXPECT_EQ(torus.arcs, 0U);
}

TEST(Explore, StatesOfClassesAddUp) {
    const Exploration result = explored(States::labelled, 6);
    EXPECT_EQ(std::accumulate(result.states_of_class.begin(), result.states_of_class.end(),
                              std::uint64_t{0}),
              5280U);
    EXPECT_EQ(result.levels.front().total(), 5280U);
}

TEST(Explore, EveryEccentricityWhereAskedFor) {
    const Exploration result = explore({.vertices = 7,
                                        .genus = 0,
                                        .states = States::classes,
                                        .simple_only = false,
                                        .distances = DistanceEffort::all});
    const auto counts = result.eccentricities->counts();
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), 66U);
}

TEST(Explore, CompletenessIsAMatterOfRootedSurfaces) {
    Exploration result;
    result.rooted = 3;
    EXPECT_EQ(result.is_complete(), std::nullopt);
    result.expected.rooted = 4;
    EXPECT_EQ(result.is_complete(), false);
    result.rooted = 4;
    EXPECT_EQ(result.is_complete(), true);
}

TEST(Explore, RefusesSizesThatNoModeHolds) {
    EXPECT_THROW(static_cast<void>(explored(States::classes, 2)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(explored(States::classes, 4, -1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(explored(States::classes, 100)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(explored(States::labelled, 12)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(explored(States::classes, 3, 0, true)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(explored(States::classes, 5, 1, true)), std::invalid_argument);
}

TEST(Explore, SaysWhatMemoryItWouldNeedBeforeItStarts) {
    ExplorationLimits limits;
    limits.memory_bytes = std::uint64_t{1} << 30;
    bool has_worked = false;
    limits.progress = [&](const ExplorationProgress&) { has_worked = true; };
    try {
        static_cast<void>(explore({.vertices = 10,
                                   .genus = 0,
                                   .states = States::labelled,
                                   .simple_only = false,
                                   .distances = DistanceEffort::none},
                                  limits));
        FAIL();
    } catch (const ExplorationStopped& stopped) {
        EXPECT_EQ(stopped.reason(), ExplorationStopped::Reason::memory);
        EXPECT_THAT(stopped.what(), HasSubstr("needs about"));
        EXPECT_THAT(stopped.what(), HasSubstr("1024 MiB"));
    }
    EXPECT_FALSE(has_worked);
}

TEST(Explore, ProgressKnowsWhatToExpect) {
    ExplorationLimits limits;
    std::uint64_t classes = 0;
    std::uint64_t labelled = 0;
    limits.progress = [&](const ExplorationProgress& p) {
        EXPECT_LE(p.done, p.expected);
        (std::string_view(p.stage) == "classes" ? classes : labelled) = p.done;
    };
    static_cast<void>(explore({.vertices = 6,
                               .genus = 0,
                               .states = States::labelled,
                               .simple_only = false,
                               .distances = DistanceEffort::none},
                              limits));
    EXPECT_EQ(classes, 14U);
    EXPECT_EQ(labelled, 5280U);
}

}  // namespace
}  // namespace tightflip::kernel
