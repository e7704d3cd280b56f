// The suite, judged by kernels of which it is known what is wrong with them.
#include "naive_kernel.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/conformance.hpp>
#include <tightflip/properties/generators.hpp>
#include <tightflip/properties/invariants.hpp>

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

namespace families = kernel::families;

ConformanceOptions isolated() {
    return {.scripts = 2, .flips = 30, .seed = 5, .isolate = true, .seconds = 1, .most_hangs = 1};
}
/// For kernels that neither crash nor hang.
ConformanceOptions quick() {
    ConformanceOptions options = isolated();
    options.isolate = false;
    return options;
}

std::vector<KernelCode> codes(const KernelReport& report) {
    std::vector<KernelCode> found;
    for (const KernelFinding& finding : report.findings)
        found.push_back(finding.code);
    return found;
}

template <Fault fault, KernelClass allowed = KernelClass::loopless, Offers offers = Offers{}>
KernelReport test_naive(const ConformanceOptions& options = quick()) {
    return test_kernel(kernel_description<Naive<fault, allowed, offers>>(), options);
}

/// The properties said to hold.
std::vector<KernelProperty> held(const KernelReport& report) {
    std::vector<KernelProperty> properties;
    std::ranges::copy_if(all_kernel_properties(), std::back_inserter(properties),
                         [&](KernelProperty property) { return report.holds(property); });
    return properties;
}

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Conformance, FindsNothingWrongWithAKernelThatIsRightInAnyClass) {
    EXPECT_THAT(codes(test_naive<Fault::none, KernelClass::simple>()), IsEmpty());
    EXPECT_THAT(codes(test_naive<Fault::none, KernelClass::loopless>()), IsEmpty());
    EXPECT_THAT(codes(test_naive<Fault::none, KernelClass::delta_complex>()), IsEmpty());
}

TEST(Conformance, SaysThatAPropertyHoldsOnlyWhereItWasPutToTheTest) {
    using enum KernelProperty;
    EXPECT_THAT(held(test_naive<Fault::none>()), ElementsAreArray(all_kernel_properties()));
    EXPECT_THAT(held(test_naive<Fault::cannot_be_made>()), IsEmpty());
    EXPECT_THAT(held(test_naive<Fault::lists_no_sides>()), IsEmpty());
    EXPECT_THAT(held(test_naive<Fault::start_misread>()), IsEmpty());
    EXPECT_THAT(held(test_naive<Fault::refuses_all>()), ElementsAre(reading, validator));
    EXPECT_THAT(held(test_naive<Fault::throws_no_exception>()),
                ElementsAre(reading, legality, validator));

    constexpr Offers undamaged{.origins = false, .nexts = false, .neighbours = false};
    constexpr Offers unpromised{.keeps_sides = false};
    const auto without = [](KernelProperty missing) {
        std::vector<KernelProperty> others(all_kernel_properties().begin(),
                                           all_kernel_properties().end());
        others.erase(std::ranges::find(others, missing));
        return others;
    };
    EXPECT_THAT(held(test_naive<Fault::none, KernelClass::delta_complex, undamaged>()),
                ElementsAreArray(without(validator)));
    EXPECT_THAT(held(test_naive<Fault::none, KernelClass::loopless, unpromised>()),
                ElementsAreArray(without(handles)));
}

TEST(Conformance, CountsFlipsThatWereDone) {
    const KernelReport refused = test_naive<Fault::refuses_all>();
    EXPECT_EQ(refused.flips(), 0U);
    EXPECT_TRUE(refused.was_asked(KernelProperty::agreement));  // 901 was found
    EXPECT_FALSE(refused.was_asked(KernelProperty::survival));

    const FlipScript script{{0}, {0}, {1}};
    const auto start = families::tetrahedron();
    const auto kernel = kernel_description<Naive<Fault::none>>();
    const auto flips = [](const ScriptRun& run) {
        return run.asked[static_cast<std::size_t>(KernelProperty::survival)];
    };
    EXPECT_EQ(flips(run_script(kernel, start, script, false)), 3U);
    EXPECT_EQ(flips(run_script(kernel, start, script, true)), 15U);
}

TEST(Conformance, FindsWhatIsWrongWithTheReading) {
    EXPECT_THAT(codes(test_naive<Fault::start_misread>()), ElementsAre(KernelCode::start_differs));
    EXPECT_THAT(codes(test_naive<Fault::lists_sides_of_tetrahedra_only>()),
                ElementsAre(KernelCode::start_differs));
    EXPECT_THAT(codes(test_naive<Fault::lists_more_sides>()),
                ElementsAre(KernelCode::sides_unreadable));
    EXPECT_THAT(codes(test_naive<Fault::miscounts>()), ElementsAre(KernelCode::counts_differ));
    EXPECT_THAT(codes(test_naive<Fault::miscounts_after_flips>()),
                ElementsAre(KernelCode::counts_differ));
}

TEST(Conformance, FindsWhatIsWrongWithTheFlip) {
    EXPECT_THAT(codes(test_naive<Fault::changes_a_far_label>()),
                ElementsAre(KernelCode::topology_changed, KernelCode::changed_elsewhere,
                            KernelCode::not_the_flip, KernelCode::surface_differs_from_ours));
    EXPECT_THAT(codes(test_naive<Fault::forgets_a_label>()),
                ElementsAre(KernelCode::topology_changed, KernelCode::not_the_flip,
                            KernelCode::surface_differs_from_ours));
    EXPECT_THAT(codes(test_naive<Fault::turns_a_far_face>()),
                ElementsAre(KernelCode::changed_elsewhere, KernelCode::four_flips_differ));
    // The surface is right, though no side is where it was.
    EXPECT_THAT(codes(test_naive<Fault::turns_all_faces>()),
                ElementsAre(KernelCode::changed_elsewhere, KernelCode::four_flips_differ,
                            KernelCode::side_moved));
    EXPECT_THAT(codes(test_naive<Fault::swaps_outer_sides>()), Contains(KernelCode::side_moved));
    EXPECT_THAT(codes(test_naive<Fault::tears_a_side>()), Contains(KernelCode::topology_changed));
}

TEST(Conformance, FindsWhatIsWrongWithTheLaws) {
    EXPECT_THAT(codes(test_naive<Fault::flips_once_only>()),
                ElementsAre(KernelCode::flip_back_refused, KernelCode::valid_flip_refused,
                            KernelCode::answers_differ_from_ours));
    EXPECT_THAT(codes(test_naive<Fault::second_flip_differs>()),
                Contains(KernelCode::flip_back_differs));
    EXPECT_THAT(codes(test_naive<Fault::exchanges_four_times>()),
                ElementsAre(KernelCode::four_flips_differ));
}

TEST(Conformance, FindsUntruthfulAnswers) {
    EXPECT_THAT(
        codes(test_naive<Fault::allows_all>()),
        ElementsAre(KernelCode::invalid_flip_allowed, KernelCode::answers_differ_from_ours));
    EXPECT_THAT(codes(test_naive<Fault::refuses_all>()),
                ElementsAre(KernelCode::valid_flip_refused, KernelCode::answers_differ_from_ours));
    EXPECT_THAT(codes(test_naive<Fault::allows_all, KernelClass::simple>()),
                ElementsAre(KernelCode::invalid_flip_allowed));
    EXPECT_THAT(codes(test_naive<Fault::allows_all, KernelClass::delta_complex>()),
                ElementsAre(KernelCode::invalid_flip_allowed));
}

TEST(Conformance, FindsUntruthfulValidators) {
    EXPECT_THAT(codes(test_naive<Fault::validates_nothing>()),
                ElementsAre(KernelCode::valid_rejected));
    EXPECT_THAT(
        codes(test_naive<Fault::validates_all>()),
        ElementsAre(KernelCode::wrong_origin_accepted, KernelCode::wrong_next_accepted,
                    KernelCode::wrong_across_accepted, KernelCode::forbidden_edge_accepted));
    // Whose entries were set passes, with a forbidden edge too.
    EXPECT_THAT(
        codes(test_naive<Fault::overlooks_origins>()),
        ElementsAre(KernelCode::wrong_origin_accepted, KernelCode::forbidden_edge_accepted));
    EXPECT_THAT(codes(test_naive<Fault::overlooks_nexts>()),
                ElementsAre(KernelCode::wrong_next_accepted, KernelCode::forbidden_edge_accepted));
    EXPECT_THAT(
        codes(test_naive<Fault::overlooks_neighbours>()),
        ElementsAre(KernelCode::wrong_across_accepted, KernelCode::forbidden_edge_accepted));
}

/// What a validator is said of that overlooks what its class forbids.
template <KernelClass allowed, Offers offers>
std::string passed_by_lax_validator() {
    const KernelReport report = test_naive<Fault::overlooks_forbidden_edges, allowed, offers>();
    const KernelFinding* const finding = report.find(KernelCode::forbidden_edge_accepted);
    return finding == nullptr ? "" : finding->words;
}

TEST(Conformance, PlantsEdgesThatTheClassForbids) {
    using enum KernelClass;
    constexpr Offers by_nexts{.gluings = false, .neighbours = false};
    constexpr Offers by_neighbours{.gluings = false, .nexts = false};
    constexpr Offers by_gluing{.origins = false, .nexts = false, .neighbours = false};
    const auto parallel = HasSubstr("forbidden edge planted at side 0 (there are parallel edges)");
    EXPECT_THAT((passed_by_lax_validator<simple, by_nexts>()), parallel);
    EXPECT_THAT((passed_by_lax_validator<simple, by_neighbours>()), parallel);
    EXPECT_THAT((passed_by_lax_validator<simple, by_gluing>()), parallel);
    const auto loop = HasSubstr("are not distinct)");
    EXPECT_THAT((passed_by_lax_validator<loopless, by_nexts>()), loop);
    EXPECT_THAT((passed_by_lax_validator<loopless, by_neighbours>()), loop);
    EXPECT_THAT((passed_by_lax_validator<delta_complex, by_nexts>()), IsEmpty());

    constexpr Offers by_origins{.gluings = false, .nexts = false, .neighbours = false};
    EXPECT_THAT((passed_by_lax_validator<simple, by_origins>()), IsEmpty());  // no way to plant
}

TEST(Conformance, AsksTheValidatorOfAKernelThatCannotBeReadAnyMore) {
    const KernelReport report = test_naive<Fault::cannot_be_read_when_damaged>();
    EXPECT_THAT(codes(report), IsEmpty());
    EXPECT_TRUE(report.holds(KernelProperty::validator));
    EXPECT_GE(report.planted, 3U * 12U);
}

TEST(Conformance, GoesOnWhereAKernelThrowsCrashesOrHangs) {
    const KernelReport thrown = test_naive<Fault::throws>();
    ASSERT_THAT(codes(thrown), ElementsAre(KernelCode::threw));
    EXPECT_EQ(thrown.findings[0].words, "out of sorts");
    EXPECT_EQ(thrown.findings[0].script.size(), 3U);

    const KernelReport crashed = test_naive<Fault::crashes>(isolated());
    ASSERT_THAT(codes(crashed), ElementsAre(KernelCode::crashed_or_hung));
    EXPECT_THAT(crashed.findings[0].words, HasSubstr("signal 11"));
    EXPECT_EQ(crashed.findings[0].step, 3U);
    EXPECT_EQ(crashed.findings[0].log->flips.size(), 3U);

    const KernelReport gone = test_naive<Fault::exits>(isolated());
    ASSERT_THAT(codes(gone), ElementsAre(KernelCode::crashed_or_hung));
    EXPECT_THAT(gone.findings[0].words, HasSubstr("ended its process with exit code"));

    const KernelReport hung = test_naive<Fault::validator_hangs_on_damage>(isolated());
    ASSERT_THAT(codes(hung), ElementsAre(KernelCode::crashed_or_hung_on_damage));
    EXPECT_THAT(hung.findings[0].words, HasSubstr("did not answer within 1 s"));
}

TEST(Conformance, TellsWhatAValidatorThrowsWithAndWithoutChildProcesses) {
    ConformanceOptions options = quick();
    for (const bool isolate : {true, false}) {
        options.isolate = isolate;
        const KernelReport report = test_naive<Fault::validator_throws_on_damage>(options);
        ASSERT_THAT(codes(report), ElementsAre(KernelCode::crashed_or_hung_on_damage));
        EXPECT_THAT(report.findings[0].words,
                    HasSubstr("its validator threw: something that is no std::exception"));
    }
}

TEST(Conformance, ShrinksScriptsAndLeavesLogsThatEndInTheGuiltyEdge) {
    const auto kernel = kernel_description<Naive<Fault::allows_all>>();
    const KernelReport report = test_kernel(kernel, quick());
    const KernelFinding* const finding = report.find(KernelCode::invalid_flip_allowed);
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->start, "tetrahedron V=4");
    EXPECT_EQ(finding->script.size(), 2U);  // from the tetrahedron, the second flip makes a loop
    EXPECT_EQ(finding->step, 2U);
    EXPECT_THAT(describe(*finding), HasSubstr("701 invalid_flip_allowed, tetrahedron V=4, step 2"));

    EXPECT_EQ(finding->log->flips, finding->script);
    EXPECT_EQ(replay(*finding->log).done, 1U);  // and then it makes a loop

    const KernelReport careful = test_naive<Fault::refuses_all>();
    const KernelFinding* const refused = careful.find(KernelCode::valid_flip_refused);
    ASSERT_NE(refused, nullptr);
    EXPECT_EQ(refused->log->flips, refused->script);
    EXPECT_TRUE(replay(*refused->log).is_complete());
    EXPECT_EQ(refused->log->flips.size(), 1U);
}

TEST(Conformance, KeepsRefusedEdgesOutOfLogs) {
    const auto kernel = kernel_description<Naive<Fault::throws, KernelClass::simple>>();
    const Triangulation start = families::double_wheel(6);
    const FlipScript script{{0}, {1}, {1}, {2}, {3}, {4}, {5}, {6}};
    const ScriptRun run = run_script(kernel, start, script, false);
    ASSERT_EQ(run.findings.size(), 1U);
    const KernelFinding& finding = run.findings[0];
    EXPECT_EQ(finding.log->flips.size(), 3U);
    EXPECT_GT(finding.script.size(), 3U);
    EXPECT_TRUE(replay(*finding.log).is_complete());
}

TEST(Conformance, ReadsScriptsInTheNumbersOfItsOwnKernel) {
    constexpr Offers moving{.keeps_sides = false};
    const auto moves =
        kernel_description<Naive<Fault::swaps_outer_sides, KernelClass::loopless, moving>>();
    const Triangulation start = families::double_wheel(6);
    kernel::RandomStream random(3);
    const FlipScript script = random_script(start, 60, random);
    EXPECT_THAT(run_script(moves, start, script, true).findings, IsEmpty());

    Triangulation ours = start;
    FlipScript done;
    std::ranges::copy_if(script, std::back_inserter(done),
                         [&](Edge e) { return static_cast<bool>(ours.flip(e)); });
    EXPECT_EQ(run_script(moves, start, script, false).flips, done);
}

TEST(Conformance, FindsTheSameWithAndWithoutChildProcesses) {
    const KernelReport apart = test_naive<Fault::allows_all>(isolated());
    const KernelReport here = test_naive<Fault::allows_all>(quick());
    ASSERT_EQ(codes(apart), codes(here));
    for (std::size_t i = 0; i < here.findings.size(); ++i) {
        EXPECT_EQ(describe(apart.findings[i]), describe(here.findings[i]));
        EXPECT_EQ(apart.findings[i].log, here.findings[i].log);
    }
    EXPECT_EQ(apart.asked, here.asked);
}

TEST(Conformance, WritesATableOfKernelsAndProperties) {
    constexpr Offers unpromised{.keeps_sides = false};
    const std::vector<KernelReport> reports{
        test_naive<Fault::none, KernelClass::loopless, unpromised>(),
        test_naive<Fault::refuses_all>()};
    std::ostringstream out;
    write_markdown(out, reports);
    EXPECT_EQ(out.str(),
              "| kernel | judged as | reading | topology | locality | definition | inverse | "
              "handles | legality | validator | agreement | survival |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|\n"
              "| naive | loopless | holds | holds | holds | holds | holds | not asked | holds | "
              "holds | holds | holds |\n"
              "| naive | loopless | holds | not asked | not asked | not asked | not asked | "
              "not asked | 702 | holds | 901 | not asked |\n");
}

TEST(KernelCodes, HaveNamesAndProperties) {
    EXPECT_EQ(name(KernelCode::side_moved), "side_moved");
    EXPECT_EQ(property_of(KernelCode::start_differs), KernelProperty::reading);
    EXPECT_EQ(property_of(KernelCode::crashed_or_hung), KernelProperty::survival);
    EXPECT_EQ(name(property_of(KernelCode::wrong_next_accepted)), "validator");
    EXPECT_EQ(name(property_of(KernelCode::forbidden_edge_accepted)), "validator");
    EXPECT_EQ(all_kernel_properties().size(), 10U);
    EXPECT_EQ(why_not_asked(KernelProperty::inverse), "no flip was taken back");
}

TEST(KernelFindings, NameTheirStartWhereThereIsOneAndTheLaws) {
    KernelFinding finding{.code = KernelCode::threw,
                          .start = {},
                          .step = 1,
                          .words = "no",
                          .script = {{4}},
                          .laws = false,
                          .log = {}};
    EXPECT_EQ(describe(finding), "1001 threw, step 1: no; script 4");
    finding.start = "torus V=9";
    finding.laws = true;
    EXPECT_EQ(describe(finding),
              "1001 threw, torus V=9, step 1: no; script 4, each flip taken back and repeated");
}

TEST(SideTables, FlipAsTheKernelDoes) {
    Triangulation surface = families::random(9, 1, 3);
    SideTables tables = side_tables(surface);
    kernel::RandomStream random(4);
    for (const Edge e : random_script(surface, 200, random)) {
        if (!surface.flip(e)) continue;
        ASSERT_TRUE(flip_by_definition(tables, halfedge_of(e).id));
        ASSERT_EQ(tables, side_tables(surface));
    }
}

TEST(SideTables, AreJudgedByTheClassPromised) {
    const auto valid_in = [](const SideTables& tables) {
        std::vector<bool> answers;
        for (const KernelClass allowed :
             {KernelClass::simple, KernelClass::loopless, KernelClass::delta_complex})
            answers.push_back(judge(tables, allowed).is_valid());
        return answers;
    };
    SideTables tables = side_tables(families::tetrahedron());
    EXPECT_THAT(valid_in(tables), ElementsAre(true, true, true));
    flip_by_definition(tables, 0);
    EXPECT_THAT(valid_in(tables), ElementsAre(false, true, true));
    const auto around = sides_around(tables, 0);
    flip_by_definition(tables, (*around)[1]);
    EXPECT_THAT(valid_in(tables), ElementsAre(false, false, true));
    EXPECT_EQ(judge(tables, KernelClass::delta_complex).topology.genus, 0);
    tables.across[0] = 0;
    EXPECT_THAT(valid_in(tables), ElementsAre(false, false, false));
}

}  // namespace
}  // namespace tightflip::properties
