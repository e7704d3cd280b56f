// Every code an audit or a builder can report, planted on purpose.
#include "naive_audit.hpp"
#include "printing.hpp"
#include "random_gluings.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/violation.hpp>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using enum ViolationCode;
using testing::FaceList;
using testing::nth;

/// What a planted fault must be reported as. `also` are the codes that cannot be kept away from it.
struct Plant {
    std::string fault;
    std::function<AuditReport()> judge;
    std::vector<Violation> expected;  ///< all of one code; `expected` is not compared
    std::set<ViolationCode> also{};
};

Violation surface(ViolationCode code, std::int64_t found, std::vector<Index> witness = {}) {
    return {.code = code, .found = found, .witness = std::move(witness)};
}
Violation at_side(ViolationCode code, Index place, std::int64_t found,
                  std::vector<Index> witness = {}) {
    return {.code = code,
            .kind = PlaceKind::side,
            .place = place,
            .found = found,
            .witness = std::move(witness)};
}
Violation at_face(ViolationCode code, Index place, std::vector<Index> witness) {
    return {.code = code, .kind = PlaceKind::face, .place = place, .witness = std::move(witness)};
}
Violation at_vertex(ViolationCode code, Index place, std::int64_t found) {
    return {.code = code, .kind = PlaceKind::vertex, .place = place, .found = found};
}
Violation at_halfedge(ViolationCode code, Index place, std::int64_t found) {
    return {.code = code, .kind = PlaceKind::halfedge, .place = place, .found = found};
}

/// The tetrahedron's gluing after a change. Its glued pairs of sides are
/// 0-5 (vertices 0, 1), 1-8 (1, 2), 2-11 (2, 0), 3-10 (0, 3), 4-6 (3, 1) and 7-9 (3, 2).
auto tetrahedron_with(std::function<void(Gluing&)> change) {
    return [change = std::move(change)] {
        Gluing gluing = testing::tetrahedron();
        change(gluing);
        return audit(gluing);
    };
}
auto table_with(std::function<void(std::vector<HalfedgeRecord>&)> change) {
    return [change = std::move(change)] {
        auto table = testing::RandomGluings::halfedge_table(testing::tetrahedron());
        change(table);
        return audit(HalfedgeTable(table), 4);
    };
}
auto gluing(Gluing (*make)()) {
    return [make] { return audit(make()); };
}
auto face_list(FaceList faces, Index vertex_count) {
    return [faces = std::move(faces), vertex_count] { return build(faces, vertex_count).report; };
}

const std::vector<Plant>& plants() {
    static const std::vector<Plant> all{
        {"nothing at all", [] { return audit(Gluing{}); }, {surface(no_faces, 0)}},
        {"vertices without faces",
         [] { return audit(Gluing{.vertex_count = 4, .faces = {}}); },
         {surface(no_faces, 0)}},
        {"a corner that names vertex 9 of 4",
         tetrahedron_with([](Gluing& g) { g.faces[2].corners[1] = 9; }),
         {at_side(corner_out_of_range, 7, 9)},
         {labels_disagree}},
        {"a vertex count that is one too small",
         tetrahedron_with([](Gluing& g) { g.vertex_count = 3; }),
         {at_side(corner_out_of_range, 4, 3), at_side(corner_out_of_range, 7, 3),
          at_side(corner_out_of_range, 10, 3)}},
        {"a corner that names vertex -1",
         tetrahedron_with([](Gluing& g) { g.faces[0].corners[2] = -1; }),
         {at_side(corner_out_of_range, 2, -1)},
         {labels_disagree}},
        {"a side glued to side 12 of 12",
         tetrahedron_with([](Gluing& g) { testing::side(g, 5) = SideGluing::coherent(12); }),
         {at_side(gluing_out_of_range, 5, 12)},
         {gluing_not_involution}},
        {"a side glued to side -1",
         tetrahedron_with([](Gluing& g) { testing::side(g, 5) = SideGluing::reversed(-1); }),
         {at_side(gluing_out_of_range, 5, -1)},
         {gluing_not_involution}},
        {"both sides of an edge glued to sides beyond the last",
         tetrahedron_with([](Gluing& g) {
             testing::side(g, 0) = SideGluing::coherent(1000);
             testing::side(g, 5) = SideGluing::coherent(max_faces);
         }),
         {at_side(gluing_out_of_range, 0, 1000), at_side(gluing_out_of_range, 5, max_faces)}},
        {"13 vertices for 12 corners",
         tetrahedron_with([](Gluing& g) { g.vertex_count = 13; }),
         {surface(more_vertices_than_corners, 13)}},
        {"a table of 13 halfedges",
         table_with([](auto& table) { table.push_back(table.front()); }),
         {surface(halfedge_count_odd, 13)}},
        {"a halfedge followed by halfedge 12 of 12",
         table_with([](auto& table) { table[3].next = {12}; }),
         {at_halfedge(next_out_of_range, 3, 12)}},
        {"a halfedge followed by nothing",
         table_with([](auto& table) { table[3].next = {}; }),
         {at_halfedge(next_out_of_range, 3, -1)}},
        {"a face of one side and a face of five",
         // The face of halfedge 0 is 0 -> 2 -> 4; now 4 follows itself.
         table_with([](auto& table) { table[4].next = {4}; }),
         {at_halfedge(next_cycle_not_triangle, 0, 4), at_halfedge(next_cycle_not_triangle, 2, 4),
          at_halfedge(next_cycle_not_triangle, 4, 4)}},
        {"a halfedge that leaves vertex 4 of 4",
         table_with([](auto& table) { table[11].origin = {4}; }),
         {at_halfedge(origin_out_of_range, 11, 4)}},
        {"a side glued to itself and its neighbour left alone",
         tetrahedron_with([](Gluing& g) {
             testing::side(g, 4) = SideGluing::coherent(4);
             testing::side(g, 6) = {};
         }),
         {at_side(side_glued_to_itself, 4, 4)},
         {side_unglued}},
        {"both sides of an edge glued to themselves",
         tetrahedron_with([](Gluing& g) {
             testing::side(g, 4) = SideGluing::coherent(4);
             testing::side(g, 6) = SideGluing::reversed(6);
         }),
         {at_side(side_glued_to_itself, 4, 4), at_side(side_glued_to_itself, 6, 6)}},
        {"a side that points at a third",
         tetrahedron_with([](Gluing& g) { testing::side(g, 0) = SideGluing::coherent(4); }),
         {at_side(gluing_not_involution, 0, 4), at_side(gluing_not_involution, 5, 0)}},
        {"a triangle by itself",
         gluing(testing::lone_triangle),
         {at_side(side_unglued, 0, -1), at_side(side_unglued, 1, -1),
          at_side(side_unglued, 2, -1)}},
        {"a face list of two tetrahedra with a common edge",
         face_list(testing::faces_of_tetrahedra_sharing_an_edge(), 6),
         {at_side(edge_in_more_than_two_faces, 0, 4, {0, 1, 4, 5})}},
        {"a face list with one face turned over",
         face_list({{0, 1, 2}, {0, 3, 1}, {1, 2, 3}, {2, 3, 0}}, 4),
         // Face 2 now runs 1-2 as face 0 does, 2-3 as face 3 does and 3-1 as face 1 does.
         {at_side(directed_edge_repeats, 1, 2, {1, 2}),
          at_side(directed_edge_repeats, 4, 2, {3, 1}),
          at_side(directed_edge_repeats, 7, 3, {2, 3})}},
        {"two edges with their sides exchanged",
         tetrahedron_with([](Gluing& g) {
             testing::join(g, 0, 8);
             testing::join(g, 1, 5);
         }),
         {at_side(labels_disagree, 0, 8), at_side(labels_disagree, 1, 5)},
         {vertex_with_several_fans}},
        {"two opposite edges with their sides exchanged",
         tetrahedron_with([](Gluing& g) {
             testing::join(g, 0, 7);
             testing::join(g, 5, 9);
         }),
         {at_side(labels_disagree, 0, 7), at_side(labels_disagree, 5, 9)}},
        {"a coherence bit inverted on both sides",
         tetrahedron_with([](Gluing& g) {
             testing::invert_bit(g, 0);
             testing::invert_bit(g, 5);
         }),
         {at_side(coherence_bit_contradicts_labels, 0, 5),
          at_side(coherence_bit_contradicts_labels, 5, 0)}},
        {"a coherence bit inverted on one side",
         tetrahedron_with([](Gluing& g) { testing::invert_bit(g, 5); }),
         {at_side(coherence_bit_contradicts_labels, 5, 0)}},
        {"two vertices of an edge made one",
         gluing(testing::looped_tetrahedron),
         {at_face(corners_not_distinct, 0, {0, 0, 1}), at_face(corners_not_distinct, 1, {0, 2, 0})},
         {vertex_with_several_fans}},
        {"a torus with one vertex, one of its two faces cut in three",
         [] {
             Gluing torus = testing::unglued(2, {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
             const auto coherently = [&](Index s, Index t) {
                 testing::side(torus, s) = SideGluing::coherent(t);
                 testing::side(torus, t) = SideGluing::coherent(s);
             };
             for (const Index i : {0, 1, 2}) {
                 coherently(i, 3 * (i + 1));
                 coherently(3 * (i + 1) + 1, 3 * ((i + 1) % 3 + 1) + 2);
             }
             return audit(torus);
         },
         {at_face(corners_not_distinct, 0, {0, 0, 0}), at_face(corners_not_distinct, 1, {0, 0, 1}),
          at_face(corners_not_distinct, 2, {0, 0, 1}),
          at_face(corners_not_distinct, 3, {0, 0, 1})}},
        {"two spheres of two faces",
         gluing(testing::disjoint_two_face_spheres),
         {at_face(three_neighbour_rule_broken, 0, {1, 1, 1}),
          at_face(three_neighbour_rule_broken, 1, {0, 0, 0}),
          at_face(three_neighbour_rule_broken, 2, {3, 3, 3}),
          at_face(three_neighbour_rule_broken, 3, {2, 2, 2})},
         {vertices_not_connected, faces_not_strongly_connected}},
        {"a face that is its own neighbour",
         // A triangle whose first two sides are sewn together, its third side closed by another.
         [] {
             Gluing cones = testing::unglued(3, {{0, 1, 0}, {0, 2, 0}});
             for (const Index first : {0, 3})
                 testing::join(cones, first, first + 1);
             testing::join(cones, 2, 5);
             return audit(cones);
         },
         {at_face(three_neighbour_rule_broken, 0, {0, 0, 1}),
          at_face(three_neighbour_rule_broken, 1, {1, 1, 0})},
         {corners_not_distinct}},
        {"a fifth vertex nobody uses",
         tetrahedron_with([](Gluing& g) { g.vertex_count = 5; }),
         {at_vertex(vertex_unused, 4, 0)}},
        {"two tetrahedra with a common vertex",
         gluing(testing::pinched_tetrahedra),
         {at_vertex(vertex_with_several_fans, 3, 2)},
         {faces_not_strongly_connected}},
        {"two opposite vertices of an octahedron made one",
         [] {
             return audit(testing::relabelled(testing::octahedron(), {0, 1, 2, 3, 4, 0}, 5));
         },
         {at_vertex(vertex_with_several_fans, 0, 2)}},
        {"a tetrahedron and a book with nothing in common",
         [] {
             return audit(
                 testing::beside(testing::tetrahedron(),
                                 testing::relabelled(testing::book(3), {4, 5, 6, 7, 8}, 9)));
         },
         {surface(vertices_not_connected, 2, {6, 4})},
         {faces_not_strongly_connected}},
        {"two tetrahedra with two common vertices, and a third apart",
         [] {
             return audit(
                 testing::beside(testing::tetrahedra_sharing_an_edge(),
                                 testing::relabelled(testing::tetrahedron(), {6, 7, 8, 9}, 10)));
         },
         {surface(faces_not_strongly_connected, 3, {4, 4, 4})},
         {vertices_not_connected, vertex_with_several_fans}},
        {"the projective plane",
         gluing(testing::projective_plane),
         {{.code = not_orientable, .kind = PlaceKind::face}}},  // its witness: see below
    };
    return all;
}

std::vector<Violation> of_code(const AuditReport& report, ViolationCode code) {
    std::vector<Violation> found;
    for (const Violation& v : report.violations) {
        if (v.code == code) found.push_back(v);
    }
    return found;
}

TEST(PlantedViolations, CoverEveryCodeOfASingleSurface) {
    std::set<ViolationCode> planted;
    for (const Plant& plant : plants())
        planted.insert(plant.expected.front().code);
    for (const ViolationCode code : all_violation_codes()) {
        if (static_cast<int>(code) >= 900) continue;  // those compare two surfaces
        EXPECT_TRUE(planted.contains(code)) << name(code);
    }
}

TEST(PlantedViolations, AreReportedUnderTheirCodeWithPlaceAndWitness) {
    for (const Plant& plant : plants()) {
        SCOPED_TRACE(plant.fault);
        const AuditReport report = plant.judge();
        EXPECT_FALSE(report.is_valid());
        const ViolationCode code = plant.expected.front().code;
        const std::vector<Violation> found = of_code(report, code);
        ASSERT_EQ(found.size(), plant.expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].kind, plant.expected[i].kind);
            if (code == not_orientable) continue;
            EXPECT_EQ(found[i].place, plant.expected[i].place);
            EXPECT_EQ(found[i].found, plant.expected[i].found);
            EXPECT_EQ(found[i].witness, plant.expected[i].witness);
        }
        std::set<ViolationCode> others;
        for (const Violation& v : report.violations)
            others.insert(v.code);
        others.erase(code);
        EXPECT_EQ(others, plant.also);
    }
}

TEST(PlantedViolations, StandAloneExceptWhereCodesImplyOneAnother) {
    // Faces whose neighbours coincide lie in a component of their own; parts without a common
    // vertex have no common side either; components that do share vertices pinch them.
    const std::set<ViolationCode> never_alone{three_neighbour_rule_broken, vertices_not_connected,
                                              faces_not_strongly_connected};
    std::set<ViolationCode> alone;
    for (const Plant& plant : plants()) {
        if (plant.also.empty()) alone.insert(plant.expected.front().code);
    }
    for (const ViolationCode code : all_violation_codes()) {
        if (static_cast<int>(code) >= 900) continue;
        EXPECT_NE(alone.contains(code), never_alone.contains(code)) << name(code);
    }
}

TEST(PlantedViolations, NameAWalkThatReallyReversesOrientation) {
    for (const Gluing& gluing :
         {testing::projective_plane(), testing::klein_bottle(), testing::moebius_strip()}) {
        const auto found = of_code(audit(gluing), not_orientable);
        ASSERT_EQ(found.size(), 1U);
        const Violation& v = found.front();
        EXPECT_EQ(v.found, static_cast<std::int64_t>(v.witness.size()));
        EXPECT_THAT(v.witness, ::testing::Contains(v.place));
        EXPECT_TRUE(testing::reverses_orientation(gluing, v.witness))
            << ::testing::PrintToString(v.witness);
    }
    // The check itself: a walk round a vertex of an orientable surface reverses nothing.
    EXPECT_FALSE(testing::reverses_orientation(testing::tetrahedron(), {0, 1, 3}));
    EXPECT_FALSE(testing::reverses_orientation(testing::octahedron(), {0, 1, 2, 3}));
}

TEST(Violation, HasANameADescriptionAndAMessageForEveryCode) {
    std::set<std::string_view> names;
    std::set<std::string_view> descriptions;
    ViolationCode previous{};
    for (const ViolationCode code : all_violation_codes()) {
        EXPECT_LT(previous, code);
        previous = code;
        EXPECT_THAT(std::string(name(code)), ::testing::MatchesRegex("[a-z_]+"));
        EXPECT_TRUE(names.insert(name(code)).second) << name(code);
        EXPECT_TRUE(descriptions.insert(describe(code)).second) << name(code);
        EXPECT_THAT(std::string(describe(code)), ::testing::Not(::testing::HasSubstr("\n")));
    }
    EXPECT_EQ(name(vertex_with_several_fans), "vertex_with_several_fans");
    EXPECT_EQ(name(genus_changed), "genus_changed");
    EXPECT_EQ(static_cast<int>(not_orientable), 801);
    EXPECT_EQ(static_cast<int>(edge_in_more_than_two_faces), 204);
}

TEST(Violation, FillsEveryFieldOfItsMessage) {
    for (const ViolationCode code : all_violation_codes()) {
        const std::string text =
            message({.code = code, .place = 3, .found = 41, .expected = 43, .witness = {47, 53}});
        EXPECT_FALSE(text.empty()) << name(code);
        EXPECT_THAT(text, ::testing::Not(::testing::ContainsRegex("[{}\n]"))) << name(code);
    }
    for (const Plant& plant : plants()) {
        for (const Violation& v : plant.judge().violations) {
            EXPECT_THAT(message(v), ::testing::Not(::testing::ContainsRegex("[{}\n]")));
        }
    }
}

TEST(Violation, SaysInItsMessageWhatWasFound) {
    const Violation fans = at_vertex(vertex_with_several_fans, 3, 2);
    EXPECT_EQ(where(fans), "vertex 3");
    EXPECT_THAT(message(fans), ::testing::HasSubstr("2"));
    const Violation loop = at_face(corners_not_distinct, 12, {17, 17, 19});
    EXPECT_EQ(where(loop), "face 12");
    EXPECT_THAT(message(loop), ::testing::HasSubstr("17, 17, 19"));
    EXPECT_EQ(where(at_side(side_unglued, 37, -1)), "face 12, side 1");
    EXPECT_EQ(where(at_halfedge(next_out_of_range, 5, 99)), "halfedge 5");
    EXPECT_EQ(where(surface(no_faces, 0)), "surface");
}

TEST(Violation, CutsALongWitnessShort) {
    std::vector<Index> walk(5000, 123456);
    const std::string text = message(at_face(not_orientable, 0, walk));
    EXPECT_LT(text.size(), 500U);
    EXPECT_THAT(text, ::testing::HasSubstr("5000"));
}

}  // namespace
}  // namespace tightflip::kernel
