#include "random_gluings.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using testing::nth;
using testing::RandomGluings;
using Table = std::vector<HalfedgeRecord>;

// ---- tables to try every flip of ----

std::vector<Index> key(const Table& table) {
    std::vector<Index> key;
    for (const auto& [next, origin] : table)
        key.insert(key.end(), {next.id, origin.id});
    return key;
}

/// The tables that flips reach from a start, at most `limit` of them. Nothing here depends on what
/// a flip is, only on its giving another table.
std::vector<Table> reached_from(const Table& start, std::size_t limit) {
    std::vector<Table> tables{start};
    std::set<std::vector<Index>> seen{key(start)};
    for (std::size_t next = 0; next < tables.size() && tables.size() < limit; ++next) {
        for (Index e = 0; e < static_cast<Index>(start.size() / 2); ++e) {
            Table table = tables[next];
            if (flip(table, Edge{e}) && seen.insert(key(table)).second) {
                tables.push_back(std::move(table));
            }
        }
    }
    return tables;
}

template <class Visit>
void for_each_edge_of_small_tables(Visit&& visit) {
    for (const Gluing& gluing :
         {testing::two_face_sphere(), testing::tetrahedron(), testing::book(2), testing::book(3),
          testing::octahedron(), testing::seven_vertex_torus()}) {
        for (const Table& table : reached_from(RandomGluings::halfedge_table(gluing), 400)) {
            for (Index e = 0; e < static_cast<Index>(table.size() / 2); ++e) {
                visit(table, Edge{e});
                if (::testing::Test::HasFatalFailure()) return;
            }
        }
    }
}

Halfedge next(const Table& table, Halfedge h) {
    return nth(table, h.id).next;
}
Vertex origin(const Table& table, Halfedge h) {
    return nth(table, h.id).origin;
}
Vertex opposite(const Table& table, Halfedge h) {
    return origin(table, next(table, next(table, h)));
}
std::array<Index, 3> corners(const Table& table, Halfedge h) {
    const Halfedge n = next(table, h);
    return {origin(table, h).id, origin(table, n).id, origin(table, next(table, n)).id};
}

/// The definition in permutations: `next` conjugated by the 4-cycle that leads each of the four
/// outer halfedges to the following one, and two labels.
Table conjugated(const Table& table, Edge e) {
    const Halfedge h = halfedge_of(e);
    const Halfedge t = twin(h);
    const std::array<Halfedge, 4> outer{next(table, h), next(table, next(table, h)), next(table, t),
                                        next(table, next(table, t))};
    std::map<Halfedge, Halfedge> cycle;
    for (Index x = 0; x < static_cast<Index>(table.size()); ++x)
        cycle[{x}] = {x};
    for (std::size_t i = 0; i < 4; ++i)
        cycle[outer[i]] = outer[(i + 1) % 4];

    Table result = table;
    for (const auto& [x, image] : cycle)
        nth(result, image.id).next = cycle[next(table, x)];
    nth(result, h.id).origin = opposite(table, t);
    nth(result, t.id).origin = opposite(table, h);
    return result;
}

// ---- what a flip does ----

TEST(Flip, IsDefinedExactlyWhereTheOppositeCornersDiffer) {
    int refused = 0;
    for_each_edge_of_small_tables([&](const Table& table, Edge e) {
        const bool differ =
            opposite(table, halfedge_of(e)) != opposite(table, twin(halfedge_of(e)));
        Table flipped = table;
        Table unflipped = table;
        const FlipVerdict verdict = flip(flipped, e);
        const FlipVerdict reverse = unflip(unflipped, e);
        ASSERT_EQ(static_cast<bool>(can_flip(table, e)), differ);
        ASSERT_EQ(static_cast<bool>(verdict), differ);
        ASSERT_EQ(static_cast<bool>(reverse), differ);
        ASSERT_EQ(can_flip(table, e), verdict);
        ASSERT_EQ(verdict.refusal(),
                  differ ? FlipRefusal::none : FlipRefusal::opposite_corners_coincide);
        ASSERT_EQ(flipped == table, !differ) << "a refused flip must leave the table untouched";
        ASSERT_EQ(unflipped == table, !differ);
        refused += differ ? 0 : 1;
    });
    EXPECT_GT(refused, 100);
}

TEST(Flip, ConjugatesNextByOneFourCycle) {
    for_each_edge_of_small_tables([](const Table& table, Edge e) {
        Table flipped = table;
        if (!flip(flipped, e)) return;
        ASSERT_EQ(flipped, conjugated(table, e));
    });
}

TEST(Flip, MakesTheTwoFacesOfTheOtherDiagonal) {
    for_each_edge_of_small_tables([](const Table& table, Edge e) {
        const Halfedge h = halfedge_of(e);
        const auto [a, b, c] = corners(table, h);
        const Index d = opposite(table, twin(h)).id;
        Table flipped = table;
        if (!flip(flipped, e)) return;
        ASSERT_EQ(corners(flipped, h), (std::array{d, c, a}));
        ASSERT_EQ(corners(flipped, twin(h)), (std::array{c, d, b}));
    });
}

TEST(Flip, KeepsEveryOtherHalfedgeItsOriginAndAllButTwoFacesTheirSides) {
    for_each_edge_of_small_tables([](const Table& table, Edge e) {
        const Halfedge h = halfedge_of(e);
        const std::set<Halfedge> touched{
            h,       next(table, h),       next(table, next(table, h)),
            twin(h), next(table, twin(h)), next(table, next(table, twin(h)))};
        Table flipped = table;
        if (!flip(flipped, e)) return;
        for (Index x = 0; x < static_cast<Index>(table.size()); ++x) {
            if (edge_of(Halfedge{x}) != e) {
                ASSERT_EQ(origin(flipped, {x}), origin(table, {x}));
            }
            if (!touched.contains({x})) {
                ASSERT_EQ(next(flipped, {x}), next(table, {x}));
            }
        }
    });
}

TEST(Flip, StaysInsideTheAllowedClass) {
    for_each_edge_of_small_tables([](const Table& table, Edge e) {
        Index vertex_count = 0;
        for (const HalfedgeRecord& r : table)
            vertex_count = std::max(vertex_count, r.origin.id + 1);
        Table flipped = table;
        if (!flip(flipped, e)) return;
        const AuditReport before = audit(HalfedgeTable(table), vertex_count);
        const AuditReport after = audit(HalfedgeTable(flipped), vertex_count);
        ASSERT_TRUE(after.is_valid());
        ASSERT_EQ(after.topology, before.topology);
    });
}

TEST(Flip, HasOrderFour) {
    for_each_edge_of_small_tables([](const Table& table, Edge e) {
        Table flipped = table;
        if (!flip(flipped, e)) return;
        ASSERT_TRUE(flip(flipped, e));
        ASSERT_NE(flipped, table);

        // Twice: as if the two halfedges of the edge had exchanged their numbers.
        const Halfedge h = halfedge_of(e);
        const auto exchanged = [&](Halfedge x) { return edge_of(x) == e ? twin(x) : x; };
        for (Index x = 0; x < static_cast<Index>(table.size()); ++x) {
            const auto& [next_of_x, origin_of_x] = nth(table, x);
            ASSERT_EQ(nth(flipped, exchanged({x}).id),
                      (HalfedgeRecord{exchanged(next_of_x), origin_of_x}));
        }
        ASSERT_EQ(origin(flipped, h), origin(table, twin(h)));

        ASSERT_TRUE(flip(flipped, e));
        ASSERT_TRUE(flip(flipped, e));
        ASSERT_EQ(flipped, table);
    });
}

TEST(Flip, IsUndoneByUnflipBitForBit) {
    for_each_edge_of_small_tables([](const Table& table, Edge e) {
        Table there_and_back = table;
        if (!flip(there_and_back, e)) return;
        ASSERT_TRUE(unflip(there_and_back, e));
        ASSERT_EQ(there_and_back, table);
        ASSERT_TRUE(unflip(there_and_back, e));
        ASSERT_NE(there_and_back, table);
        ASSERT_TRUE(flip(there_and_back, e));
        ASSERT_EQ(there_and_back, table);
    });
}

TEST(Flip, IsUndoneAlongALongRandomScript) {
    RandomStream random(77);
    const Table start = RandomGluings::halfedge_table(testing::seven_vertex_torus());
    Table table = start;
    std::vector<Edge> script;
    for (int k = 0; k < 5000; ++k) {
        const Edge e{static_cast<Index>(random.below(21))};
        if (flip(table, e)) script.push_back(e);
    }
    EXPECT_NE(table, start);
    while (!script.empty()) {
        ASSERT_TRUE(unflip(table, script.back()));
        script.pop_back();
    }
    EXPECT_EQ(table, start);
}

TEST(Flip, IsNeverDefinedOnThreeVertices) {
    const Table table = RandomGluings::halfedge_table(testing::two_face_sphere());
    for (Index e = 0; e < 3; ++e)
        EXPECT_FALSE(can_flip(table, Edge{e}));
}

TEST(FlipRefusal, ExplainsItself) {
    EXPECT_TRUE(describe(FlipRefusal::none).empty());
    EXPECT_THAT(std::string(describe(FlipRefusal::opposite_corners_coincide)),
                ::testing::HasSubstr("loop"));
}

TEST(Quadrilateral, NamesTheSixHalfedgesOfTheTwoFaces) {
    for_each_edge_of_small_tables([](const Table& table, Edge e) {
        const auto q = Quadrilateral::around(table, e);
        ASSERT_EQ(q.h, halfedge_of(e));
        ASSERT_EQ(q.t, twin(q.h));
        ASSERT_EQ(next(table, q.h), q.h1);
        ASSERT_EQ(next(table, q.h1), q.h2);
        ASSERT_EQ(next(table, q.h2), q.h);
        ASSERT_EQ(next(table, q.t), q.t1);
        ASSERT_EQ(next(table, q.t1), q.t2);
        ASSERT_EQ(next(table, q.t2), q.t);
    });
}

// ---- the degenerate case of Alboul et al., Figures 12 and 13 ----

class DegenerateCase : public ::testing::Test {
protected:
    // The star of V1 is made of the faces V1V2V3, V1V3V4 and V1V4V2; beyond V2V3 lies V2V5V3.
    static constexpr Vertex V1{0}, V2{1}, V3{2}, V4{3}, V5{4};
    using Corners = std::array<Vertex, 3>;

    Triangulation surface =
        build(testing::FaceList{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 4, 2}, {4, 1, 3}, {2, 4, 3}},
              5)
            .value();

    [[nodiscard]] std::vector<Edge> edges_between(Vertex a, Vertex b) const {
        std::vector<Edge> edges;
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            if (surface.origin({h}) == a && surface.target({h}) == b) {
                edges.push_back(edge_of({h}));
            }
        }
        return edges;
    }
    [[nodiscard]] Edge edge_between(Vertex a, Vertex b) const {
        const std::vector<Edge> edges = edges_between(a, b);
        EXPECT_EQ(edges.size(), 1U);
        return edges.front();
    }
    [[nodiscard]] Index valence(Vertex v) const {
        Index valence = 0;
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            valence += surface.origin({h}) == v ? 1 : 0;
        }
        return valence;
    }
    /// Whether the two faces at an edge are these, each up to rotation.
    [[nodiscard]] bool lies_between(Edge e, const Corners& first, const Corners& second) const {
        const auto is = [&](Halfedge h, const Corners& face) {
            Corners there{surface.origin(h), surface.target(h), surface.opposite(h)};
            for (int turn = 0; turn < 3; ++turn) {
                if (there == face) return true;
                std::rotate(there.begin(), there.begin() + 1, there.end());
            }
            return false;
        };
        const Halfedge h = halfedge_of(e);
        return (is(h, first) && is(twin(h), second)) || (is(h, second) && is(twin(h), first));
    }
    [[nodiscard]] Edge edge_between_faces(const Corners& first, const Corners& second) const {
        for (Index e = 0; e < surface.edge_count(); ++e) {
            if (lies_between({e}, first, second)) return {e};
        }
        ADD_FAILURE() << "the two faces have no common edge";
        return {};
    }
    [[nodiscard]] std::set<Vertex> link_of(Vertex v) const {
        std::set<Vertex> link;
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            if (surface.origin({h}) == v) link.insert(surface.target({h}));
        }
        return link;
    }
};

TEST_F(DegenerateCase, StartsWithAVertexOfValenceThree) {
    EXPECT_EQ(valence(V1), 3);
    EXPECT_EQ(link_of(V1), (std::set{V2, V3, V4}));
    EXPECT_TRUE(lies_between(edge_between(V2, V3), {V1, V2, V3}, {V2, V5, V3}));
    EXPECT_EQ(audit(surface).is_simple(), true);
}

TEST_F(DegenerateCase, SwappingV1V4GluesTwoTrianglesTogetherAndDoublesV2V3) {
    ASSERT_TRUE(surface.flip(edge_between(V1, V4)));

    EXPECT_EQ(valence(V1), 2);
    EXPECT_EQ(edges_between(V2, V3).size(), 2U) << "two different edges with the same ends";
    // The faces V1V3V2 and V1V2V3 have two common edges, and V2V3 is neither of them.
    EXPECT_TRUE(lies_between(edge_between(V1, V2), {V1, V3, V2}, {V1, V2, V3}));
    EXPECT_TRUE(lies_between(edge_between(V1, V3), {V1, V3, V2}, {V1, V2, V3}));
    EXPECT_TRUE(edge_between_faces({V1, V3, V2}, {V2, V3, V4}).is_valid());
    EXPECT_TRUE(edge_between_faces({V1, V2, V3}, {V2, V5, V3}).is_valid());

    const AuditReport report = audit(surface);
    EXPECT_TRUE(report.is_valid());
    EXPECT_EQ(report.topology.euler_characteristic, 2);
    EXPECT_EQ(report.is_simple(), false);
}

TEST_F(DegenerateCase, SwappingV1V2OrV1V3IsThenRefused) {
    ASSERT_TRUE(surface.flip(edge_between(V1, V4)));
    for (const Edge e : {edge_between(V1, V2), edge_between(V1, V3)}) {
        const Triangulation before = surface;
        EXPECT_EQ(surface.can_flip(e).refusal(), FlipRefusal::opposite_corners_coincide);
        EXPECT_FALSE(surface.flip(e));
        EXPECT_FALSE(surface.unflip(e));
        EXPECT_EQ(surface, before);
    }
}

TEST_F(DegenerateCase, SwappingTheEdgeTowardsV5RestoresValenceThree) {
    ASSERT_TRUE(surface.flip(edge_between(V1, V4)));
    ASSERT_TRUE(surface.flip(edge_between_faces({V1, V2, V3}, {V2, V5, V3})));

    EXPECT_EQ(valence(V1), 3);
    EXPECT_EQ(link_of(V1), (std::set{V2, V3, V5}));
    EXPECT_EQ(edges_between(V2, V3).size(), 1U);
    const AuditReport report = audit(surface);
    EXPECT_TRUE(report.is_valid());
    EXPECT_EQ(report.is_simple(), true);
}

}  // namespace
}  // namespace tightflip::kernel
