// The suite, judged by kernels of which it is known what is wrong with them.
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/child_process.hpp>
#include <tightflip/properties/conformance.hpp>
#include <tightflip/properties/generators.hpp>
#include <tightflip/properties/invariants.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

namespace families = kernel::families;

enum class Fault {
    none,
    start_misread,
    lists_more_sides,
    miscounts,
    miscounts_after_flips,
    changes_a_far_label,
    tears_a_side,
    forgets_a_label,
    swaps_outer_sides,
    flips_once_only,
    second_flip_differs,
    exchanges_four_times,
    allows_all,
    refuses_all,
    validates_all,
    validates_nothing,
    overlooks_origins,
    overlooks_nexts,
    overlooks_neighbours,
    throws,
    crashes,
    hangs,
    validator_hangs_on_damage,
};

void exchange(SideTables& tables, Index a, Index b) {  // two sides swap their numbers
    const auto renamed = [&](Index s) { return s == a ? b : s == b ? a : s; };
    SideTables now = tables;
    for (Index s = 0; s < tables.size(); ++s) {
        const auto from = static_cast<std::size_t>(s);
        const auto to = static_cast<std::size_t>(renamed(s));
        now.next[to] = renamed(tables.next[from]);
        now.across[to] = renamed(tables.across[from]);
        now.origin[to] = tables.origin[from];
    }
    tables = std::move(now);
}

/// A naive kernel with one fault.
template <Fault fault, KernelClass kernel_class = KernelClass::loopless>
struct Naive {
    static constexpr std::string_view name = "naive";
    static constexpr KernelClass allowed = kernel_class;
    using Side = Index;

    Naive(Index vertices, std::span<const std::array<Index, 3>> faces)
        : Naive(kernel::build(faces, vertices).value()) {}
    explicit Naive(const Gluing& gluing) : Naive(kernel::build(gluing).value()) {}
    explicit Naive(const Triangulation& surface) : tables(side_tables(surface)) {
        if (fault == Fault::start_misread) flip_by_definition(tables, 0);
    }

    [[nodiscard]] std::array<Index, 3> counts() const {
        Index edges = tables.size() / 2;
        if (fault == Fault::miscounts) ++edges;
        if (fault == Fault::miscounts_after_flips) edges += flips;
        return {tables.vertex_count, edges, tables.size() / 3};
    }
    [[nodiscard]] std::vector<Side> sides() const {
        std::vector<Side> all;
        for (Index s = 0; s < tables.size(); ++s)
            all.push_back(s);
        if (fault == Fault::lists_more_sides && flips > 1) all.push_back(tables.size());
        return all;
    }
    [[nodiscard]] Side next(Side s) const { return tables.next[index(s)]; }
    [[nodiscard]] Side across(Side s) const { return tables.across[index(s)]; }
    [[nodiscard]] Index origin(Side s) const { return tables.origin[index(s)]; }
    [[nodiscard]] bool can_flip(Side s) const {
        if (fault == Fault::allows_all) return true;
        if (fault == Fault::refuses_all) return false;
        if (fault == Fault::flips_once_only && s == last) return false;
        SideTables after = tables;
        return flip_by_definition(after, s) && judge(after, allowed).is_valid();
    }
    void flip(Side s) {
        const auto around = sides_around(tables, s);
        if (!around) return;
        const auto [h, h1, h2, t, t1, t2] = *around;
        if (!flip_by_definition(tables, s)) return;
        ++flips;
        if (fault == Fault::second_flip_differs && s == last) flip_by_definition(tables, h1);
        last = s;
        switch (fault) {
            case Fault::changes_a_far_label:
                spoil_far_label(*around);
                break;
            case Fault::tears_a_side:
                tables.across[index(h2)] = h2;
                break;
            case Fault::forgets_a_label:
                tables.origin[index(h)] = tables.origin[index(h1)];
                break;
            case Fault::swaps_outer_sides:
                exchange(tables, h1, t1);
                break;
            case Fault::exchanges_four_times:
                if (flips % 4 == 0) exchange(tables, h, t);
                break;
            case Fault::throws:
                if (flips == 3) throw std::runtime_error("out of sorts");
                break;
            case Fault::crashes:
                if (flips == 3) std::raise(SIGSEGV);
                break;
            case Fault::hangs:
                while (flips == 3) {
                    volatile int forever = 0;
                    static_cast<void>(forever);
                }
                break;
            default:
                break;
        }
    }
    [[nodiscard]] bool is_valid() const {
        while (fault == Fault::validator_hangs_on_damage && damaged) {
            volatile int forever = 0;
            static_cast<void>(forever);
        }
        if (fault == Fault::validates_all || overlooked) return true;
        return fault != Fault::validates_nothing && judge(tables, allowed).is_valid();
    }

    void set_origin(Side s, Index v) {
        damaged = true;
        overlooked = fault == Fault::overlooks_origins;
        tables.origin[index(s)] = v;
    }
    void set_next(Side s, Side wrong) {
        damaged = true;
        overlooked = fault == Fault::overlooks_nexts;
        tables.next[index(s)] = wrong;
    }
    void set_across(Side s, Side wrong) {
        damaged = true;
        overlooked = fault == Fault::overlooks_neighbours;
        tables.across[index(s)] = wrong;
    }

    static std::size_t index(Side s) { return static_cast<std::size_t>(s); }
    void spoil_far_label(const std::array<Index, 6>& around) {
        for (Side s = 0; s < tables.size(); ++s) {
            if (std::ranges::find(around, s) != around.end()) continue;
            tables.origin[index(s)] = (tables.origin[index(s)] + 1) % tables.vertex_count;
            return;
        }
    }

    SideTables tables;
    Index flips = 0;
    Side last = -1;
    bool damaged = false;
    bool overlooked = false;
};

ConformanceOptions quick() {
    return {.scripts = 2, .flips = 30, .seed = 5, .isolate = true, .seconds = 1, .most_hangs = 1};
}

std::vector<KernelCode> codes(const KernelReport& report) {
    std::vector<KernelCode> found;
    for (const KernelFinding& finding : report.findings)
        found.push_back(finding.code);
    return found;
}

template <Fault fault, KernelClass allowed = KernelClass::loopless>
KernelReport test_naive(const ConformanceOptions& options = quick()) {
    return test_kernel(kernel_description<Naive<fault, allowed>>(), options);
}

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Conformance, FindsNothingWrongWithAKernelThatIsRightInAnyClass) {
    EXPECT_THAT(codes(test_naive<Fault::none, KernelClass::simple>()), IsEmpty());
    EXPECT_THAT(codes(test_naive<Fault::none, KernelClass::loopless>()), IsEmpty());
    EXPECT_THAT(codes(test_naive<Fault::none, KernelClass::delta_complex>()), IsEmpty());
}

TEST(Conformance, FindsWhatIsWrongWithTheReading) {
    EXPECT_THAT(codes(test_naive<Fault::start_misread>()), ElementsAre(KernelCode::start_differs));
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
    EXPECT_THAT(codes(test_naive<Fault::validates_all>()),
                ElementsAre(KernelCode::wrong_origin_accepted, KernelCode::wrong_next_accepted,
                            KernelCode::wrong_across_accepted));
    EXPECT_THAT(codes(test_naive<Fault::overlooks_origins>()),
                ElementsAre(KernelCode::wrong_origin_accepted));
    EXPECT_THAT(codes(test_naive<Fault::overlooks_nexts>()),
                ElementsAre(KernelCode::wrong_next_accepted));
    EXPECT_THAT(codes(test_naive<Fault::overlooks_neighbours>()),
                ElementsAre(KernelCode::wrong_across_accepted));
}

TEST(Conformance, GoesOnWhereAKernelThrowsCrashesOrHangs) {
    const KernelReport thrown = test_naive<Fault::throws>();
    ASSERT_THAT(codes(thrown), ElementsAre(KernelCode::threw));
    EXPECT_EQ(thrown.findings[0].words, "out of sorts");
    EXPECT_EQ(thrown.findings[0].script.size(), 3U);

    const KernelReport crashed = test_naive<Fault::crashes>();
    ASSERT_THAT(codes(crashed), ElementsAre(KernelCode::crashed_or_hung));
    EXPECT_THAT(crashed.findings[0].words, HasSubstr("signal 11"));
    EXPECT_LE(crashed.findings[0].script.size(), 3U);

    const KernelReport hung = test_naive<Fault::validator_hangs_on_damage>();
    ASSERT_THAT(codes(hung), ElementsAre(KernelCode::crashed_or_hung_on_damage));
    EXPECT_THAT(hung.findings[0].words, HasSubstr("did not answer within 1 s"));
}

TEST(ChildProcess, IsEndedWhenItsTimeIsUp) {
    const Triangulation start = families::tetrahedron();
    const FlipScript script{{0}, {0}, {0}};
    const ChildResult child = run_in_child(
        [&](const ChildOutput& write) {
            write("begun");
            static_cast<void>(
                run_script(kernel_description<Naive<Fault::hangs>>(), start, script, false));
            write("done");
        },
        1);
    EXPECT_TRUE(child.timed_out);
    EXPECT_EQ(child.output, "begun");
}

TEST(Conformance, ShrinksScriptsAndLeavesLogsThatReplay) {
    const KernelReport report = test_naive<Fault::allows_all>();
    const KernelFinding* const finding = report.find(KernelCode::invalid_flip_allowed);
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->start, "tetrahedron V=4");
    EXPECT_EQ(finding->script.size(), 2U);  // from the tetrahedron, the second flip makes a loop
    EXPECT_EQ(finding->step, 2U);
    EXPECT_THAT(describe(*finding), HasSubstr("701 invalid_flip_allowed, tetrahedron V=4, step 2"));

    const auto directory = std::filesystem::path(::testing::TempDir());
    const auto path = write_log(directory, "a naive kernel", *finding);
    EXPECT_EQ(path.filename(), "a_naive_kernel_invalid_flip_allowed.flips");
    const kernel::FlipLog log = kernel::parse_flip_log(kernel::read_file(path), path.string());
    EXPECT_TRUE(replay(log).is_complete());
    EXPECT_EQ(log.flips.size(), 1U);  // up to the answer
    std::filesystem::remove(path);
}

TEST(Conformance, FindsTheSameWithAndWithoutChildProcesses) {
    ConformanceOptions options = quick();
    const KernelReport apart = test_naive<Fault::allows_all>(options);
    options.isolate = false;
    const KernelReport here = test_naive<Fault::allows_all>(options);
    ASSERT_EQ(codes(apart), codes(here));
    for (std::size_t i = 0; i < here.findings.size(); ++i) {
        EXPECT_EQ(describe(apart.findings[i]), describe(here.findings[i]));
        EXPECT_EQ(apart.findings[i].log, here.findings[i].log);
    }
    EXPECT_EQ(apart.flips, here.flips);
}

TEST(Conformance, WritesATableOfKernelsAndProperties) {
    KernelReport good = test_naive<Fault::none>();
    good.asked.erase(std::ranges::find(good.asked, KernelProperty::handles));
    const std::vector<KernelReport> reports{good, test_naive<Fault::refuses_all>()};
    std::ostringstream out;
    write_markdown(out, reports);
    EXPECT_EQ(out.str(),
              "| kernel | judged as | reading | topology | locality | definition | inverse | "
              "handles | legality | validator | agreement | survival |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|\n"
              "| naive | loopless | holds | holds | holds | holds | holds | not asked | holds | "
              "holds | holds | holds |\n"
              "| naive | loopless | holds | holds | holds | holds | holds | holds | 702 | holds | "
              "901 | holds |\n");
}

TEST(KernelCodes, HaveNamesAndProperties) {
    EXPECT_EQ(name(KernelCode::side_moved), "side_moved");
    EXPECT_EQ(property_of(KernelCode::start_differs), KernelProperty::reading);
    EXPECT_EQ(property_of(KernelCode::crashed_or_hung), KernelProperty::survival);
    EXPECT_EQ(name(property_of(KernelCode::wrong_next_accepted)), "validator");
    EXPECT_EQ(all_kernel_properties().size(), 10U);
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
