#include "failures_directory.hpp"
#include "false_claim.hpp"
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

template <class T>
T drawn(const rc::Gen<T>& gen, std::uint64_t seed, int size = rc::kNominalSize) {
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
template <class T, class Fails>
T shrunk(rc::Shrinkable<T> shrinkable, Fails&& fails) {
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

TEST(AnyFlipCase, KeepsToTheGraphTheGenusAndTheSizeAskedFor) {
    struct Row {
        GraphKind graph;
        Index genus;
        Index vertices;
    };
    for (const auto& [graph, genus, vertices] :
         {Row{GraphKind::simple, 0, 4}, Row{GraphKind::simple, 1, 9}, Row{GraphKind::simple, 2, 20},
          Row{GraphKind::multigraph, 0, 3}, Row{GraphKind::multigraph, 1, 3},
          Row{GraphKind::multigraph, 4, 12}, Row{GraphKind::any, 0, 14},
          Row{GraphKind::any, 3, 7}}) {
        const FlipCaseLimits limits{
            .graph = graph, .exact_genus = genus, .exact_vertices = vertices};
        std::set<std::string_view> kinds;
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const FlipCase flip_case = drawn(any_flip_case(limits), seed);
            const kernel::AuditReport report = audit(flip_case.start());
            EXPECT_EQ(report.topology.genus, genus);
            EXPECT_EQ(report.topology.vertices, vertices);
            if (graph != GraphKind::any) {
                EXPECT_EQ(report.is_simple(), graph == GraphKind::simple);
            }
            kinds.insert(flip_case.kind->name);
        }
        EXPECT_GE(kinds.size(), 2U) << genus << ", " << vertices;
    }
}

TEST(AnyFlipCase, ShrinksWithinItsLimits) {
    const FlipCaseLimits limits{.graph = GraphKind::multigraph, .exact_genus = 2};
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        EXPECT_EQ(describe(shrunk(any_flip_case(limits)(rc::Random(seed), rc::kNominalSize),
                                  [](const FlipCase&) { return true; })),
                  "genus, V = 3, genus 2, seed 0, E = 15; flips none");
    }
}

TEST(AnySurface, IsTheStartOfACase) {
    const FlipCaseLimits limits{.graph = GraphKind::simple, .exact_genus = 1, .exact_vertices = 12};
    const Triangulation surface = drawn(any_surface(limits), 5);
    EXPECT_EQ(surface.genus(), 1);
    EXPECT_EQ(surface.vertex_count(), 12);
    EXPECT_THAT(rc::toString(surface), ::testing::StartsWith("tightflip-triangulation"));
}

// ---- scripts ----

TEST(AnyScript, NamesEdgesOfItsStartAndShrinksToTheFewestAndLowest) {
    const Triangulation start = FlipCase{}.start();
    const auto has_two_flips = [](const FlipScript& script) {
        return std::ranges::count_if(script, [](Edge e) { return e.id >= 1; }) >= 2;
    };
    int tried = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto shrinkable = any_script(start, 30)(rc::Random(seed), rc::kNominalSize);
        for (const Edge e : shrinkable.value())
            EXPECT_LT(e.id, start.edge_count());
        EXPECT_LE(shrinkable.value().size(), 30U);
        if (!has_two_flips(shrinkable.value())) continue;
        ++tried;
        EXPECT_EQ(shrunk(shrinkable, has_two_flips), (FlipScript{{1}, {1}}));
    }
    EXPECT_GT(tried, 10);
    EXPECT_EQ(rc::toString(FlipScript{{3}, {1}}), "[3, 1]");
}

TEST(AnyDefinedScript, HasNoRefusedFlipAfterAnyShrink) {
    const Triangulation start = make_nearest(*find_start_kind("fan"), {.vertices = 6});
    std::size_t longest = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto defined = [&](const FlipScript& script) {
            return kernel::replay({start, script}).is_complete();
        };
        const auto shrinkable = any_defined_script(start, 40)(rc::Random(seed), rc::kNominalSize);
        longest = std::max(longest, shrinkable.value().size());
        ASSERT_TRUE(defined(shrinkable.value()));
        auto shrinks = shrinkable.shrinks();
        while (const auto candidate = shrinks.next())
            EXPECT_TRUE(defined(candidate->value()));
    }
    EXPECT_GT(longest, 10U);
}

// ---- points and surface cases ----

TEST(AnyPoints, AreOfEveryKindOrOfTheOneAskedFor) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        for (const geometry::Point& point :
             drawn(any_points(9, find_point_kind("subnormal")), seed))
            EXPECT_LT(point.cwiseAbs().maxCoeff(), 1e-300);
        EXPECT_EQ(drawn(any_points(9), seed).size(), 9U);
    }
}

TEST(AnyPoints, ShrinkToFewSmallIntegers) {
    using Points = std::vector<geometry::Point>;
    const auto fails = [](const Points& points) { return points[3].z() < points[1].z(); };
    int tried = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto shrinkable = any_points(6)(rc::Random(seed), rc::kNominalSize);
        if (!fails(shrinkable.value())) continue;
        ++tried;
        Points least(6, geometry::Point::Zero());
        const Points found = shrunk(shrinkable, fails);
        (found[1].z() == 1 ? least[1] : least[3]).z() = found[1].z() == 1 ? 1 : -1;
        EXPECT_EQ(found, least);
    }
    EXPECT_GT(tried, 10);
}

TEST(AnySurfaceCase, CoversEveryKindOfPoints) {
    std::set<std::string_view> kinds;
    for (std::uint64_t seed = 0; seed < 200; ++seed)
        kinds.insert(drawn(any_surface_case(), seed).point_kind->name);
    EXPECT_EQ(kinds.size(), point_kinds().size());
}

TEST(AnySurfaceCase, ShrinksStartScriptAndPoints) {
    // Fails where an edge of different ends is flipped.
    const auto fails = [](const SurfaceCase& surface_case) {
        const geometry::Surface start = surface_case.start();
        return std::ranges::any_of(surface_case.script(), [&](Edge e) {
            const auto h = halfedge_of(e);
            return start.point(start.triangulation().origin(h)) !=
                   start.point(start.triangulation().target(h));
        });
    };
    int tried = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const auto shrinkable = any_surface_case()(rc::Random(seed), rc::kNominalSize);
        if (!fails(shrinkable.value())) continue;
        ++tried;
        const std::string found = describe(shrunk(shrinkable, fails));
        EXPECT_THAT(found, ::testing::StartsWith("tetrahedron, V = 4, genus 0, seed 0, E = 6"));
        EXPECT_THAT(found, ::testing::ContainsRegex("; flips [0-5]; points [01, ]+$"));
        EXPECT_EQ(std::ranges::count(found.substr(found.find("points")), '1'), 1);
    }
    EXPECT_GT(tried, 5);
}

// ---- failing cases ----

TEST(RequireClaim, LeavesTheSmallestFailingCaseAsALogAndNamesIt) {
    const FailuresDirectory directory("require_claim");
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
    EXPECT_THAT(failure.description, ::testing::HasSubstr("\nflip 2: edge 1 joins "));
    ASSERT_EQ(failure.counterExample.size(), 1U);
    EXPECT_EQ(failure.counterExample.front().second,
              "(tetrahedron, V = 4, genus 0, seed 0, E = 6; flips 3 1)");
    const kernel::FlipLog log = kernel::parse_flip_log(kernel::read_file(path), path.string());
    EXPECT_EQ(log.start, FlipCase{}.start());
    EXPECT_EQ(log.flips, (FlipScript{{3}, {1}}));
}

TEST(RequireClaim, ShowsTheCaseAlsoWhereItCannotBeWritten) {
    const FailuresDirectory directory("require_claim_unwritten");
    kernel::write_file(directory.path() / "file", [](std::ostream& out) { out << "no directory"; });
    FailuresDirectory::name_instead(directory.path() / "file");
    const auto result = rc::detail::checkTestable(
        [](const FlipCase& flip_case) {
            require_claim("three_then_one", flip_case, never_three_then_one);
        },
        rc::detail::TestMetadata{}, rc::detail::TestParams{});
    const auto& failure = result.get<rc::detail::FailureResult>();
    EXPECT_THAT(failure.description, ::testing::HasSubstr("\nflip 2: edge 1 joins "));
    EXPECT_THAT(failure.description, ::testing::HasSubstr("\nnot written: "));
    EXPECT_EQ(failure.counterExample.front().second,
              "(tetrahedron, V = 4, genus 0, seed 0, E = 6; flips 3 1)");
}

TEST(RequireClaim, WritesNothingWhereTheClaimHolds) {
    const FailuresDirectory directory("require_claim_holds");
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
