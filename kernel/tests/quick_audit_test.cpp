#include <tightflip/kernel/audit_ladder.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/quick_audit.hpp>
#include <tightflip/kernel/random.hpp>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using Records = std::vector<HalfedgeRecord>;

Records records_of(const Triangulation& surface) {
    return {surface.table().begin(), surface.table().end()};
}

/// The quick answer must be the ladder's, whatever the table.
::testing::AssertionResult agrees(const Records& records, Index vertex_count) {
    const bool ladder =
        climb_audit_ladder(HalfedgeTable(records), vertex_count, {.statistics = false}).is_valid();
    const bool quick = passes_audit(records, vertex_count);
    if (ladder == quick) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "ladder " << ladder << ", quick " << quick;
}

std::vector<Triangulation> small_surfaces() {
    return {families::book(3),          families::tetrahedron(),
            families::book(7),          families::double_wheel(9),
            families::octasphere(2),    families::random(40, 0, 1),
            families::torus_grid(3, 4), families::surface_of_genus(2, 3, 1),
            families::random(20, 3, 2)};
}

/// Two surfaces in one table, the vertices of the second renamed by `vertex_of`.
template <class VertexOf>
Records side_by_side(const Triangulation& a, const Triangulation& b, VertexOf vertex_of) {
    Records records = records_of(a);
    for (const auto [next, origin] : b.table()) {
        records.push_back({{next.id + a.halfedge_count()}, {vertex_of(origin.id)}});
    }
    return records;
}

TEST(QuickAudit, PassesWhatTheLadderPasses) {
    for (const Triangulation& surface : small_surfaces()) {
        EXPECT_TRUE(passes_audit(surface.table(), surface.vertex_count()));
        EXPECT_TRUE(agrees(records_of(surface), surface.vertex_count()));
    }
}

TEST(QuickAudit, RefusesTablesOfImpossibleSizes) {
    EXPECT_FALSE(passes_audit({}, 0));
    EXPECT_FALSE(passes_audit({}, 3));
    Records records = records_of(families::tetrahedron());
    for (const Index vertices : {-1, 0, 3, 5, 13, 1'000'000'000}) {
        EXPECT_FALSE(passes_audit(records, vertices)) << vertices;
    }
    records.pop_back();
    EXPECT_FALSE(passes_audit(records, 4));
}

TEST(QuickAudit, AgreesWithTheLadderOnEveryChangeOfOneEntry) {
    for (const Triangulation& surface : small_surfaces()) {
        if (surface.halfedge_count() > 60) continue;
        const Index vertices = surface.vertex_count();
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            Records records = records_of(surface);
            HalfedgeRecord& record = records[static_cast<std::size_t>(h)];
            const HalfedgeRecord good = record;
            for (Index next = -2; next <= surface.halfedge_count(); ++next) {
                record.next = {next};
                EXPECT_TRUE(agrees(records, vertices)) << "next of " << h << " = " << next;
            }
            record = good;
            for (Index origin = -2; origin <= vertices; ++origin) {
                record.origin = {origin};
                EXPECT_TRUE(agrees(records, vertices)) << "origin of " << h << " = " << origin;
            }
        }
    }
}

TEST(QuickAudit, AgreesWithTheLadderOnExchangedEntries) {
    RandomStream random(11);
    for (const Triangulation& surface : small_surfaces()) {
        const auto count = static_cast<std::uint32_t>(surface.halfedge_count());
        for (int trial = 0; trial < 300; ++trial) {
            Records records = records_of(surface);
            for (auto left = 1 + random.below(3); left > 0; --left) {
                HalfedgeRecord& a = records[random.below(count)];
                HalfedgeRecord& b = records[random.below(count)];
                if (random.below(2) == 0) std::swap(a.next, b.next);
                if (random.below(2) == 0) std::swap(a.origin, b.origin);
            }
            EXPECT_TRUE(agrees(records, surface.vertex_count()));
        }
    }
}

TEST(QuickAudit, AgreesWithTheLadderWhenTwoVerticesAreCalledOne) {
    // Pinched vertices, loops and gaps in the labels, on tables that are else in order.
    int closed = 0;
    for (const Triangulation& surface : small_surfaces()) {
        for (Index a = 0; a < surface.vertex_count(); ++a) {
            for (Index b = 0; b < a; ++b) {
                Records records = records_of(surface);
                for (HalfedgeRecord& record : records) {
                    if (record.origin.id == a) record.origin.id = b;
                }
                EXPECT_FALSE(passes_audit(records, surface.vertex_count()));
                EXPECT_TRUE(agrees(records, surface.vertex_count()));
                for (HalfedgeRecord& record : records) {  // without the gap
                    if (record.origin.id == surface.vertex_count() - 1) record.origin.id = a;
                }
                EXPECT_FALSE(passes_audit(records, surface.vertex_count() - 1));
                EXPECT_TRUE(agrees(records, surface.vertex_count() - 1));
                ++closed;
            }
        }
    }
    EXPECT_GT(closed, 100);
}

TEST(QuickAudit, RefusesTwoSurfacesSideBySide) {
    const Triangulation a = families::octasphere(1);
    const Triangulation b = families::torus_grid(3, 3);
    const Index both = a.vertex_count() + b.vertex_count();
    const Records apart = side_by_side(a, b, [&](Index v) { return v + a.vertex_count(); });
    const Records at_a_vertex =
        side_by_side(a, b, [&](Index v) { return v == 0 ? 0 : v + a.vertex_count() - 1; });
    const Records same_labels = side_by_side(b, b, [](Index v) { return v; });
    EXPECT_FALSE(passes_audit(apart, both));
    EXPECT_FALSE(passes_audit(at_a_vertex, both - 1));
    EXPECT_FALSE(passes_audit(same_labels, b.vertex_count()));
    EXPECT_TRUE(agrees(apart, both));
    EXPECT_TRUE(agrees(at_a_vertex, both - 1));
    EXPECT_TRUE(agrees(same_labels, b.vertex_count()));
}

TEST(QuickAudit, RefusesLoops) {
    // The torus of one vertex: two triangles, one fan, connected; but its three edges are loops.
    const Records torus{{{2}, {0}}, {{3}, {0}}, {{4}, {0}}, {{5}, {0}}, {{0}, {0}}, {{1}, {0}}};
    EXPECT_FALSE(passes_audit(torus, 1));
    EXPECT_TRUE(agrees(torus, 1));
}

TEST(QuickAudit, LeavesNoTraceInTheReport) {
    for (const Triangulation& surface : small_surfaces()) {
        const AuditReport quick = audit(surface, {.statistics = false});
        const AuditReport ladder =
            climb_audit_ladder(surface.table(), surface.vertex_count(), {.statistics = false});
        EXPECT_EQ(quick.topology, ladder.topology);
        EXPECT_EQ(quick.reached_top, ladder.reached_top);
        EXPECT_EQ(quick.coherently_stored, ladder.coherently_stored);
        EXPECT_EQ(quick.violation_count, ladder.violation_count);
        EXPECT_EQ(quick.degrees, ladder.degrees);
        EXPECT_EQ(quick.parallels, ladder.parallels);
    }
}

constexpr std::array<HalfedgeRecord, 6> two_face_sphere{
    {{{2}, {0}}, {{5}, {1}}, {{4}, {1}}, {{1}, {2}}, {{0}, {2}}, {{3}, {0}}}};
static_assert(passes_audit(two_face_sphere, 3));
static_assert(!passes_audit(two_face_sphere, 4));
static_assert(!passes_audit(two_face_sphere, 2));

/// The two-face sphere with one record put in its place; reading outside the tables would not
/// compile.
constexpr bool passes_with(std::size_t h, HalfedgeRecord record) {
    std::array<HalfedgeRecord, 6> records = two_face_sphere;
    records[h] = record;
    return passes_audit(records, 3);
}
static_assert(passes_with(1, {{5}, {1}}));
static_assert(!passes_with(0, {{2}, {3}}));
static_assert(!passes_with(0, {{2}, {-1}}));
static_assert(!passes_with(0, {{6}, {0}}));
static_assert(!passes_with(0, {{-1}, {0}}));
static_assert(!passes_with(5, {{6}, {0}}));

}  // namespace
}  // namespace tightflip::kernel
