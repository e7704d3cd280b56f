#include "naive_audit.hpp"
#include "printing.hpp"
#include "random_gluings.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>

#include <limits>
#include <optional>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using enum ViolationCode;
using testing::nth;
using testing::RandomGluings;
using Table = std::vector<HalfedgeRecord>;

Table table_of(const Gluing& gluing) {
    return RandomGluings::halfedge_table(gluing);
}
Index edge_count(const Table& table) {
    return static_cast<Index>(table.size() / 2);
}

std::vector<Gluing> valid_surfaces() {
    return {testing::two_face_sphere(),
            testing::tetrahedron(),
            testing::book(2),
            testing::book(3),
            testing::octahedron(),
            testing::torus_grid(),
            testing::seven_vertex_torus()};
}

// ---- reading a table as a gluing ----

TEST(ReadTable, NumbersFacesByTheirSmallestHalfedge) {
    for (const Gluing& gluing : valid_surfaces()) {
        const Table table = table_of(gluing);
        const TableReading reading = read_table(table, gluing.vertex_count);
        EXPECT_TRUE(reading.violations.empty());
        EXPECT_EQ(reading.gluing, RandomGluings::gluing_of(table, gluing.vertex_count));
    }
}

TEST(ReadTable, GivesAnEmptyGluingWhereTheTableIsNone) {
    Table table = table_of(testing::tetrahedron());
    table[7].next = {7};
    const TableReading reading = read_table(table, 4);
    EXPECT_FALSE(reading.violations.empty());
    EXPECT_TRUE(reading.gluing.faces.empty());
}

/// What the definition of a table asks: `next` a permutation with cycles of three, an even number
/// of halfedges, everything named exists.
bool is_table_of_triangles(const Table& table, Index vertex_count) {
    const auto count = static_cast<Index>(table.size());
    if (count % 2 != 0) return false;
    std::set<Index> images;
    for (Index h = 0; h < count; ++h) {
        const auto& [next, origin] = nth(table, h);
        if (next.id < 0 || next.id >= count || next.id == h) return false;
        if (origin.id < 0 || origin.id >= vertex_count) return false;
        images.insert(next.id);
    }
    for (Index h = 0; h < count; ++h) {
        const Index n = nth(table, h).next.id;
        if (nth(table, nth(table, n).next.id).next.id != h) return false;
    }
    return images.size() == table.size();
}

TEST(AuditOfTables, AgreesWithTheNaiveAuditOnDamagedTables) {
    RandomGluings random(4242);
    int unreadable = 0;
    int invalid = 0;
    int valid = 0;
    for (int run = 0; run < 6000 && !HasFailure(); ++run) {
        const Gluing start = random.flipped();
        Table table = table_of(start);
        const auto any = [&] { return random.below(static_cast<Index>(table.size())); };
        for (Index faults = random.below(4); faults > 0; --faults) {
            HalfedgeRecord& record = nth(table, any());
            switch (random.below(5)) {
                case 0:
                    record.next = {random.below(static_cast<Index>(table.size()) + 2) - 1};
                    break;
                case 1:
                    record.origin = {random.below(start.vertex_count + 2) - 1};
                    break;
                case 2:
                    std::swap(record.origin, nth(table, any()).origin);
                    break;
                case 3:
                    std::swap(record.next, nth(table, any()).next);
                    break;
                default:
                    // Reglues: the two halfedges exchange their places, and so their twins.
                    const Halfedge a{any()};
                    const Halfedge b{any()};
                    const auto moved = [&](Halfedge h) { return h == a ? b : h == b ? a : h; };
                    Table reglued = table;
                    for (Index h = 0; h < static_cast<Index>(table.size()); ++h) {
                        nth(reglued, moved({h}).id) = {moved(nth(table, h).next),
                                                       nth(table, h).origin};
                    }
                    table = reglued;
            }
        }
        const AuditReport report =
            audit(HalfedgeTable(table), start.vertex_count, {.max_per_code = 1000});
        const bool readable = is_table_of_triangles(table, start.vertex_count);
        EXPECT_EQ(read_table(table, start.vertex_count).violations.empty(), readable);
        if (!readable) {
            ++unreadable;
            EXPECT_FALSE(report.is_valid());
            EXPECT_FALSE(report.reached_top);
            for (const Violation& v : report.violations) {
                EXPECT_GE(v.code, halfedge_count_odd);
                EXPECT_LE(v.code, origin_out_of_range);
            }
            continue;
        }
        const Gluing gluing = RandomGluings::gluing_of(table, start.vertex_count);
        const testing::NaiveAudit naive(gluing);
        testing::NaiveAudit::Places places;
        for (const Violation& v : report.violations) {
            places[v.code].insert(v.code == not_orientable ? -1 : v.place);
        }
        EXPECT_EQ(places, naive.places);
        EXPECT_EQ(report.topology, naive.topology);
        // A table is oriented: whatever turns over shows as a contradiction to that as well.
        if (report.has(not_orientable)) {
            EXPECT_TRUE(report.has(coherence_bit_contradicts_labels));
        }
        (report.is_valid() ? valid : invalid) += 1;
    }
    EXPECT_GT(unreadable, 500);
    EXPECT_GT(invalid, 500);
    EXPECT_GT(valid, 500);
}

TEST(AuditOfTables, SurvivesGarbage) {
    RandomGluings random(13);
    for (int run = 0; run < 4000; ++run) {
        Table table(static_cast<std::size_t>(random.below(13)));
        for (auto& [next, origin] : table) {
            next = {random.below(20) == 0 ? std::numeric_limits<Index>::min()
                                          : random.below(static_cast<Index>(table.size()) + 1)};
            origin = {random.below(20) == 0 ? std::numeric_limits<Index>::max() : random.below(4)};
        }
        const AuditReport report = audit(HalfedgeTable(table), 4);
        EXPECT_EQ(report.reached_top, !table.empty() && is_table_of_triangles(table, 4));
    }
    EXPECT_TRUE(audit(HalfedgeTable{}, 0).has(no_faces));
    EXPECT_FALSE(audit(HalfedgeTable{}, -1).is_valid());
    EXPECT_FALSE(
        audit(table_of(testing::tetrahedron()), std::numeric_limits<Index>::min()).is_valid());
    EXPECT_FALSE(
        audit(table_of(testing::tetrahedron()), std::numeric_limits<Index>::max()).is_valid());
}

TEST(AuditOfTables, KeepsTheFirstOfEachCode) {
    Table table = table_of(testing::octahedron());
    for (HalfedgeRecord& record : table)
        record.next = {-1};
    table.back().origin = {99};
    const AuditReport report = audit(HalfedgeTable(table), 6, {.max_per_code = 2});
    EXPECT_EQ(report.violation_count, 25);
    ASSERT_EQ(report.violations.size(), 3U);
    EXPECT_EQ(report.violations[0].place, 0);
    EXPECT_EQ(report.violations[1].place, 1);
    EXPECT_EQ(report.violations[2].code, origin_out_of_range);
    EXPECT_EQ(report.violations[2].place, 23);
    EXPECT_TRUE(audit(HalfedgeTable(table), 6, {.max_per_code = 0}).violations.empty());
}

// ---- the constant-time look at one edge ----

TEST(AuditAtEdge, FindsNothingOnValidSurfaces) {
    RandomGluings random(8);
    std::vector<Gluing> surfaces = valid_surfaces();
    for (int k = 0; k < 500; ++k)
        surfaces.push_back(random.flipped());
    for (const Gluing& gluing : surfaces) {
        const Table table = table_of(gluing);
        for (Index e = 0; e < edge_count(table); ++e) {
            EXPECT_EQ(audit_at_edge(table, gluing.vertex_count, {e}), std::nullopt);
        }
    }
}

TEST(AuditAtEdge, ReportsEachCodeItKnows) {
    const Table good = table_of(testing::tetrahedron());  // the face of halfedge 0 is 0, 2, 4
    const auto after = [&](auto change) {
        Table table = good;
        change(table);
        return audit_at_edge(table, 4, Edge{0});
    };
    EXPECT_EQ(after([](Table& t) { t[2].next = {12}; }), next_out_of_range);
    EXPECT_EQ(after([](Table& t) { t[0].next = {-1}; }), next_out_of_range);
    EXPECT_EQ(after([](Table& t) { t[3].next = {-1}; }), next_out_of_range) << "behind the face";
    EXPECT_EQ(after([](Table& t) { t[4].origin = {4}; }), origin_out_of_range);
    EXPECT_EQ(after([](Table& t) { t[4].next = {2}; }), next_cycle_not_triangle);
    EXPECT_EQ(after([](Table& t) { t[0].next = {0}; }), next_cycle_not_triangle);
    EXPECT_EQ(after([](Table& t) { t[4].origin = t[0].origin; }), corners_not_distinct);
    EXPECT_EQ(after([](Table& t) { t[4].origin = {3}; }), labels_disagree);

    const Table spheres = table_of(testing::disjoint_two_face_spheres());
    for (Index e = 0; e < edge_count(spheres); ++e) {
        EXPECT_EQ(audit_at_edge(spheres, 6, {e}), three_neighbour_rule_broken);
    }
}

TEST(AuditAtEdge, LooksAtTheFacesOnBothSides) {
    const Table good = table_of(testing::octahedron());
    const auto q = Quadrilateral::around(good, Edge{0});
    for (const Halfedge h : {q.h1, q.t1}) {
        Table table = good;
        nth(table, h.id).next = h;
        EXPECT_EQ(audit_at_edge(table, 6, Edge{0}), next_cycle_not_triangle);
    }
}

/// Every other value a field could have, in and just out of range, at one halfedge.
template <class Visit>
void for_each_corruption(const Table& good, Index vertex_count, Halfedge h, Visit&& visit) {
    Table table = good;
    HalfedgeRecord& record = nth(table, h.id);
    const HalfedgeRecord before = record;
    for (Index value = -2; value < static_cast<Index>(good.size()) + 2; ++value) {
        if (before.next.id == value) continue;
        record = {{value}, before.origin};
        visit(table);
    }
    for (Index value = -2; value < vertex_count + 2; ++value) {
        if (before.origin.id == value) continue;
        record = {before.next, {value}};
        visit(table);
    }
}

TEST(AuditAtEdge, SeesEveryCorruptedFieldOfTheTwoFaces) {
    int corruptions = 0;
    for (const Gluing& gluing : valid_surfaces()) {
        const Table good = table_of(gluing);
        for (Index e = 0; e < edge_count(good); ++e) {
            const auto q = Quadrilateral::around(good, {e});
            for (const Halfedge h : {q.h, q.h1, q.h2, q.t, q.t1, q.t2}) {
                for_each_corruption(good, gluing.vertex_count, h, [&](const Table& bad) {
                    ++corruptions;
                    ASSERT_TRUE(audit_at_edge(bad, gluing.vertex_count, {e}));
                    ASSERT_FALSE(audit(HalfedgeTable(bad), gluing.vertex_count).is_valid());
                });
            }
        }
    }
    EXPECT_GT(corruptions, 10000);
}

TEST(AuditAtEdge, SeesBehindTheOuterSidesOnlyWhichVerticesTheyJoin) {
    // At the twins of the four outer sides a false origin is seen; a false `next` is not where it
    // leads to another halfedge that leaves the same vertex. The full audit sees all.
    int unseen = 0;
    for (const Gluing& gluing : {testing::octahedron(), testing::book(3), testing::torus_grid()}) {
        const Table good = table_of(gluing);
        for (Index e = 0; e < edge_count(good); ++e) {
            const auto q = Quadrilateral::around(good, {e});
            const std::set<Halfedge> inner{q.h, q.h1, q.h2, q.t, q.t1, q.t2};
            for (const Halfedge outer : {q.h1, q.h2, q.t1, q.t2}) {
                const Halfedge h = twin(outer);
                if (inner.contains(h)) continue;
                const HalfedgeRecord before = nth(good, h.id);
                for_each_corruption(good, gluing.vertex_count, h, [&](const Table& bad) {
                    const HalfedgeRecord now = nth(bad, h.id);
                    const bool same_start =
                        now.origin == before.origin && now.next.id >= 0 &&
                        now.next.id < static_cast<Index>(good.size()) &&
                        nth(good, now.next.id).origin == nth(good, before.next.id).origin;
                    const bool seen = audit_at_edge(bad, gluing.vertex_count, {e}).has_value();
                    ASSERT_NE(seen, same_start);
                    ASSERT_FALSE(audit(HalfedgeTable(bad), gluing.vertex_count).is_valid());
                    unseen += seen ? 0 : 1;
                });
            }
        }
    }
    EXPECT_GT(unseen, 0);
}

TEST(AuditAtEdge, SeesAFlipThatForgotAnyOfItsEightWrites) {
    int seen = 0;
    for (const Gluing& gluing : {testing::octahedron(), testing::torus_grid()}) {
        const Table before = table_of(gluing);
        for (Index e = 0; e < edge_count(before); ++e) {
            Table after = before;
            if (!flip(after, Edge{e})) continue;
            for (std::size_t h = 0; h < before.size(); ++h) {
                for (const bool forget_next : {true, false}) {
                    Table bad = after;
                    if (forget_next) {
                        bad[h].next = before[h].next;
                    } else {
                        bad[h].origin = before[h].origin;
                    }
                    if (bad == after) continue;
                    ++seen;
                    ASSERT_TRUE(audit_at_edge(bad, gluing.vertex_count, {e}));
                }
            }
        }
    }
    EXPECT_EQ(seen, 8 * (12 + 27));
}

}  // namespace
}  // namespace tightflip::kernel
