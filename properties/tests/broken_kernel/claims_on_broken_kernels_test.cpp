// Each claim objects to the kernels that it speaks of, at the flip that shows it.

#include "broken_flips.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/generators.hpp>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using broken::BrokenKernel;
using broken::FlipVerdict;
using kernel::MutableHalfedgeTable;
using kernel::PlaceKind;
using enum ViolationCode;

const FlipScript script{{0}, {1}, {2}, {3}};

/// All flips of the script are defined on it.
Triangulation octahedron() {
    return kernel::families::octasphere(0);
}

/// A flip, and a corner overwritten which no look at the flipped edge meets.
FlipVerdict damage_elsewhere(MutableHalfedgeTable table, Edge e) {
    const FlipVerdict verdict = broken::turned_forwards(table, e);
    const kernel::Quadrilateral q = kernel::Quadrilateral::around(table, e);
    const auto is_at_the_edge = [&](kernel::Vertex v) {
        return v == at(table, q.h).origin || v == at(table, q.h1).origin ||
               v == at(table, q.h2).origin || v == at(table, q.t2).origin;
    };
    for (kernel::HalfedgeRecord& record : table) {
        if (is_at_the_edge(record.origin)) continue;
        record.origin = at(table, q.h).origin;
        break;
    }
    return verdict;
}

TEST(TopologyOnABrokenKernel, IsAuditedAtTheEndWhateverTheInterval) {
    for (const std::size_t audit_every : {0U, 5U, 100U}) {
        const BrokenKernel broken({.flip = damage_elsewhere, .sound_calls = 3});
        const auto finding = topology_is_preserved(octahedron(), script, audit_every);
        ASSERT_TRUE(finding.has_value()) << audit_every;
        EXPECT_EQ(finding->step, 4U) << audit_every;
    }
}

TEST(TopologyOnABrokenKernel, IsAuditedAfterEachIntervalOfAttempts) {
    struct Row {
        int sound_calls;
        std::size_t audit_every;
        std::size_t step;
    };
    const FlipScript long_script{{0}, {1}, {2}, {3}, {0}, {1}, {2}, {3}};
    for (const auto& [sound_calls, audit_every, step] :
         {Row{0, 1, 1}, Row{1, 1, 2}, Row{0, 3, 3}, Row{3, 5, 5}, Row{4, 6, 6}}) {
        const BrokenKernel broken({.flip = damage_elsewhere, .sound_calls = sound_calls});
        const auto finding = topology_is_preserved(octahedron(), long_script, audit_every);
        ASSERT_TRUE(finding.has_value());
        EXPECT_LE(finding->step, step);
        EXPECT_EQ(finding->step, step) << describe(*finding);
    }
}

TEST(TopologyOnABrokenKernel, NamesTheFlipAfterWhichItIsWrong) {
    for (const int sound_calls : {0, 1, 3}) {
        const BrokenKernel broken({.flip = broken::always_refused, .sound_calls = sound_calls});
        const auto finding = topology_is_preserved(octahedron(), script, 0);
        ASSERT_TRUE(finding.has_value());
        EXPECT_EQ(finding->step, static_cast<std::size_t>(sound_calls) + 1);
        EXPECT_EQ(finding->violation.code, refusal_unjustified);
        EXPECT_EQ(finding->violation.place, sound_calls);
    }
}

/// The finding that this claim must make at the first flip.
void expect_at_first_flip(const std::optional<Finding>& finding, ViolationCode code) {
    ASSERT_TRUE(finding.has_value());
    EXPECT_EQ(finding->step, 1U);
    EXPECT_EQ(finding->violation.code, code);
    EXPECT_EQ(finding->violation.kind, PlaceKind::edge);
    EXPECT_EQ(finding->violation.place, script.front().id);
}

TEST(FlipLawsOnABrokenKernel, UnflipMustUndoFlip) {
    const BrokenKernel broken({.unflip = broken::turned_forwards});
    expect_at_first_flip(flip_laws_hold(octahedron(), script), flip_law_broken);
}

TEST(FlipLawsOnABrokenKernel, UnflipMustBeRefusedWhereFlipIs) {
    const BrokenKernel broken({.unflip = broken::nothing_done});
    expect_at_first_flip(flip_laws_hold(kernel::families::book(3), std::span(script).first(3)),
                         flip_law_broken);
}

// A flip that does nothing is its own inverse and the identity after four; only that two exchange
// the edge's halves is not true of it.
TEST(FlipLawsOnABrokenKernel, TwoFlipsMustExchangeTheHalves) {
    const BrokenKernel broken({.flip = broken::nothing_done, .unflip = broken::nothing_done});
    expect_at_first_flip(flip_laws_hold(octahedron(), script), flip_law_broken);
}

TEST(ReferenceModelOnABrokenKernel, MustTurnTheEdgeTheSameWay) {
    const BrokenKernel broken({.flip = broken::turned_backwards});
    const auto finding = reference_model_agrees(octahedron(), script);
    ASSERT_TRUE(finding.has_value());
    EXPECT_EQ(finding->step, 1U);
    EXPECT_EQ(finding->violation.code, reference_model_disagrees);
}

TEST(ReferenceModelOnABrokenKernel, CanFlipMustSayWhatFlipDoes) {
    const BrokenKernel broken({.can_flip = broken::cannot_flip});
    expect_at_first_flip(reference_model_agrees(octahedron(), script), reference_model_disagrees);
}

TEST(ReferenceModelOnABrokenKernel, MustRefuseTheSameFlips) {
    const BrokenKernel broken({.flip = broken::never_refused});
    expect_at_first_flip(
        reference_model_agrees(kernel::families::book(3), std::span(script).first(3)),
        reference_model_disagrees);
}

// The first run is sound, and every replay of its log does nothing while it says that it does.
TEST(LogOnABrokenKernel, MustLeadToTheSurfaceOfTheRun) {
    const BrokenKernel broken({.flip = broken::nothing_done, .sound_calls = 4});
    const auto finding = log_reproduces_run(octahedron(), script);
    ASSERT_TRUE(finding.has_value());
    EXPECT_EQ(finding->violation.code, log_not_reproduced);
}

TEST(LogOnABrokenKernel, MustBeReplayedToItsEnd) {
    const BrokenKernel broken({.flip = broken::always_refused, .sound_calls = 4});
    const auto finding = log_reproduces_run(octahedron(), script);
    ASSERT_TRUE(finding.has_value());
    EXPECT_EQ(finding->violation.code, log_not_reproduced);
}

// Without a fault none of these objects: the script is a good one.
TEST(ClaimsOnTheSoundKernel, Hold) {
    const BrokenKernel sound({});
    ASSERT_EQ(without_refused(octahedron(), script), script);
    EXPECT_EQ(topology_is_preserved(octahedron(), script), std::nullopt);
    EXPECT_EQ(flip_laws_hold(octahedron(), script), std::nullopt);
    EXPECT_EQ(flip_laws_hold(kernel::families::book(3), std::span(script).first(3)), std::nullopt);
    EXPECT_EQ(reference_model_agrees(octahedron(), script), std::nullopt);
    EXPECT_EQ(log_reproduces_run(octahedron(), script), std::nullopt);
}

}  // namespace
}  // namespace tightflip::properties
