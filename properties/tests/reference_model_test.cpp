#include "small_surfaces.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>
#include <tightflip/properties/reference_model.hpp>

#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

namespace families = kernel::families;
using kernel::RandomStream;
using kernel::Topology;

/// A closed surface up to the direction of its faces: every side of every face named by the corner
/// opposite to it, and what it is glued to.
using Undirected = std::set<std::tuple<Index, Index, Index, Index>>;

Undirected undirected(const Gluing& gluing) {
    const auto opposite = [&](Index side) {
        return gluing.faces[static_cast<std::size_t>(side / 3)]
            .corners[static_cast<std::size_t>((side + 2) % 3)];
    };
    Undirected sides;
    for (Index s = 0; s < 3 * static_cast<Index>(gluing.faces.size()); ++s) {
        const Index other = gluing.faces[static_cast<std::size_t>(s / 3)]
                                .sides[static_cast<std::size_t>(s % 3)]
                                .side();
        sides.emplace(s / 3, opposite(s), other / 3, opposite(other));
    }
    return sides;
}

Edge draw(const ReferenceModel& model, RandomStream& random) {
    return {static_cast<Index>(random.below(static_cast<std::uint32_t>(model.edge_count())))};
}

struct NamedGluing {
    const char* name;
    Gluing gluing;
    bool orientable;
    Index euler_characteristic;
};

std::vector<NamedGluing> presentations() {
    using testing::turned_over;
    const auto gluing_of = [](const Triangulation& s) { return ReferenceModel(s).gluing(); };
    const auto every_third = [](Index face) { return face % 3 == 1; };
    return {
        {"projective plane", testing::projective_plane(), false, 1},
        {"Klein bottle", testing::klein_bottle(), false, 0},
        {"sphere", gluing_of(families::stacked(9, 3)), true, 2},
        {"torus", gluing_of(families::torus_grid(3, 4)), true, 0},
        {"genus 2, parallel edges", gluing_of(families::random(6, 2, 1)), true, -2},
        {"projective plane, turned", turned_over(testing::projective_plane(), every_third), false,
         1},
        {"Klein bottle, turned", turned_over(testing::klein_bottle(), every_third), false, 0},
        {"book, turned", turned_over(gluing_of(families::book(6)), every_third), true, 2},
        {"torus, turned", turned_over(gluing_of(families::torus_grid(3, 3)), every_third), true, 0},
    };
}

TEST(ReferenceModel, KeepsWhatFlipsMustKeepOnOrientableAndNonOrientableSurfaces) {
    for (const auto& [name, gluing, orientable, euler_characteristic] : presentations()) {
        SCOPED_TRACE(name);
        const Topology topology = kernel::audit(gluing).topology;
        ASSERT_EQ(topology.orientable, orientable);
        ASSERT_EQ(topology.euler_characteristic, euler_characteristic);
        ReferenceModel model(gluing);
        ASSERT_EQ(undirected(model.gluing()), undirected(gluing));
        RandomStream random(17);
        int done = 0;
        for (int attempt = 0; attempt < 3000; ++attempt) {
            const Edge e = draw(model, random);
            const bool allowed = model.can_flip(e);
            ASSERT_EQ(model.flip(e), allowed);
            done += allowed ? 1 : 0;
            const kernel::AuditReport report = kernel::audit(model.gluing());
            ASSERT_TRUE(report.is_closed_surface()) << "after attempt " << attempt;
            ASSERT_EQ(report.topology, topology) << "after attempt " << attempt;
        }
        EXPECT_GT(done, 1000);
    }
}

TEST(ReferenceModel, FourFlipsOfAnEdgeAreTheIdentityAndUnflipUndoesOne) {
    for (const auto& [name, gluing, orientable, euler_characteristic] : presentations()) {
        SCOPED_TRACE(name);
        ReferenceModel model(gluing);
        RandomStream random(5);
        for (int attempt = 0; attempt < 300; ++attempt) {
            const Edge e = draw(model, random);
            const Undirected before = undirected(model.gluing());
            if (!model.can_flip(e)) {
                ASSERT_FALSE(model.flip(e) || model.unflip(e));
                ASSERT_EQ(undirected(model.gluing()), before);
                continue;
            }
            ASSERT_TRUE(model.flip(e));
            ASSERT_NE(undirected(model.gluing()), before);
            ASSERT_TRUE(model.unflip(e));
            ASSERT_EQ(undirected(model.gluing()), before);
            ASSERT_TRUE(model.unflip(e) && model.flip(e));
            ASSERT_EQ(undirected(model.gluing()), before);
            for (int k = 0; k < 4; ++k)
                ASSERT_TRUE(model.flip(e));
            ASSERT_EQ(undirected(model.gluing()), before);
            ASSERT_TRUE(model.flip(e));
        }
    }
}

TEST(ReferenceModel, OfATurnedOverListFlipsToTheSameSurface) {
    const Triangulation start = families::random(8, 1, 4);
    const Gluing turned =
        testing::turned_over(ReferenceModel(start).gluing(), [](Index f) { return f % 2 == 1; });
    Triangulation surface = kernel::build(turned).value();  // numbers edges as the model does
    ReferenceModel model(turned);
    RandomStream random(23);
    for (int attempt = 0; attempt < 500; ++attempt) {
        const Edge e = draw(model, random);
        ASSERT_EQ(model.flip(e), static_cast<bool>(surface.flip(e)));
        const Gluing now = model.gluing();
        const Triangulation one_way = kernel::build(now).value();
        const Triangulation other_way =
            kernel::build(testing::turned_over(now, [](Index) { return true; })).value();
        ASSERT_TRUE(same_labelled_surface(one_way, surface) ||
                    same_labelled_surface(other_way, surface))
            << "after attempt " << attempt;
    }
}

TEST(ReferenceModel, AgreesWithTheSurfaceItWasMadeFromOnlyWhileTheyAreTheSame) {
    Triangulation surface = families::random(7, 0, 2);
    ReferenceModel model(surface);
    EXPECT_EQ(model.difference(surface), std::nullopt);
    for (Index e = 0; e < surface.edge_count(); ++e) {
        if (!surface.can_flip({e})) continue;
        Triangulation flipped = surface;
        ASSERT_TRUE(flipped.flip({e}));
        EXPECT_NE(model.difference(flipped), std::nullopt) << "edge " << e;
        ReferenceModel flipped_model = model;
        ASSERT_TRUE(flipped_model.flip({e}));
        EXPECT_EQ(flipped_model.difference(flipped), std::nullopt) << "edge " << e;
        ASSERT_TRUE(flipped.flip({e}));  // two flips exchange the halves: other handles
        EXPECT_NE(model.difference(flipped), std::nullopt) << "edge " << e;
    }
    EXPECT_NE(model.difference(families::random(8, 0, 2)), std::nullopt);
    EXPECT_NE(model.difference(families::random(6, 0, 2)), std::nullopt);
}

TEST(ReferenceModel, RefusesWhatIsNoClosedSurface) {
    Gluing open = testing::projective_plane();
    open.faces.pop_back();
    EXPECT_THROW(ReferenceModel{open}, std::invalid_argument);
    EXPECT_THROW(static_cast<void>(ReferenceModel(families::tetrahedron()).can_flip({6})),
                 std::invalid_argument);
}

}  // namespace
}  // namespace tightflip::properties
