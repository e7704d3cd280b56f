#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/generators.hpp>
#include <tightflip/properties/googletest.hpp>

#include <gtest/gtest.h>

namespace tightflip::properties {

void PrintTo(const Finding& finding, std::ostream* out) {
    *out << describe(finding);
}

namespace {

using kernel::RandomStream;

struct NamedStart {
    std::string name;
    Triangulation surface;
};

/// Every kind, with every genus up to 3 where it has any, at its least size and above; so simple
/// graphs and multigraphs both.
std::vector<NamedStart> starts(std::initializer_list<Index> sizes_above_least) {
    std::vector<NamedStart> found;
    for (const StartKind& kind : start_kinds()) {
        for (Index genus = 0; genus <= (kind.any_genus ? 3 : 0); ++genus) {
            for (const Index spare : sizes_above_least) {
                const StartRequest request{
                    .vertices = kind.least_vertices(genus) + spare, .genus = genus, .seed = 11};
                found.push_back({std::string(kind.name) + ", V near " +
                                     std::to_string(request.vertices) + ", genus " +
                                     std::to_string(genus),
                                 make_nearest(kind, request)});
            }
        }
    }
    return found;
}

FlipScript script_for(const Triangulation& surface, std::size_t length) {
    RandomStream random(static_cast<std::uint64_t>(surface.edge_count()));
    return random_script(surface, length, random);
}

std::optional<Finding> topology_after_every_flip(const Triangulation& start,
                                                 std::span<const Edge> script) {
    return topology_is_preserved(start, script);
}

TEST(Theorem42, HoldsOfRandomSequencesWithAFullAuditAfterEveryFlip) {
    for (const auto& [name, surface] : starts({0, 1, 2, 9, 24})) {
        EXPECT_HOLDS(topology_after_every_flip, surface, script_for(surface, 500)) << name;
    }
}

TEST(Theorem42, HoldsOnALargeSphereAndALargeSurfaceOfGenusThree) {
    constexpr std::size_t attempts = 2'000'000;
    for (const Index genus : {0, 3}) {
        const Triangulation surface = kernel::families::surface_of_genus(genus, 100'000, 1);
        EXPECT_EQ(topology_is_preserved(surface, script_for(surface, attempts), attempts / 8),
                  std::nullopt)
            << "genus " << genus;
    }
}

TEST(ReferenceModelClaim, HoldsOfRandomSequences) {
    for (const auto& [name, surface] : starts({0, 1, 5})) {
        EXPECT_HOLDS(reference_model_agrees, surface, script_for(surface, 150)) << name;
    }
}

TEST(FlipLaws, HoldOfRandomSequences) {
    for (const auto& [name, surface] : starts({0, 1, 9})) {
        EXPECT_HOLDS(flip_laws_hold, surface, script_for(surface, 300)) << name;
    }
}

TEST(LogClaim, HoldsOfRandomSequences) {
    for (const auto& [name, surface] : starts({0, 1, 9})) {
        EXPECT_HOLDS(log_reproduces_run, surface, script_for(surface, 200)) << name;
    }
}

TEST(Claims, HoldOfTheEmptyScript) {
    const Triangulation surface = kernel::families::book(3);
    for (const auto claim : {reference_model_agrees, flip_laws_hold, log_reproduces_run}) {
        EXPECT_EQ(claim(surface, {}), std::nullopt);
    }
    EXPECT_EQ(topology_is_preserved(surface, {}, 0), std::nullopt);
}

}  // namespace
}  // namespace tightflip::properties
