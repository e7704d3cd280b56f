#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/invariants.hpp>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

namespace families = kernel::families;
using enum ViolationCode;

constexpr Topology torus_of_nine{.vertices = 9,
                                 .edges = 27,
                                 .faces = 18,
                                 .components = 1,
                                 .euler_characteristic = 0,
                                 .orientable = true,
                                 .genus = 1};

struct Planted {
    ViolationCode code;
    void (*plant)(Topology&);
    std::int64_t found;
    std::int64_t expected;
};

constexpr std::array planted_changes{
    Planted{vertex_count_changed, [](Topology& t) { t.vertices = 8; }, 8, 9},
    Planted{edge_count_changed, [](Topology& t) { t.edges = 28; }, 28, 27},
    Planted{face_count_changed, [](Topology& t) { t.faces = 17; }, 17, 18},
    Planted{component_count_changed, [](Topology& t) { t.components = 2; }, 2, 1},
    Planted{euler_characteristic_changed, [](Topology& t) { t.euler_characteristic = 2; }, 2, 0},
    Planted{orientability_changed, [](Topology& t) { t.orientable = false; }, 0, 1},
    Planted{genus_changed, [](Topology& t) { t.genus = 2; }, 2, 1},
    Planted{genus_changed, [](Topology& t) { t.genus = std::nullopt; }, -1, 1},
};

TEST(Changes, NamesEachNumberThatChangedWithBothValues) {
    EXPECT_TRUE(changes(torus_of_nine, torus_of_nine).empty());
    Topology all = torus_of_nine;
    for (const Planted& planted : planted_changes) {
        Topology now = torus_of_nine;
        planted.plant(now);
        planted.plant(all);
        const std::vector<Violation> found = changes(torus_of_nine, now);
        ASSERT_EQ(found.size(), 1U) << name(planted.code);
        EXPECT_EQ(found.front().code, planted.code);
        EXPECT_EQ(found.front().found, planted.found) << name(planted.code);
        EXPECT_EQ(found.front().expected, planted.expected) << name(planted.code);
    }
    EXPECT_EQ(changes(torus_of_nine, all).size(), 7U);
}

TEST(FirstViolation, ComparesASoundSurfaceWithItsStart) {
    const Triangulation surface = families::torus_grid(3, 3);
    EXPECT_EQ(first_violation(surface, torus_of_nine), std::nullopt);
    for (const Planted& planted : planted_changes) {
        Topology start = torus_of_nine;
        planted.plant(start);
        const auto violation = first_violation(surface, start);
        ASSERT_TRUE(violation.has_value()) << name(planted.code);
        EXPECT_EQ(violation->code, planted.code);
        EXPECT_EQ(violation->found, planted.expected) << "the surface has what was expected";
    }
}

TEST(CheckedFlip, FlipsAsFlipDoesAndFindsNothingOnASoundKernel) {
    for (const Triangulation& start :
         {families::tetrahedron(), families::book(6), families::random(5, 2, 1)}) {
        for (Index e = 0; e < start.edge_count(); ++e) {
            Triangulation checked = start;
            Triangulation flipped = start;
            const CheckedFlip step = checked_flip(checked, {e});
            EXPECT_EQ(step.done, static_cast<bool>(flipped.flip({e})));
            EXPECT_EQ(step.code, std::nullopt);
            EXPECT_EQ(checked, flipped);
        }
    }
}

TEST(CheckedFlip, AcceptsTheRefusalsOfTheTwoFaceSphere) {
    Triangulation surface = families::book(3);
    for (Index e = 0; e < 3; ++e) {
        const CheckedFlip step = checked_flip(surface, {e});
        EXPECT_FALSE(step.done);
        EXPECT_EQ(step.code, std::nullopt);
    }
    EXPECT_EQ(surface, families::book(3));
}

TEST(Explain, ShowsTheTwoFacesWhereTheyCanBeRead) {
    const Triangulation surface = families::tetrahedron();
    for (const ViolationCode code : {refusal_unjustified, flip_not_as_defined}) {
        for (Index e = 0; e < surface.edge_count(); ++e) {
            const kernel::Halfedge h = halfedge_of(Edge{e});
            const Violation violation = explain(surface, {e}, code);
            EXPECT_EQ(violation.code, code);
            EXPECT_EQ(violation.kind, kernel::PlaceKind::edge);
            EXPECT_EQ(violation.place, e);
            EXPECT_EQ(violation.witness,
                      (std::vector<Index>{surface.origin(h).id, surface.target(h).id,
                                          surface.opposite(h).id, surface.target(h).id,
                                          surface.origin(h).id, surface.opposite(twin(h)).id}));
            EXPECT_EQ(violation.found, surface.opposite(h).id);
            EXPECT_EQ(violation.expected, surface.opposite(twin(h)).id);
        }
    }
}

TEST(Explain, NamesTheEdgeWhereTheAuditDoesNotConfirmTheCode) {
    const Triangulation surface = families::tetrahedron();
    for (const ViolationCode code :
         {next_out_of_range, next_cycle_not_triangle, origin_out_of_range, corners_not_distinct,
          labels_disagree, three_neighbour_rule_broken}) {
        const Violation violation = explain(surface, {2}, code);
        EXPECT_EQ(violation.code, code);
        EXPECT_EQ(violation.kind, kernel::PlaceKind::edge);
        EXPECT_EQ(violation.place, 2);
        EXPECT_TRUE(violation.witness.empty());
    }
}

}  // namespace
}  // namespace tightflip::properties
