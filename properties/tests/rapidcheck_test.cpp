#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/rapidcheck.hpp>

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tightflip::properties {
namespace {

// ---- the claims ----

RC_GTEST_PROP(Theorem42Property, EveryAttemptKeepsTheTopology, (const FlipCase& flip_case)) {
    require_claim("topology_is_preserved", flip_case,
                  [](const Triangulation& start, std::span<const Edge> script) {
                      return topology_is_preserved(start, script);
                  });
}

RC_GTEST_PROP(ReferenceModelProperty, AgreesAfterEveryAttempt, (const FlipCase& flip_case)) {
    require_claim("reference_model_agrees", flip_case, reference_model_agrees);
}

RC_GTEST_PROP(FlipLawsProperty, HoldAfterEveryAttempt, (const FlipCase& flip_case)) {
    require_claim("flip_laws_hold", flip_case, flip_laws_hold);
}

RC_GTEST_PROP(LogProperty, ReproducesTheRun, (const FlipCase& flip_case)) {
    require_claim("log_reproduces_run", flip_case, log_reproduces_run);
}

// ---- the generators ----

FlipCase drawn(const rc::Gen<FlipCase>& gen, std::uint64_t seed, int size = rc::kNominalSize) {
    return gen(rc::Random(seed), size).value();
}

TEST(AnyFlipCase, CoversEveryKindGenusAndManySizes) {
    std::set<std::string_view> kinds;
    std::set<Index> genera;
    std::set<Index> vertices;
    std::set<std::size_t> lengths;
    std::set<bool> simple;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const FlipCase flip_case = drawn(any_flip_case(), seed);
        const kernel::AuditReport report = audit(flip_case.start());
        ASSERT_TRUE(report.is_valid()) << describe(flip_case);
        kinds.insert(flip_case.kind->name);
        genera.insert(report.topology.genus.value());
        vertices.insert(report.topology.vertices);
        lengths.insert(flip_case.picks.size());
        simple.insert(report.is_simple().value());
    }
    EXPECT_EQ(kinds.size(), start_kinds().size());
    EXPECT_EQ(genera, (std::set<Index>{0, 1, 2, 3}));
    EXPECT_GT(vertices.size(), 20U);
    EXPECT_GT(*lengths.rbegin(), 90U);
    EXPECT_EQ(simple.size(), 2U);
}

TEST(AnyFlipCase, GrowsWithTheSize) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const FlipCase smallest = drawn(any_flip_case(), seed, 0);
        EXPECT_TRUE(smallest.picks.empty());
        EXPECT_EQ(smallest.request.vertices, smallest.kind->least_vertices(smallest.request.genus));
    }
}

TEST(AnyFlipCase, KeepsToItsLimits) {
    const FlipCaseLimits limits{
        .genus = 1, .spare_vertices = 2, .flips = 10, .only_kind = find_start_kind("random")};
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const FlipCase flip_case = drawn(any_flip_case(limits), seed);
        EXPECT_EQ(flip_case.kind, limits.only_kind);
        EXPECT_LE(flip_case.request.genus, 1);
        EXPECT_LE(flip_case.request.vertices, 6);
        EXPECT_LE(flip_case.picks.size(), 10U);
    }
}

/// What RapidCheck would do: the first shrink that still fails, again and again.
template <class Fails>
FlipCase shrunk(rc::Shrinkable<FlipCase> shrinkable, Fails&& fails) {
    for (bool smaller = true; smaller;) {
        smaller = false;
        auto shrinks = shrinkable.shrinks();
        while (const auto candidate = shrinks.next()) {
            if (!fails(candidate->value())) continue;
            shrinkable = *candidate;
            smaller = true;
            break;
        }
    }
    return shrinkable.value();
}

TEST(AnyFlipCase, ShrinksToASmallStartAndAShortScript) {
    const auto flips_an_edge_three_times = [](const FlipCase& flip_case) {
        const auto flips = flip_case.log().flips;
        return std::count(flips.begin(), flips.end(), Edge{2}) >= 3;
    };
    int tried = 0;
    for (std::uint64_t seed = 0; seed < 200 && tried < 20; ++seed) {
        const auto shrinkable = any_flip_case()(rc::Random(seed), rc::kNominalSize);
        if (!flips_an_edge_three_times(shrinkable.value())) continue;
        ++tried;
        EXPECT_EQ(describe(shrunk(shrinkable, flips_an_edge_three_times)),
                  "tetrahedron, V = 4, genus 0, seed 0, E = 6; flips 2 2 2");
    }
    EXPECT_EQ(tried, 20);
}

TEST(AnyFlipCase, ShrinksToTheLeastSizeAndGenusThatFail) {
    const auto large_enough = [](const FlipCase& flip_case) {
        const Triangulation start = flip_case.start();
        return start.genus() >= 2 && start.vertex_count() >= 10;
    };
    int tried = 0;
    for (std::uint64_t seed = 0; seed < 400 && tried < 10; ++seed) {
        const auto shrinkable = any_flip_case()(rc::Random(seed), rc::kNominalSize);
        if (!large_enough(shrinkable.value())) continue;
        ++tried;
        EXPECT_EQ(describe(shrunk(shrinkable, large_enough)),
                  "genus, V = 10, genus 2, seed 0, E = 36; flips none");
    }
    EXPECT_EQ(tried, 10);
}

// ---- failing cases ----

class InDirectory {  // where failing cases go, for the length of a test
public:
    explicit InDirectory(const std::filesystem::path& directory) : path_(directory) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
        setenv(failures_directory_variable, path_.c_str(), 1);
    }
    ~InDirectory() {
        unsetenv(failures_directory_variable);
        std::filesystem::remove_all(path_);
    }
    InDirectory(const InDirectory&) = delete;
    InDirectory& operator=(const InDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// A claim that does not hold: no script flips edge 3 and later edge 1.
std::optional<Finding> never_three_then_one(const Triangulation&, std::span<const Edge> script) {
    const auto three = std::ranges::find(script, Edge{3});
    const auto one = std::find(three, script.end(), Edge{1});
    if (one == script.end()) return std::nullopt;
    return Finding{static_cast<std::size_t>(one - script.begin()) + 1,
                   {.code = ViolationCode::flip_law_broken}};
}

TEST(RequireClaim, LeavesTheSmallestFailingCaseAsALogAndNamesIt) {
    const InDirectory directory(std::filesystem::path(::testing::TempDir()) /
                                "tightflip_require_claim");
    const auto result = rc::detail::checkTestable(
        [](const FlipCase& flip_case) {
            require_claim("three_then_one", flip_case, never_three_then_one);
        },
        rc::detail::TestMetadata{}, rc::detail::TestParams{});
    ASSERT_TRUE(result.is<rc::detail::FailureResult>());
    const auto& failure = result.get<rc::detail::FailureResult>();
    const auto path = directory.path() / "three_then_one.flips";
    EXPECT_THAT(failure.description, ::testing::HasSubstr(path.string()));
    EXPECT_THAT(failure.description, ::testing::HasSubstr("flip_law_broken"));
    ASSERT_EQ(failure.counterExample.size(), 1U);
    EXPECT_EQ(failure.counterExample.front().second,
              "(tetrahedron, V = 4, genus 0, seed 0, E = 6; flips 3 1)");
    const kernel::FlipLog log = kernel::parse_flip_log(kernel::read_file(path), path.string());
    EXPECT_EQ(log.start, FlipCase{}.start());
    EXPECT_EQ(log.flips, (FlipScript{{3}, {1}}));
}

TEST(RequireClaim, WritesNothingWhereTheClaimHolds) {
    const InDirectory directory(std::filesystem::path(::testing::TempDir()) /
                                "tightflip_require_claim_holds");
    require_claim("holds", FlipCase{}, never_three_then_one);
    EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(RapidCheckSeed, MakesARunRepeatable) {
    const auto run = [](std::uint64_t seed) {
        std::vector<std::string> cases;
        rc::detail::TestParams params;
        params.seed = seed;
        rc::detail::checkTestable(
            [&](const FlipCase& flip_case) { cases.push_back(describe(flip_case)); },
            rc::detail::TestMetadata{}, params);
        return cases;
    };
    EXPECT_EQ(run(1).size(), 100U);
    EXPECT_EQ(run(1), run(1));
    EXPECT_NE(run(1), run(2));
}

}  // namespace
}  // namespace tightflip::properties
