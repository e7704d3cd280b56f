// The flip and the audit evaluated by the compiler: what holds here holds without running anything.
// Clang 14 with the standard library of GCC 12 cannot evaluate std::vector in constant expressions.
#include <gtest/gtest.h>

#if !defined(__clang__)

#include "surfaces.hpp"
#include <tightflip/kernel/audit_ladder.hpp>
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace tightflip::kernel {
namespace {

using enum ViolationCode;

// ---- the audit ----

static_assert(climb_audit_ladder(testing::tetrahedron()).is_valid());
static_assert(climb_audit_ladder(testing::two_face_sphere()).is_valid());
static_assert(climb_audit_ladder(testing::book(3)).is_valid());
static_assert(climb_audit_ladder(testing::octahedron()).is_valid());
static_assert(climb_audit_ladder(testing::seven_vertex_torus()).is_valid());
static_assert(climb_audit_ladder(testing::seven_vertex_torus()).topology.genus == 1);
static_assert(climb_audit_ladder(testing::book(3)).parallels->max_multiplicity == 3);
static_assert(
    climb_audit_ladder(testing::with_face_turned_over(testing::tetrahedron(), 2)).is_valid());

constexpr bool is_refused_for(const Gluing& gluing, ViolationCode code) {
    const AuditReport report = climb_audit_ladder(gluing);
    return !report.is_valid() && report.has(code);
}
static_assert(is_refused_for(Gluing{}, no_faces));
static_assert(is_refused_for(testing::lone_triangle(), side_unglued));
static_assert(is_refused_for(testing::looped_tetrahedron(), corners_not_distinct));
static_assert(is_refused_for(testing::disjoint_two_face_spheres(), three_neighbour_rule_broken));
static_assert(is_refused_for(testing::pinched_tetrahedra(), vertex_with_several_fans));
static_assert(is_refused_for(testing::disjoint_tetrahedra(), vertices_not_connected));
static_assert(is_refused_for(testing::tetrahedra_sharing_an_edge(), faces_not_strongly_connected));
static_assert(is_refused_for(testing::projective_plane(), not_orientable));
static_assert(climb_audit_ladder(testing::projective_plane()).topology.genus == 1);

// ---- every flip of every surface with four vertices that flips reach from the tetrahedron ----

using Table = std::array<HalfedgeRecord, 12>;

/// Face 0 1 2 is 0, 2, 4; the glued pairs are those of the hand-made tetrahedron.
constexpr Table tetrahedron_table() {
    const Gluing gluing = testing::tetrahedron();
    std::array<Index, 12> halfedge{};
    Index edges = 0;
    for (Index s = 0; s < 12; ++s) {
        const Index t = testing::side(gluing, s).side();
        if (t < s) continue;
        testing::nth(halfedge, s) = 2 * edges;
        testing::nth(halfedge, t) = 2 * edges + 1;
        ++edges;
    }
    Table table{};
    for (Index s = 0; s < 12; ++s) {
        testing::nth(table, testing::nth(halfedge, s)) = {
            {testing::nth(halfedge, s - s % 3 + (s + 1) % 3)}, {testing::start_of(gluing, s)}};
    }
    return table;
}

/// The faces, each from its smallest corner, sorted. With four vertices these determine the
/// labelled surface, since no pair of vertices is joined by more than two edges.
using Faces = std::array<Index, 4>;
constexpr Faces faces_of(const Table& table) {
    Faces faces{};
    std::size_t count = 0;
    for (Index h = 0; h < 12; ++h) {
        const Index n = testing::nth(table, h).next.id;
        const Index p = testing::nth(table, n).next.id;
        if (n < h || p < h) continue;
        const std::array<Index, 3> corners{testing::nth(table, h).origin.id,
                                           testing::nth(table, n).origin.id,
                                           testing::nth(table, p).origin.id};
        Index smallest = 1000;
        for (std::size_t i = 0; i < 3; ++i) {
            smallest = std::min(
                smallest, 100 * corners[i] + 10 * corners[(i + 1) % 3] + corners[(i + 2) % 3]);
        }
        faces[count++] = smallest;
    }
    std::ranges::sort(faces);
    return faces;
}

constexpr std::vector<Table> reached_from_tetrahedron() {
    std::vector<Table> tables{tetrahedron_table()};
    std::vector<Faces> seen{faces_of(tables.front())};
    for (std::size_t next = 0; next < tables.size(); ++next) {
        for (Index e = 0; e < 6; ++e) {
            Table table = tables[next];
            if (!flip(table, Edge{e})) continue;
            const Faces faces = faces_of(table);
            if (std::ranges::find(seen, faces) != seen.end()) continue;
            seen.push_back(faces);
            tables.push_back(table);
        }
    }
    return tables;
}

// The tetrahedron, its mirror image, and the six ways to join two of four vertices twice.
static_assert(reached_from_tetrahedron().size() == 8);

template <class Predicate>
constexpr bool holds_for_every_flip(Predicate predicate) {
    for (const Table& table : reached_from_tetrahedron()) {
        for (Index e = 0; e < 6; ++e) {
            if (!predicate(table, Edge{e})) return false;
        }
    }
    return true;
}

static_assert(holds_for_every_flip([](Table table, Edge e) {
    const Table before = table;
    const bool allowed{can_flip(table, e)};
    if (bool{flip(table, e)} != allowed) return false;
    return allowed ? climb_audit_ladder(table, 4).is_valid() && !audit_at_edge(table, 4, e)
                   : table == before;
}));

static_assert(holds_for_every_flip([](Table table, Edge e) {
    const Topology before = climb_audit_ladder(table, 4).topology;
    static_cast<void>(flip(table, e));
    return climb_audit_ladder(table, 4).topology == before;
}));

static_assert(holds_for_every_flip([](Table table, Edge e) {
    const Table before = table;
    if (!flip(table, e)) return true;
    if (!unflip(table, e) || table != before) return false;
    return unflip(table, e) && table != before && flip(table, e) && table == before;
}));

static_assert(holds_for_every_flip([](Table table, Edge e) {
    const Table before = table;
    if (!flip(table, e)) return true;
    for (int more = 0; more < 3; ++more) {
        if (table == before || !flip(table, e)) return false;
    }
    return table == before;
}));

// The other way round: six of the eight have a pair of vertices joined twice and two vertices of
// degree 2; the four edges at those are refused, and nothing else is.
constexpr int refused_flips() {
    int refused = 0;
    for (const Table& table : reached_from_tetrahedron()) {
        for (Index e = 0; e < 6; ++e)
            refused += can_flip(table, Edge{e}) ? 0 : 1;
    }
    return refused;
}
static_assert(refused_flips() == 6 * 4);

// ---- broken tables ----

constexpr bool is_seen_when(void (*break_table)(Table&), ViolationCode code) {
    Table table = tetrahedron_table();
    break_table(table);
    return climb_audit_ladder(table, 4).has(code) && audit_at_edge(table, 4, Edge{0}) == code;
}
static_assert(is_seen_when([](Table& t) { t[0].next = {12}; }, next_out_of_range));
static_assert(is_seen_when([](Table& t) { t[4].next = {2}; }, next_cycle_not_triangle));
static_assert(is_seen_when([](Table& t) { t[4].origin = {4}; }, origin_out_of_range));
static_assert(is_seen_when([](Table& t) { t[4].origin = t[0].origin; }, corners_not_distinct));
static_assert(is_seen_when([](Table& t) { t[4].origin = {3}; }, labels_disagree));

TEST(ConstantExpressions, AgreeWithTheSameCallsAtRunTime) {
    EXPECT_EQ(reached_from_tetrahedron().size(), 8U);
    EXPECT_EQ(refused_flips(), 24);
    EXPECT_TRUE(climb_audit_ladder(tetrahedron_table(), 4).is_valid());
}

}  // namespace
}  // namespace tightflip::kernel

#endif
