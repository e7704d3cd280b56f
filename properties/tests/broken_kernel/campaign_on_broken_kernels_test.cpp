// The campaign finds broken flips, makes what it found small, and leaves a log that shows it again.

#include "broken_flips.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/campaign.hpp>
#include <tightflip/properties/claims.hpp>

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using broken::BrokenKernel;
using kernel::Edge;
using kernel::FlipLog;
using kernel::Triangulation;

/// Whether a finding about the surface as it is, not about the flip, is one that the audit has too.
bool is_confirmed(const Finding& finding, const FlipLog& log) {
    if (finding.violation.code >= kernel::ViolationCode::vertex_count_changed) return true;
    Triangulation surface = log.start;
    for (const Edge e : log.flips)
        static_cast<void>(surface.flip(e));
    const auto violations = audit(surface).violations;
    return std::ranges::find(violations, finding.violation) != violations.end();
}

struct NamedFlip {
    const char* name;
    broken::Flip flip;
};

class CampaignOnBrokenKernels : public testing::TestWithParam<NamedFlip> {};

TEST_P(CampaignOnBrokenKernels, FindsTheFaultAndLeavesAShortLogThatShowsIt) {
    constexpr std::size_t most_flips = 4;
    for (const kernel::Index genus : {0, 1, 2}) {
        SCOPED_TRACE("genus " + std::to_string(genus));
        const auto start = kernel::families::surface_of_genus(genus, 60, 3);
        const BrokenKernel broken({.flip = GetParam().flip});
        const CampaignReport report = run_campaign(start, {.flips = 100'000, .seed = 1});
        ASSERT_TRUE(report.failure.has_value());
        const CampaignFailure& failure = *report.failure;
        EXPECT_EQ(report.attempted, failure.attempt) << "it went on after the fault";
        EXPECT_LE(failure.log.flips.size(), most_flips);
        EXPECT_EQ(failure.log.start.genus(), start.genus());

        std::ostringstream written;
        write_text(written, failure.log);
        const FlipLog log = kernel::parse_flip_log(written.str(), "log");
        const auto again = topology_is_preserved(log.start, log.flips);
        ASSERT_TRUE(again.has_value()) << "replaying the log does not show the fault";
        EXPECT_EQ(again->step, log.flips.size()) << "the log goes on after the fault";
        EXPECT_TRUE(is_confirmed(*again, log)) << describe(*again);
    }
}

INSTANTIATE_TEST_SUITE_P(, CampaignOnBrokenKernels,
                         testing::Values(NamedFlip{"wrong_origin", broken::wrong_origin},
                                         NamedFlip{"missing_next", broken::missing_next},
                                         NamedFlip{"never_refused", broken::never_refused},
                                         NamedFlip{"always_refused", broken::always_refused}),
                         [](const auto& test) { return std::string(test.param.name); });

constexpr Edge far_edge{100};

broken::FlipVerdict wrong_at_the_far_edge(kernel::MutableHalfedgeTable table, Edge e) {
    return e == far_edge ? broken::wrong_origin(table, e) : broken::turned_forwards(table, e);
}

// Small surfaces have no such edge, so the script is made again from the last good audit on.
TEST(CampaignOnBrokenKernel, ShrinksWhatCameSinceTheLastAuditWhereSmallSurfacesShowNothing) {
    const auto start = kernel::families::surface_of_genus(0, 60, 3);
    const BrokenKernel broken({.flip = wrong_at_the_far_edge});
    int after_an_audit = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        constexpr std::uint64_t audit_every = 50;
        const auto report =
            run_campaign(start, {.flips = 100'000, .seed = seed, .audit_every = audit_every});
        ASSERT_TRUE(report.failure.has_value());
        const FlipLog& log = report.failure->log;
        EXPECT_EQ(log.start.vertex_count(), 60);
        // At times another flip must come first, before which that of the edge is refused.
        EXPECT_LE(log.flips.size(), 2U) << "seed " << seed;
        EXPECT_EQ(log.flips.back(), far_edge) << "seed " << seed;
        EXPECT_EQ(topology_is_preserved(log.start, log.flips, 0), report.failure->shrunk);
        after_an_audit += report.failure->attempt > audit_every ? 1 : 0;
    }
    EXPECT_GT(after_an_audit, 2);
}

}  // namespace
}  // namespace tightflip::properties
