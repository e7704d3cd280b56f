#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/certificate.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/find_path.hpp>
#include <tightflip/kernel/gluing_enumeration.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {

static void PrintTo(PathOutcome outcome, std::ostream* out) {
    *out << name(outcome);
}

namespace {

using ::testing::HasSubstr;

constexpr Equality labelled{.labels = Labels::kept, .mirror = Mirror::distinct};
constexpr Equality unlabelled{.labels = Labels::ignored, .mirror = Mirror::distinct};

/// A surface with its distance from where it was reached.
struct Reached {
    Triangulation surface;
    std::size_t distance = 0;
};

/// Everything that flips of a surface lead to, by plain breadth-first search, nearest first.
std::vector<Reached> component_of(const Triangulation& start) {
    std::vector<Reached> all{{start, 0}};
    std::set<CanonicalCode> seen{canonical_code(start, labelled)};
    for (std::size_t k = 0; k < all.size(); ++k) {
        for (Index e = 0; e < start.edge_count(); ++e) {
            Triangulation flipped = all[k].surface;
            if (!flipped.flip({e}) || !seen.insert(canonical_code(flipped, labelled)).second) {
                continue;
            }
            all.push_back({std::move(flipped), all[k].distance + 1});
        }
    }
    return all;
}

/// One of each class among them.
std::vector<Triangulation> classes_among(const std::vector<Reached>& component) {
    std::map<CanonicalCode, Triangulation> classes;
    for (const Reached& reached : component)
        classes.try_emplace(canonical_code(reached.surface, unlabelled), reached.surface);
    std::vector<Triangulation> one_of_each;
    one_of_each.reserve(classes.size());
    for (const auto& [code, surface] : classes)
        one_of_each.push_back(surface);
    return one_of_each;
}

/// The surface with two vertices exchanged.
Triangulation with_labels_exchanged(const Triangulation& surface, Index a, Index b) {
    std::vector<HalfedgeRecord> records(surface.table().begin(), surface.table().end());
    for (auto& [next, origin] : records)
        origin.id = origin.id == a ? b : origin.id == b ? a : origin.id;
    return build(std::move(records), surface.vertex_count()).value();
}

/// The length of a shortest path, which must lead from the one to the other.
std::size_t shortest(const Triangulation& from, const Triangulation& to) {
    const PathSearch search = find_path(from, to, {.shortest = true});
    EXPECT_EQ(search.outcome, PathOutcome::found);
    if (!search) return std::numeric_limits<std::size_t>::max();
    EXPECT_EQ(search.path->start, from);
    const CertificateVerdict verdict = verify(from, to, *search.path);
    EXPECT_TRUE(verdict) << verdict.reason;
    return search.path->flips.size();
}

// ---- shortest paths ----

struct Known {
    const char* what;
    Triangulation start;
    std::size_t classes;
    std::size_t surfaces;  // here and below 0 where no value is known from elsewhere
    std::size_t diameter;
};

/// Distances from one surface of every class give all there are: labels may be renamed.
TEST(FindPath, AllDistancesOfSmallSurfacesAreThoseOfPlainSearch) {
    for (const auto& [what, start, classes, surfaces, diameter] :
         {Known{"sphere, V = 4", families::tetrahedron(), 2, 8, 2},
          Known{"sphere, V = 5", families::book(5), 4, 160, 6},
          Known{"torus, V = 4", families::random(4, 1, 1), 7, 0, 0}}) {
        SCOPED_TRACE(what);
        const std::vector<Reached> all = component_of(start);
        if (surfaces != 0) {
            EXPECT_EQ(all.size(), surfaces);
        }
        const std::vector<Triangulation> sources = classes_among(all);
        EXPECT_EQ(sources.size(), classes);
        std::size_t greatest = 0;
        for (const Triangulation& source : sources) {
            for (const auto& [target, distance] : component_of(source)) {
                ASSERT_EQ(shortest(source, target), distance);
                greatest = std::max(greatest, distance);
            }
        }
        if (diameter != 0) {
            EXPECT_EQ(greatest, diameter);
        }
    }
}

TEST(FindPath, FarthestPairsOfSixVerticesAreTenFlipsApart) {
    const std::vector<Triangulation> sources = classes_among(component_of(families::book(6)));
    EXPECT_EQ(sources.size(), 14U);
    RandomStream random(1);
    std::size_t greatest = 0;
    for (const Triangulation& source : sources) {
        const std::vector<Reached> all = component_of(source);
        EXPECT_EQ(all.size(), 5280U);
        greatest = std::max(greatest, shortest(source, all.back().surface));
        EXPECT_EQ(shortest(source, all.back().surface), all.back().distance);
        for (int k = 0; k < 5; ++k) {
            const auto& [target, distance] =
                all[random.below(static_cast<std::uint32_t>(all.size()))];
            EXPECT_EQ(shortest(source, target), distance);
        }
    }
    EXPECT_EQ(greatest, 10U);
}

/// How many are within so many flips of where they were reached from.
std::size_t count_within(const std::vector<Reached>& component, std::size_t distance) {
    const auto is_near = [&](const Reached& reached) { return reached.distance <= distance; };
    return static_cast<std::size_t>(std::ranges::count_if(component, is_near));
}

TEST(FindPath, SeesNothingTwiceAndNothingBeyondTheMiddle) {
    for (const Triangulation& source : classes_among(component_of(families::book(6)))) {
        const std::vector<Reached> near = component_of(source);
        const auto& [target, distance] = near.back();
        const std::size_t most = count_within(near, distance / 2) +
                                 count_within(component_of(target), distance - distance / 2);
        const PathSearch search = find_path(source, target, {.shortest = true});
        EXPECT_GE(search.states, 700U) << "enough for the table of states to grow";
        EXPECT_LE(search.states, most);
    }
}

TEST(FindPath, TheTetrahedronIsTurnedInsideOutByTwoFlips) {
    const Triangulation tetrahedron = families::tetrahedron();
    EXPECT_EQ(shortest(tetrahedron, with_labels_exchanged(tetrahedron, 0, 3)), 2U);
    EXPECT_EQ(shortest(tetrahedron, tetrahedron), 0U);
}

TEST(FindPath, IsNoLongerThanAWayThatIsKnown) {
    RandomStream random(2);
    for (const Index genus : {0, 1, 2}) {
        const Triangulation start = families::random(12, genus, 7);
        Triangulation end = start;
        std::size_t flips = 0;
        while (flips < 4) {
            const Edge e{
                static_cast<Index>(random.below(static_cast<std::uint32_t>(start.edge_count())))};
            if (end.flip(e)) ++flips;
        }
        EXPECT_LE(shortest(start, end), 4U);
        EXPECT_EQ(shortest(end, start), shortest(start, end));
    }
}

// ---- paths that need not be short ----

TEST(FindPath, SpheresAreConnectedByConstruction) {
    const Triangulation from = families::random(300, 0, 1);
    const Triangulation to = families::random(300, 0, 2);
    const PathSearch search = find_path(from, to);
    ASSERT_EQ(search.outcome, PathOutcome::found);
    EXPECT_EQ(search.states, 0U);
    EXPECT_TRUE(verify(from, to, *search.path));
}

// ---- no path ----

TEST(FindPath, SurfacesWithoutADefinedFlipAreIsolated) {
    for (const Index genus : {3, 4}) {
        const Triangulation surface = families::surface_of_genus(genus, 3, 0);
        Triangulation other = surface;
        for (std::uint64_t seed = 1;
             canonical_code(other, labelled) == canonical_code(surface, labelled); ++seed) {
            ASSERT_LT(seed, 100U);
            other = families::surface_of_genus(genus, 3, seed);
        }
        const PathSearch search = find_path(surface, other);
        EXPECT_EQ(search.outcome, PathOutcome::isolated);
        EXPECT_FALSE(search);
    }
}

TEST(FindPath, TheTwoClassesOfGenusTwoWithThreeVerticesAreIsolated) {
    std::map<CanonicalCode, Triangulation> classes;
    enumerate_gluings(3, 2, [&](HalfedgeTable table) {
        const Triangulation surface = build({table.begin(), table.end()}, 3).value();
        classes.try_emplace(canonical_code(surface, unlabelled), surface);
        return true;
    });
    ASSERT_EQ(classes.size(), 2U);
    const Triangulation& one = classes.begin()->second;
    const Triangulation& other = classes.rbegin()->second;
    EXPECT_EQ(find_path(one, other).outcome, PathOutcome::isolated);
    EXPECT_EQ(find_path(other, one).outcome, PathOutcome::isolated);
    EXPECT_EQ(find_path(one, one).outcome, PathOutcome::found);
}

TEST(FindPath, ASurfaceWithoutADefinedFlipIsConnectedToItself) {
    // The torus with three vertices is one surface, however it is labelled.
    const Triangulation torus = families::surface_of_genus(1, 3, 1);
    EXPECT_EQ(shortest(torus, with_labels_exchanged(torus, 0, 1)), 0U);
    EXPECT_EQ(shortest(families::book(3), families::book(3)), 0U);
}

TEST(FindPath, FlipsKeepVerticesAndGenus) {
    for (const bool ask_for_shortest : {false, true}) {
        const PathOptions options{.shortest = ask_for_shortest};
        EXPECT_EQ(find_path(families::book(5), families::book(6), options).outcome,
                  PathOutcome::ends_differ);
        EXPECT_EQ(find_path(families::random(6, 1, 1), families::book(6), options).outcome,
                  PathOutcome::ends_differ);
    }
}

// ---- undecided ----

TEST(FindPath, SaysWhenALimitWasReached) {
    const Triangulation from = families::book(7);
    const Triangulation to = families::random(7, 0, 3);
    const std::size_t length = shortest(from, to);
    ASSERT_GE(length, 6U);
    std::size_t states = 0;
    std::int64_t least = 0;
    for (const std::size_t limit : {0U, 10U, 100U, 1000U}) {
        const PathSearch search = find_path(from, to, {.shortest = true, .most_states = limit});
        ASSERT_EQ(search.outcome, PathOutcome::not_found) << limit;
        EXPECT_FALSE(search);
        EXPECT_LE(search.states, std::max<std::size_t>(limit, 2));
        EXPECT_GE(search.states, states);
        EXPECT_GE(search.least_length, least);
        EXPECT_LE(search.least_length, static_cast<std::int64_t>(length));
        states = search.states;
        least = search.least_length;
    }
    EXPECT_GE(states, 500U);
    EXPECT_GE(least, 3);
    const PathSearch little = find_path(from, to, {.shortest = true, .most_bytes = 100'000});
    EXPECT_EQ(little.outcome, PathOutcome::not_found);
    EXPECT_GT(little.states, 100U);
    EXPECT_LT(little.states, 2000U);
}

TEST(FindPath, NeverAsksForMoreFlipsThanAreNeeded) {
    const Triangulation from = families::book(5);
    for (const auto& [to, distance] : component_of(from)) {
        if (distance == 0 || distance > 3) continue;
        PathOptions options{.shortest = true, .most_states = 0};
        PathSearch search = find_path(from, to, options);
        for (; !search; search = find_path(from, to, options)) {
            EXPECT_GE(search.least_length, 1);
            EXPECT_LE(search.least_length, static_cast<std::int64_t>(distance));
            options.most_states += 10;
        }
        EXPECT_EQ(search.path->flips.size(), distance);
    }
}

TEST(FindPath, StopsWhenAskedTo) {
    int asked = 0;
    const PathSearch search =
        find_path(families::book(7), families::random(7, 0, 3),
                  {.shortest = true, .interrupted = [&] { return ++asked == 20; }});
    EXPECT_EQ(search.outcome, PathOutcome::interrupted);
    EXPECT_FALSE(search);
    EXPECT_EQ(asked, 20);
    EXPECT_GT(search.states, 20U);
}

TEST(FindPath, OutcomesHaveNamesAndWords) {
    std::set<std::string_view> names;
    std::set<std::string_view> words;
    for (int code = 0; code <= 5; ++code) {
        names.insert(name(static_cast<PathOutcome>(code)));
        words.insert(describe(static_cast<PathOutcome>(code)));
    }
    EXPECT_EQ(names.size(), 6U);
    EXPECT_EQ(words.size(), 6U);
    EXPECT_EQ(name(PathOutcome::found), "found");
    EXPECT_EQ(name(PathOutcome::isolated), "isolated");
    EXPECT_EQ(name(PathOutcome::not_connected), "not_connected");
    EXPECT_EQ(name(PathOutcome::ends_differ), "ends_differ");
    EXPECT_THAT(std::string(describe(PathOutcome::isolated)), HasSubstr("no path"));
}

}  // namespace
}  // namespace tightflip::kernel
