#include <tightflip/properties/simpler_cases.hpp>

#include <algorithm>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using testing::EndsWith;
using testing::StartsWith;

/// What a test framework does: the first simpler case that still fails, again and again.
template <class Case>
Case shrunk(Case failing, const std::function<bool(const Case&)>& fails) {
    for (int step = 0;; ++step) {
        EXPECT_LT(step, 100'000);
        const auto simpler = simpler_cases(failing);
        const auto next = std::ranges::find_if(simpler, fails);
        if (next == simpler.end()) return failing;
        failing = *next;
    }
}

FlipCase large(std::string_view kind) {
    return {.kind = find_start_kind(kind),
            .request = {.vertices = 25, .genus = 2, .seed = 77},
            .picks = {60000, 17, 3, 12, 44, 12, 31, 9, 12, 0, 5, 65535}};
}

TEST(SimplerFlipCases, LeadToTheTetrahedronWhereAnythingFails) {
    for (const StartKind& kind : start_kinds()) {
        EXPECT_EQ(
            describe(shrunk<FlipCase>(large(kind.name), [](const FlipCase&) { return true; })),
            describe(FlipCase{}));
    }
}

TEST(SimplerFlipCases, SaySizesAndPicksAsTheyAreUsed) {
    const FlipCase asked{.kind = find_start_kind("octasphere"),
                         .request = {.vertices = 65, .genus = 3, .seed = 0},
                         .picks = {1000}};
    ASSERT_EQ(asked.start().vertex_count(), 18);
    for (const FlipCase& simpler : simpler_cases(asked)) {
        EXPECT_LE(simpler.request.vertices, 18);
        EXPECT_EQ(simpler.request.genus, 0);
        for (const std::uint32_t pick : simpler.picks)
            EXPECT_LE(pick, 1000U % 48);
    }
}

TEST(SimplerFlipCases, OfTheSimplestAreNone) {
    EXPECT_TRUE(simpler_cases(FlipCase{}).empty());
}

TEST(SimplerFlipCases, KeepWhatMattersAndNothingElse) {
    struct Row {
        std::function<bool(const FlipCase&)> fails;
        const char* least;
    };
    for (const auto& [fails, least] :
         {Row{[](const FlipCase& c) { return c.start().genus() == 2; },
              "genus, V = 3, genus 2, seed 0, E = 15; flips none"},
          Row{[](const FlipCase& c) { return std::ranges::count(c.script(), Edge{4}) >= 2; },
              "tetrahedron, V = 4, genus 0, seed 0, E = 6; flips 4 4"},
          Row{[](const FlipCase& c) { return c.start().vertex_count() >= 13; },
              "book, V = 13, genus 0, seed 0, E = 33; flips none"},
          Row{[](const FlipCase& c) { return c.request.seed >= 50; },
              "tetrahedron, V = 4, genus 0, seed 50, E = 6; flips none"}}) {
        FlipCase start = large("genus");
        start.picks.insert(start.picks.end(), 3, 4);
        EXPECT_EQ(describe(shrunk<FlipCase>(start, fails)), least);
    }
}

TEST(SimplerSurfaceCases, SimplifyPointsToo) {
    SurfaceCase start{.flips = large("hub"), .point_kind = find_point_kind("wild")};
    const auto fails = [](const SurfaceCase& c) {
        return !c.script().empty() && c.start().point({3}).y() != 0;
    };
    for (start.point_seed = 0; !fails(start);)
        ++start.point_seed;
    const std::string least = describe(shrunk<SurfaceCase>(start, fails));
    EXPECT_THAT(least, StartsWith("tetrahedron, V = 4, genus 0, seed 0, E = 6; flips 0; points "));
    EXPECT_THAT(least, EndsWith("points 0 0 0, 0 0 0, 0 0 0, 0 1 0"));
}

}  // namespace
}  // namespace tightflip::properties
