#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/campaign.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

namespace families = kernel::families;

TEST(Campaign, FlipsTheEdgesThatItsSeedDraws) {
    for (const Triangulation& start : {families::tetrahedron(), families::random(20, 1, 3),
                                       families::random(5, 3, 1), families::book(3)}) {
        Triangulation surface = start;
        kernel::RandomStream random(42);
        std::uint64_t done = 0;
        for (int k = 0; k < 5000; ++k) {
            const auto edges = static_cast<std::uint32_t>(start.edge_count());
            if (surface.flip({static_cast<Index>(random.below(edges))})) ++done;
        }
        const CampaignReport report = run_campaign(start, {.flips = 5000, .seed = 42});
        EXPECT_FALSE(report.failure.has_value());
        EXPECT_FALSE(report.stopped_early);
        EXPECT_EQ(report.attempted, 5000U);
        EXPECT_EQ(report.done, done);
        EXPECT_EQ(report.refused, 5000U - done);
    }
}

TEST(Campaign, AuditsAtBothEndsAndAfterEveryMAttempts) {
    struct Row {
        std::uint64_t flips;
        std::uint64_t every;
        std::uint64_t audits;
    };
    const Triangulation start = families::random(8, 0, 1);  // 18 edges
    for (const auto& [flips, every, audits] :
         {Row{0, 10, 1}, Row{10, 10, 2}, Row{11, 10, 3}, Row{99, 10, 11}, Row{100, 10, 11},
          Row{5, 1, 6}, Row{1000, 1'000'000, 2}, Row{200'000, 70'000, 4}, Row{32 * 18 * 3, 0, 4},
          Row{32 * 18 * 3 + 1, 0, 5}}) {
        const CampaignReport report = run_campaign(start, {.flips = flips, .audit_every = every});
        EXPECT_EQ(report.audits, audits) << flips << " flips, audited every " << every;
        EXPECT_EQ(report.attempted, flips);
        EXPECT_FALSE(report.failure.has_value());
    }
}

TEST(Campaign, HoldsOnLargeSurfacesOfEveryGenusUpToThree) {
    for (Index genus = 0; genus <= 3; ++genus) {
        const CampaignReport report =
            run_campaign(families::surface_of_genus(genus, 20'000, 7),
                         {.flips = 500'000, .seed = 1, .audit_every = 100'000});
        EXPECT_FALSE(report.failure.has_value()) << "genus " << genus;
        EXPECT_GT(report.done, 250'000U);
        EXPECT_GT(report.refused, 0U);
    }
}

TEST(Campaign, StopsUndecidedAtTheTimeLimit) {
    const CampaignReport report = run_campaign(
        families::tetrahedron(),
        {.flips = std::uint64_t{1} << 60, .time_limit = std::chrono::duration<double>(0)});
    EXPECT_TRUE(report.stopped_early);
    EXPECT_EQ(report.attempted, 0U);
    EXPECT_FALSE(report.failure.has_value());
}

TEST(Campaign, StopsUndecidedWhenInterruptedAndAuditsWhatWasDone) {
    int asked = 0;
    const CampaignReport report =
        run_campaign(families::random(30, 2, 2), {.flips = std::uint64_t{1} << 60,
                                                  .audit_every = std::uint64_t{1} << 40,
                                                  .interrupted = [&] { return ++asked == 4; }});
    EXPECT_TRUE(report.stopped_early);
    EXPECT_EQ(asked, 4);
    EXPECT_GT(report.attempted, 0U);
    EXPECT_EQ(report.attempted, report.done + report.refused);
    EXPECT_EQ(report.audits, 2U);
    EXPECT_FALSE(report.failure.has_value());
}

TEST(Campaign, ReportsProgressThatOnlyGrows) {
    std::vector<std::uint64_t> seen;
    const CampaignReport report = run_campaign(
        families::tetrahedron(), {.flips = 1'000'000, .progress = [&](const CampaignProgress& p) {
                                      EXPECT_EQ(p.total, 1'000'000U);
                                      EXPECT_GE(p.seconds, 0);
                                      seen.push_back(p.attempted);
                                  }});
    EXPECT_GT(seen.size(), 2U);
    EXPECT_TRUE(std::ranges::is_sorted(seen));
    EXPECT_LE(seen.back(), report.attempted);
}

TEST(Campaign, LeavesItsStartAlone) {
    const Triangulation start = families::stacked(12, 4);
    const Triangulation copy = start;
    static_cast<void>(run_campaign(start, {.flips = 1000}));
    EXPECT_EQ(start, copy);
}

}  // namespace
}  // namespace tightflip::properties
