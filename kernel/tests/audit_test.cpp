#include "naive_audit.hpp"
#include "printing.hpp"
#include "random_gluings.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/allowed_class.hpp>
#include <tightflip/kernel/audit.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {

namespace {

using enum ViolationCode;
using testing::NaiveAudit;
using ::testing::PrintToString;
using testing::RandomGluings;

constexpr AuditOptions keep_all{.max_per_code = 1000};

// ---- the allowed class ----

TEST(AllowedClass, WantsThreeDistinctCorners) {
    static_assert(corners_are_distinct(0, 1, 2));
    for (const auto& [a, b, c] : testing::FaceList{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {2, 2, 2}}) {
        EXPECT_FALSE(corners_are_distinct(a, b, c));
    }
    EXPECT_TRUE(corners_are_distinct(Vertex{4}, Vertex{0}, Vertex{2}));
}

TEST(AllowedClass, LetsTwoNeighboursCoincideButNotThree) {
    EXPECT_TRUE(three_neighbour_rule(0, 1, 2, 3, false));
    EXPECT_TRUE(three_neighbour_rule(0, 1, 1, 3, false));
    EXPECT_TRUE(three_neighbour_rule(0, 1, 3, 1, false));
    EXPECT_TRUE(three_neighbour_rule(0, 3, 1, 1, false));
    EXPECT_FALSE(three_neighbour_rule(0, 1, 1, 1, false));
    EXPECT_TRUE(three_neighbour_rule(0, 1, 1, 1, true)) << "the sphere of two faces";
    for (const bool is_two_face_sphere : {false, true}) {
        EXPECT_FALSE(three_neighbour_rule(0, 0, 1, 2, is_two_face_sphere)) << "its own neighbour";
        EXPECT_FALSE(three_neighbour_rule(0, 1, 0, 2, is_two_face_sphere));
        EXPECT_FALSE(three_neighbour_rule(0, 1, 2, 0, is_two_face_sphere));
    }
}

TEST(AllowedClass, AllowsAFlipExactlyBetweenDistinctOppositeCorners) {
    EXPECT_TRUE(flip_keeps_corners_distinct(2, 3));
    EXPECT_FALSE(flip_keeps_corners_distinct(2, 2));
}

// ---- known surfaces ----

struct Known {
    const char* name;
    Gluing gluing;
    bool valid;
    bool closed_surface;
    std::optional<bool> simple;  ///< empty where the question makes no sense
    Topology topology;
};

Topology topology(Index v, Index e, Index f, Index components, bool orientable,
                  std::optional<Index> genus) {
    return {v, e, f, components, v - e + f, orientable, genus};
}

std::vector<Known> known_surfaces() {
    using std::nullopt;
    using namespace testing;  // NOLINT: the makers of the surfaces
    return {
        {"tetrahedron", tetrahedron(), true, true, true, topology(4, 6, 4, 1, true, 0)},
        {"octahedron", octahedron(), true, true, true, topology(6, 12, 8, 1, true, 0)},
        {"two faces", two_face_sphere(), true, true, false, topology(3, 3, 2, 1, true, 0)},
        {"book of 1", book(1), true, true, false, topology(3, 3, 2, 1, true, 0)},
        {"book of 2", book(2), true, true, false, topology(4, 6, 4, 1, true, 0)},
        {"book of 3", book(3), true, true, false, topology(5, 9, 6, 1, true, 0)},
        {"torus grid", torus_grid(), true, true, true, topology(9, 27, 18, 1, true, 1)},
        {"Möbius torus", seven_vertex_torus(), true, true, true, topology(7, 21, 14, 1, true, 1)},
        {"projective plane", projective_plane(), false, true, true,
         topology(6, 15, 10, 1, false, 1)},
        {"Klein bottle", klein_bottle(), false, true, true, topology(16, 48, 32, 1, false, 2)},
        {"triangle", lone_triangle(), false, false, std::nullopt,
         topology(3, 3, 1, 1, true, nullopt)},
        {"disc", disc(), false, false, true, topology(5, 8, 4, 1, true, nullopt)},
        {"Möbius strip", moebius_strip(), false, false, true,
         topology(5, 10, 5, 1, false, nullopt)},
        {"pinched", pinched_tetrahedra(), false, false, true, topology(7, 12, 8, 2, true, nullopt)},
        {"common edge", tetrahedra_sharing_an_edge(), false, false, false,
         topology(6, 12, 8, 2, true, nullopt)},
        {"disjoint", disjoint_tetrahedra(), false, false, true,
         topology(8, 12, 8, 2, true, nullopt)},
        {"looped", looped_tetrahedron(), false, false, false, topology(3, 6, 4, 1, true, nullopt)},
    };
}

TEST(Audit, KnowsWhatKnownSurfacesAre) {
    for (const Known& known : known_surfaces()) {
        SCOPED_TRACE(known.name);
        const AuditReport report = audit(known.gluing);
        EXPECT_TRUE(report.reached_top);
        EXPECT_EQ(report.is_valid(), known.valid);
        EXPECT_EQ(report.is_closed_surface(), known.closed_surface);
        if (known.simple) {
            EXPECT_EQ(report.is_simple(), known.simple);
        }
        EXPECT_EQ(report.topology.vertices, known.topology.vertices);
        EXPECT_EQ(report.topology.edges, known.topology.edges);
        EXPECT_EQ(report.topology.faces, known.topology.faces);
        EXPECT_EQ(report.topology.components, known.topology.components);
        EXPECT_EQ(report.topology.euler_characteristic, known.topology.euler_characteristic);
        EXPECT_EQ(report.topology.orientable, known.topology.orientable);
        EXPECT_EQ(report.topology.genus, known.topology.genus);
        EXPECT_EQ(report.topology, known.topology);
        EXPECT_EQ(report.violation_count == 0, report.violations.empty());
    }
}

TEST(Audit, CountsDegreesAndParallelEdges) {
    const AuditReport book = audit(testing::book(3));
    EXPECT_EQ(book.degrees, (DegreeStatistics{.min = 2, .max = 6, .degree_two_vertices = 3}));
    EXPECT_EQ(book.parallels,
              (ParallelStatistics{.loops = 0, .pairs_joined_twice = 1, .max_multiplicity = 3}));
    const AuditReport octahedron = audit(testing::octahedron());
    EXPECT_EQ(octahedron.degrees, (DegreeStatistics{4, 4, 0}));
    EXPECT_EQ(octahedron.parallels, (ParallelStatistics{0, 0, 1}));
    // An edge 0-1 of the tetrahedron became a loop, the two edges from each end a pair.
    const AuditReport looped = audit(testing::looped_tetrahedron());
    EXPECT_EQ(looped.parallels, (ParallelStatistics{1, 2, 2}));
    EXPECT_EQ(looped.degrees, (DegreeStatistics{3, 6, 0}));
}

TEST(Audit, LeavesOutStatisticsNobodyWants) {
    const AuditReport report = audit(testing::book(3), {.statistics = false});
    EXPECT_TRUE(report.is_valid());
    EXPECT_FALSE(report.degrees);
    EXPECT_FALSE(report.parallels);
    EXPECT_FALSE(report.is_simple());
    EXPECT_EQ(report.topology, audit(testing::book(3)).topology);
}

TEST(Audit, KeepsTheFirstOfEachCodeAndCountsAll) {
    const Gluing gluing =
        testing::beside(testing::disc(), testing::relabelled(testing::disc(), {5, 6, 7, 8, 9}, 12));
    const AuditReport report = audit(gluing, {.max_per_code = 3});
    EXPECT_EQ(report.violation_count, 8 + 2 + 2);  // open sides, unused vertices, connectedness
    std::vector<std::pair<ViolationCode, Index>> kept;
    for (const Violation& v : report.violations)
        kept.emplace_back(v.code, v.place);
    const std::vector<std::pair<ViolationCode, Index>> expected{{side_unglued, 1},
                                                                {side_unglued, 4},
                                                                {side_unglued, 7},
                                                                {vertex_unused, 10},
                                                                {vertex_unused, 11},
                                                                {vertices_not_connected, -1},
                                                                {faces_not_strongly_connected, -1}};
    EXPECT_EQ(kept, expected);
    EXPECT_TRUE(report.has(vertex_unused));
    EXPECT_FALSE(report.has(not_orientable));

    const AuditReport none = audit(gluing, {.max_per_code = 0});
    EXPECT_EQ(none.violation_count, report.violation_count);
    EXPECT_TRUE(none.violations.empty());
    EXPECT_FALSE(none.is_valid());
}

TEST(Audit, DoesNotLetOneFaultHideAnother) {
    // An open edge, a pinched vertex, an unused vertex and a reversed strip in one gluing.
    Gluing gluing =
        testing::beside(testing::pinched_tetrahedra(),
                        testing::relabelled(testing::moebius_strip(), {7, 8, 9, 10, 11}, 13));
    const AuditReport report = audit(gluing);
    for (const ViolationCode code :
         {side_unglued, vertex_unused, vertex_with_several_fans, vertices_not_connected,
          faces_not_strongly_connected, not_orientable}) {
        EXPECT_TRUE(report.has(code)) << name(code);
    }
}

TEST(Audit, EndsTheClimbOnlyAtTablesThatNameWhatDoesNotExist) {
    Gluing gluing = testing::tetrahedron();
    gluing.vertex_count = 5;
    EXPECT_TRUE(audit(gluing).reached_top);
    gluing.faces[0].corners[0] = 77;
    const AuditReport report = audit(gluing);
    EXPECT_FALSE(report.reached_top);
    EXPECT_FALSE(report.has(vertex_unused));
    EXPECT_FALSE(report.topology.genus);
    EXPECT_FALSE(report.is_closed_surface());
}

// ---- the stored direction of a side is never believed ----

TEST(Audit, DoesNotBelieveTheCoherenceBit) {
    for (const Known& known : known_surfaces()) {
        SCOPED_TRACE(known.name);
        const AuditReport honest = audit(known.gluing);
        for (Index s = 0; s < testing::side_count(known.gluing); ++s) {
            if (!testing::side(known.gluing, s).is_glued()) continue;
            const bool loop =
                testing::start_of(known.gluing, s) == testing::end_of(known.gluing, s);
            if (loop) continue;
            Gluing lying = known.gluing;
            testing::invert_bit(lying, s);
            const AuditReport report = audit(lying);
            EXPECT_TRUE(report.has(coherence_bit_contradicts_labels));
            EXPECT_EQ(report.violation_count, honest.violation_count + 1);
            EXPECT_EQ(report.topology.orientable, honest.topology.orientable);
            EXPECT_EQ(report.topology.euler_characteristic, honest.topology.euler_characteristic);
            EXPECT_EQ(report.topology.components, honest.topology.components);
            EXPECT_EQ(report.topology.edges, honest.topology.edges);
            EXPECT_EQ(report.coherently_stored, honest.coherently_stored);
            EXPECT_EQ(report.degrees, honest.degrees);
            EXPECT_EQ(report.parallels, honest.parallels);
        }
    }
}

TEST(Audit, TakesAFaceTurnedOverForWhatItIs) {
    for (const Known& known : known_surfaces()) {
        SCOPED_TRACE(known.name);
        if (known.topology.faces < 2) continue;
        const AuditReport straight = audit(known.gluing);
        const AuditReport turned = audit(testing::with_face_turned_over(known.gluing, 1));
        EXPECT_EQ(turned.topology, straight.topology);
        EXPECT_EQ(turned.violation_count, straight.violation_count);
        EXPECT_EQ(straight.coherently_stored, known.topology.orientable);
        EXPECT_FALSE(turned.coherently_stored);
    }
}

TEST(Audit, AsksTheBitOnlyOnALoopWhereLabelsCannotTell) {
    // Side 0 of the looped tetrahedron runs from vertex 0 to vertex 0.
    Gluing reversed = testing::looped_tetrahedron();
    ASSERT_EQ(testing::side(reversed, 0).side(), 5);
    testing::invert_bit(reversed, 0);
    EXPECT_TRUE(audit(reversed).has(gluing_not_involution))
        << "the two sides contradict each other";
    testing::invert_bit(reversed, 5);
    const AuditReport report = audit(reversed);
    EXPECT_FALSE(report.has(gluing_not_involution));
    EXPECT_FALSE(report.has(coherence_bit_contradicts_labels));
    EXPECT_NE(report.topology.orientable, audit(testing::looped_tetrahedron()).topology.orientable);
}

// ---- against the naive audit ----

void expect_agreement(const Gluing& gluing) {
    const AuditReport report = audit(gluing, keep_all);
    const NaiveAudit naive(gluing);
    SCOPED_TRACE(PrintToString(gluing));

    NaiveAudit::Places places;
    for (const Violation& v : report.violations) {
        places[v.code].insert(v.code == not_orientable ? -1 : v.place);
    }
    EXPECT_EQ(places, naive.places);
    EXPECT_EQ(report.violation_count, static_cast<std::int64_t>(report.violations.size()));
    EXPECT_EQ(report.is_valid(), naive.places.empty());
    EXPECT_EQ(report.reached_top, naive.well_formed);
    if (!naive.well_formed) return;

    EXPECT_EQ(report.topology, naive.topology);
    EXPECT_EQ(report.coherently_stored, naive.coherently_stored);
    EXPECT_EQ(report.degrees, naive.degrees);
    EXPECT_EQ(report.parallels, naive.parallels);
    for (const Violation& v : report.violations) {
        switch (v.code) {
            case vertex_with_several_fans:
                EXPECT_EQ(v.found, naive.fans.at(v.place));
                break;
            case faces_not_strongly_connected:
                EXPECT_EQ(v.witness, naive.component_sizes);
                break;
            case vertices_not_connected:
                EXPECT_EQ(v.witness, naive.part_sizes);
                break;
            case not_orientable:
                EXPECT_TRUE(testing::reverses_orientation(gluing, v.witness))
                    << PrintToString(v.witness);
                break;
            default:
                break;
        }
    }
}

/// How many of the gluings a test looked at were of each kind: a test that never meets a kind
/// proves nothing about it.
struct Met {
    int valid = 0;
    int closed_only = 0;
    int broken_tables = 0;
    std::set<ViolationCode> codes;

    void count(const Gluing& gluing) {
        const AuditReport report = audit(gluing, {.statistics = false});
        valid += report.is_valid() ? 1 : 0;
        closed_only += report.is_closed_surface() && !report.is_valid() ? 1 : 0;
        broken_tables += report.reached_top ? 0 : 1;
        for (const Violation& v : report.violations)
            codes.insert(v.code);
    }
};

TEST(AuditAgainstNaive, AgreesOnHandMadeSurfaces) {
    for (const Known& known : known_surfaces())
        expect_agreement(known.gluing);
}

TEST(AuditAgainstNaive, AgreesOnHonestGluings) {
    RandomGluings random(20240901);
    Met met;
    for (int run = 0; run < 3000 && !HasFailure(); ++run) {
        const Gluing gluing = random.honest();
        met.count(gluing);
        expect_agreement(gluing);
    }
    EXPECT_GT(met.valid, 500);
    EXPECT_GT(met.closed_only, 100);
    EXPECT_FALSE(met.codes.contains(coherence_bit_contradicts_labels));
}

TEST(AuditAgainstNaive, AgreesOnGluingsWithAFewFaults) {
    RandomGluings random(7102);
    Met met;
    for (int run = 0; run < 8000 && !HasFailure(); ++run) {
        Gluing gluing = random.honest();
        for (Index faults = 1 + random.below(3); faults > 0; --faults)
            random.damage(gluing);
        met.count(gluing);
        expect_agreement(gluing);
    }
    EXPECT_GT(met.valid, 50);
    for (const ViolationCode code :
         {corner_out_of_range, side_glued_to_itself, gluing_not_involution, side_unglued,
          labels_disagree, coherence_bit_contradicts_labels, corners_not_distinct,
          three_neighbour_rule_broken, vertex_unused, vertex_with_several_fans,
          vertices_not_connected, faces_not_strongly_connected, not_orientable}) {
        EXPECT_TRUE(met.codes.contains(code)) << name(code);
    }
}

TEST(AuditAgainstNaive, AgreesOnGarbage) {
    RandomGluings random(666);
    Met met;
    for (int run = 0; run < 6000 && !HasFailure(); ++run) {
        const Gluing gluing = random.garbage();
        met.count(gluing);
        expect_agreement(gluing);
    }
    EXPECT_GT(met.broken_tables, 1000);
    for (const ViolationCode code : {no_faces, corner_out_of_range, gluing_out_of_range,
                                     more_vertices_than_corners, vertex_unused}) {
        EXPECT_TRUE(met.codes.contains(code)) << name(code);
    }
}

// ---- which codes imply one another ----

TEST(ViolationCodes, ImplyOneAnotherAsDocumented) {
    RandomGluings random(31);
    std::map<std::string, int> met;
    for (int run = 0; run < 20000 && !HasFailure(); ++run) {
        Gluing gluing = random.honest();
        for (Index faults = random.below(3); faults > 0; --faults)
            random.damage(gluing);
        const AuditReport report = audit(gluing, {.max_per_code = 1, .statistics = false});
        SCOPED_TRACE(PrintToString(gluing));
        if (!report.reached_top) continue;
        if (report.has(vertices_not_connected)) {
            ++met["parts"];
            EXPECT_TRUE(report.has(faces_not_strongly_connected));
        } else if (report.has(faces_not_strongly_connected)) {
            ++met["components"];
            EXPECT_TRUE(report.has(vertex_with_several_fans));
        }
        if (report.has(three_neighbour_rule_broken)) {
            ++met["three"];
            EXPECT_TRUE(report.has(corners_not_distinct) ||
                        report.has(faces_not_strongly_connected));
        }
    }
    EXPECT_GT(met["parts"], 100);
    EXPECT_GT(met["components"], 100);
    EXPECT_GT(met["three"], 100);
}

}  // namespace
}  // namespace tightflip::kernel
