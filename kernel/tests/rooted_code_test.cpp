#include "disguises.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/families.hpp>

#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::ElementsAre;

constexpr Root first_root{Halfedge{0}};

std::vector<Triangulation> samples() {
    return {
        families::book(3),          families::tetrahedron(),    families::book(6),
        families::double_wheel(7),  families::torus_grid(3, 4), families::surface_of_genus(2, 3, 0),
        families::random(12, 0, 1), families::random(9, 1, 2),  families::random(7, 3, 3)};
}

TEST(RootedCode, SpellsSmallSurfacesAsTheRuleSays) {
    const Triangulation sphere = build(testing::two_face_sphere()).value();
    EXPECT_THAT(rooted_code(sphere, first_root, Labels::ignored), ElementsAre(0, 5, 4));
    EXPECT_THAT(rooted_code(sphere, first_root, Labels::kept), ElementsAre(0, 1, 2, 0, 2, 5, 4));

    // Faces 012, then across its sides 103, 213, 023: the sides 03 and 30 have numbers 4 and 11,
    // 31 and 13 have 5 and 7, 32 and 23 have 8 and 10.
    const Triangulation tetrahedron = build(testing::tetrahedron()).value();
    EXPECT_THAT(rooted_code(tetrahedron, first_root, Labels::ignored),
                ElementsAre(0, 0, 0, 11, 7, 10));
    EXPECT_THAT(rooted_code(tetrahedron, first_root, Labels::kept),
                ElementsAre(0, 1, 2, 0, 3, 0, 3, 0, 3, 11, 7, 10));
}

TEST(RootedCode, HasTheLengthThatIsPromised) {
    for (const Triangulation& surface : samples()) {
        for (const Labels labels : {Labels::ignored, Labels::kept}) {
            EXPECT_EQ(rooted_code(surface, first_root, labels).size(),
                      code_length(surface.table().size(), labels));
        }
    }
}

TEST(RootedCode, OfAMirroredRootIsThatOfTheMirrorImage) {
    for (const Triangulation& surface : samples()) {
        const Triangulation image = testing::mirrored(surface);
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            for (const Labels labels : {Labels::ignored, Labels::kept}) {
                EXPECT_EQ(rooted_code(surface, {{h}, Handedness::mirrored}, labels),
                          rooted_code(image, {{h}, Handedness::kept}, labels))
                    << "root " << h;
            }
        }
    }
}

TEST(RootedCode, LabelsComeInTheOrderOfTheWalk) {
    const Triangulation surface = families::random(12, 0, 1);
    const auto labelled = rooted_code(surface, first_root, Labels::kept);
    EXPECT_EQ(labelled[0], surface.origin({0}).id);
    EXPECT_EQ(labelled[1], surface.target({0}).id);
    EXPECT_EQ(labelled[2], surface.opposite({0}).id);
    EXPECT_EQ(labelled[3], 0);
    EXPECT_EQ(labelled[4], surface.opposite(twin(Halfedge{0})).id);
}

TEST(RootedCode, NeedsARootThatExists) {
    const Triangulation surface = families::tetrahedron();
    EXPECT_THROW(static_cast<void>(rooted_code(surface, {Halfedge{12}}, Labels::ignored)),
                 std::out_of_range);
    EXPECT_THROW(static_cast<void>(rooted_code(surface, {Halfedge{}}, Labels::ignored)),
                 std::out_of_range);
}

TEST(RootedWalk, StopsWhereItIsToldAndForgetsWhatItMet) {
    RootedWalk walk;
    const std::vector<Triangulation> surfaces = samples();
    for (const std::size_t limit : {0U, 1U, 4U}) {
        for (const Triangulation& surface : surfaces) {
            std::size_t symbols = 0;
            EXPECT_EQ(walk(surface.table(), first_root, Labels::ignored,
                           [&](Index) { return symbols++ < limit; }),
                      limit >= code_length(surface.table().size(), Labels::ignored));
            EXPECT_LE(symbols, limit + 1);

            std::vector<Index> word;
            EXPECT_TRUE(walk(surface.table(), first_root, Labels::ignored, [&](Index symbol) {
                word.push_back(symbol);
                return true;
            }));
            EXPECT_EQ(word, rooted_code(surface, first_root, Labels::ignored));
            EXPECT_EQ(walk.order().size(), surface.table().size());
        }
    }
}

}  // namespace
}  // namespace tightflip::kernel
