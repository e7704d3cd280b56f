#include "naive_audit.hpp"
#include "printing.hpp"
#include "random_gluings.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using enum ViolationCode;
using ::testing::ElementsAre;
using testing::FaceList;
using testing::RandomGluings;
using testing::side;

/// Faces up to rotation, as often as they occur.
std::multiset<std::array<Index, 3>> oriented_faces(const FaceList& faces) {
    std::multiset<std::array<Index, 3>> result;
    for (std::array<Index, 3> face : faces) {
        std::rotate(face.begin(), std::ranges::min_element(face), face.end());
        result.insert(face);
    }
    return result;
}
FaceList faces_of(const Gluing& gluing) {
    FaceList faces;
    for (const GluedFace& face : gluing.faces)
        faces.push_back(face.corners);
    return faces;
}
FaceList faces_of(const Triangulation& surface) {
    FaceList faces;
    for (const Halfedge h : surface.faces()) {
        faces.push_back({surface.origin(h).id, surface.target(h).id, surface.opposite(h).id});
    }
    return faces;
}

// ---- from a halfedge table ----

TEST(BuildFromTable, KeepsEveryHandle) {
    RandomGluings random(21);
    for (int run = 0; run < 100; ++run) {
        const Gluing gluing = random.flipped();
        const auto table = RandomGluings::halfedge_table(gluing);
        const BuildResult result = build(table, gluing.vertex_count);
        ASSERT_TRUE(result);
        EXPECT_TRUE(result.report.is_valid());
        EXPECT_TRUE(std::ranges::equal(result.value().table(), table));
        EXPECT_EQ(result.value().vertex_count(), gluing.vertex_count);
    }
}

TEST(BuildFromTable, RefusesWhatIsNoSurface) {
    auto table = RandomGluings::halfedge_table(testing::tetrahedron());
    EXPECT_TRUE(build(table, 5).report.has(vertex_unused));
    EXPECT_FALSE(build(table, 5));
    EXPECT_FALSE(build(std::vector<HalfedgeRecord>{}, 0));
    table[4].next = {2};
    EXPECT_TRUE(build(table, 4).report.has(next_cycle_not_triangle));
    EXPECT_FALSE(build(RandomGluings::halfedge_table(testing::pinched_tetrahedra()), 7));
}

// ---- from a gluing ----

TEST(BuildFromGluing, NumbersEdgesByTheirFirstSides) {
    const Triangulation s = build(testing::tetrahedron()).value();
    // The glued pairs in the order of their first sides: 0-5, 1-8, 2-11, 3-10, 4-6, 7-9.
    const std::array<Index, 12> halfedge_of_side{0, 2, 4, 6, 8, 1, 9, 10, 3, 11, 7, 5};
    const FaceList faces = testing::tetrahedron_faces();
    for (Index s_ = 0; s_ < 12; ++s_) {
        const Halfedge h{testing::nth(halfedge_of_side, s_)};
        EXPECT_EQ(s.origin(h).id, testing::nth(testing::nth(faces, s_ / 3), s_ % 3));
        EXPECT_EQ(s.next(h).id, testing::nth(halfedge_of_side, s_ - s_ % 3 + (s_ + 1) % 3));
    }
}

TEST(BuildFromGluing, TurnsFacesOverToAgreeWithFaceZero) {
    RandomGluings random(1789);
    int turned = 0;
    for (int run = 0; run < 500; ++run) {
        const Gluing straight = random.flipped();
        const Gluing mixed = random.disguised(straight);
        const BuildResult result = build(mixed);
        ASSERT_TRUE(result) << ::testing::PrintToString(mixed);
        const Triangulation& s = result.value();
        EXPECT_TRUE(audit(s).is_valid());
        EXPECT_EQ(audit(s).topology, audit(straight).topology);

        // Edges by first sides, whichever way their faces are listed.
        std::map<Index, Index> halfedge;
        for (Index x = 0; x < testing::side_count(mixed); ++x) {
            if (halfedge.contains(x)) continue;
            const auto number = static_cast<Index>(halfedge.size());
            halfedge[x] = number;
            halfedge[side(mixed, x).side()] = number + 1;
        }
        // Each face keeps its sides, and face 0 its direction too.
        for (Index f = 0; f < testing::face_count(mixed); ++f) {
            const std::array<Index, 3> sides{halfedge[3 * f], halfedge[3 * f + 1],
                                             halfedge[3 * f + 2]};
            const bool forward = s.next({sides[0]}).id == sides[1];
            EXPECT_EQ(s.next({sides[0]}).id, sides[forward ? 1 : 2]);
            EXPECT_EQ(s.next({sides[1]}).id, sides[forward ? 2 : 0]);
            for (Index i = 0; i < 3; ++i) {
                const Halfedge h{testing::nth(sides, i)};
                EXPECT_EQ(s.origin(h).id, forward ? testing::start_of(mixed, 3 * f + i)
                                                  : testing::end_of(mixed, 3 * f + i));
            }
            if (f == 0) {
                EXPECT_TRUE(forward);
            }
            turned += forward ? 0 : 1;
        }
    }
    EXPECT_GT(turned, 100);
}

TEST(BuildFromGluing, RefusesWithTheWalkThatReversesOrientation) {
    for (const Gluing& gluing : {testing::projective_plane(), testing::klein_bottle()}) {
        const BuildResult result = build(gluing);
        EXPECT_FALSE(result);
        ASSERT_EQ(result.report.violations.size(), 1U);
        EXPECT_EQ(result.report.violations.front().code, not_orientable);
        EXPECT_TRUE(
            testing::reverses_orientation(gluing, result.report.violations.front().witness));
        EXPECT_TRUE(result.report.is_closed_surface());
    }
}

TEST(BuildFromGluing, RefusesExactlyWhatTheAuditDoesAndWithItsReport) {
    RandomGluings random(60);
    int built = 0;
    int refused = 0;
    for (int run = 0; run < 2000; ++run) {
        Gluing gluing = run % 4 == 0 ? random.garbage() : random.honest();
        if (run % 3 == 0 && !gluing.faces.empty() && gluing.vertex_count > 0 &&
            gluing.vertex_count < 100) {
            random.damage(gluing);
        }
        const BuildResult result = build(gluing);
        const AuditReport report = audit(gluing);
        ASSERT_EQ(static_cast<bool>(result), report.is_valid());
        if (result) {
            ++built;
            EXPECT_EQ(result.report.topology, report.topology);
            EXPECT_TRUE(audit(result.value()).is_valid());
        } else {
            ++refused;
            EXPECT_EQ(result.report.violations, report.violations);
        }
    }
    EXPECT_GT(built, 200);
    EXPECT_GT(refused, 200);
}

TEST(BuildResult, ThrowsItsFirstViolationWhereItHoldsNothing) {
    const BuildResult refused = build(testing::pinched_tetrahedra());
    ASSERT_FALSE(refused);
    try {
        static_cast<void>(refused.value());
        FAIL() << "nothing was thrown";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("vertex 3"));
    }
    EXPECT_THROW(static_cast<void>(build(Gluing{}).value()), std::invalid_argument);
    EXPECT_NO_THROW(static_cast<void>(build(testing::tetrahedron()).value()));
}

// ---- gluing a face list ----

TEST(GlueFaces, GluesAsTheHandMadeSurfacesAreGlued) {
    for (const Gluing& gluing :
         {testing::two_face_sphere(), testing::tetrahedron(), testing::octahedron(),
          testing::torus_grid(), testing::seven_vertex_torus(), testing::projective_plane(),
          testing::klein_bottle(), testing::pinched_tetrahedra(), testing::disjoint_tetrahedra(),
          testing::lone_triangle(), testing::disc(), testing::moebius_strip(),
          testing::with_face_turned_over(testing::octahedron(), 2)}) {
        const FaceList faces = faces_of(gluing);
        const FaceListReading reading = glue_faces(faces, gluing.vertex_count);
        EXPECT_TRUE(reading.violations.empty());
        EXPECT_EQ(reading.gluing, gluing);
    }
}

TEST(GlueFaces, LeavesSidesUngluedWhoseNeighbourTheListDoesNotTell) {
    const FaceListReading reading = glue_faces(testing::faces_of_tetrahedra_sharing_an_edge(), 6);
    ASSERT_EQ(reading.violations.size(), 1U);
    const Violation& v = reading.violations.front();
    EXPECT_EQ(v.code, edge_in_more_than_two_faces);
    EXPECT_EQ(where(v), "face 0, side 0");
    EXPECT_EQ(v.found, 4);
    EXPECT_THAT(v.witness, ElementsAre(0, 1, 4, 5));
    const Gluing expected = testing::tetrahedra_sharing_an_edge();
    for (Index s = 0; s < testing::side_count(expected); ++s) {
        const std::set<Index> ends{testing::start_of(expected, s), testing::end_of(expected, s)};
        EXPECT_EQ(side(reading.gluing, s),
                  (ends == std::set<Index>{0, 1} ? SideGluing() : side(expected, s)));
    }
}

TEST(GlueFaces, NamesAnEdgeOfThreeFacesAsOneOfFour) {
    const FaceList three_faces_at_an_edge{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const FaceListReading reading = glue_faces(three_faces_at_an_edge, 5);
    ASSERT_EQ(reading.violations.size(), 1U);
    EXPECT_EQ(reading.violations.front().code, edge_in_more_than_two_faces);
    EXPECT_EQ(reading.violations.front().found, 3);
    EXPECT_THAT(reading.violations.front().witness, ElementsAre(0, 1, 2));
}

TEST(GlueFaces, DoesNotMindCornersOutOfRange) {
    const FaceList faces{{0, 1, -7}, {1, 0, 2147483647}};
    const FaceListReading reading = glue_faces(faces, 3);
    EXPECT_TRUE(audit(reading.gluing).has(corner_out_of_range));
    EXPECT_EQ(side(reading.gluing, 0), SideGluing::coherent(3));
    EXPECT_TRUE(glue_faces(FaceList{}, 0).gluing.faces.empty());
}

// ---- from a face list ----

TEST(BuildFromFaces, KeepsTheStoredOrientation) {
    for (const auto& [faces, vertex_count] :
         {std::pair{testing::tetrahedron_faces(), 4}, std::pair{testing::octahedron_faces(), 6},
          std::pair{testing::seven_vertex_torus_faces(), 7},
          std::pair{testing::sewn_grid_faces(3, 3, false), 9},
          std::pair{FaceList{{0, 1, 2}, {0, 2, 1}}, 3}}) {
        const BuildResult result = build(faces, vertex_count);
        ASSERT_TRUE(result);
        EXPECT_EQ(oriented_faces(faces_of(result.value())), oriented_faces(faces));
    }
}

TEST(BuildFromFaces, RefusesExactlyWhereADirectedPairRepeatsOrTheSurfaceIsBad) {
    RandomGluings random(77);
    std::map<ViolationCode, int> refusals;
    for (int run = 0; run < 3000; ++run) {
        const Gluing gluing = run % 2 == 0 ? random.flipped() : random.honest();
        const FaceList faces = faces_of(gluing);
        std::map<std::pair<Index, Index>, int> directed;
        for (Index s = 0; s < testing::side_count(gluing); ++s) {
            ++directed[{testing::start_of(gluing, s), testing::end_of(gluing, s)}];
        }
        const bool repeats =
            std::ranges::any_of(directed, [](const auto& entry) { return entry.second > 1; });
        const BuildResult result = build(faces, gluing.vertex_count);
        SCOPED_TRACE(::testing::PrintToString(gluing));
        if (repeats) {
            ASSERT_FALSE(result);
            for (const Violation& v : result.report.violations) {
                ++refusals[v.code];
                const std::pair named{testing::start_of(gluing, v.place),
                                      testing::end_of(gluing, v.place)};
                const int both_ways =
                    directed[named] +
                    (named.first == named.second ? 0 : directed[{named.second, named.first}]);
                ASSERT_EQ(v.kind, PlaceKind::side);
                if (v.code == directed_edge_repeats) {
                    EXPECT_EQ(directed[named], 2);
                    EXPECT_THAT(v.witness, ElementsAre(named.first, named.second));
                } else {
                    ASSERT_EQ(v.code, edge_in_more_than_two_faces);
                    EXPECT_GT(both_ways, 2);
                    EXPECT_EQ(v.found, both_ways);
                    EXPECT_EQ(v.witness.size(), static_cast<std::size_t>(both_ways));
                }
            }
        } else {
            EXPECT_EQ(static_cast<bool>(result), audit(gluing).is_valid());
            if (result) {
                EXPECT_EQ(oriented_faces(faces_of(result.value())), oriented_faces(faces));
                ++refusals[ViolationCode{}];
            }
        }
    }
    EXPECT_GT(refusals[directed_edge_repeats], 100);
    EXPECT_GT(refusals[edge_in_more_than_two_faces], 100);
    EXPECT_GT(refusals[ViolationCode{}], 100);
}

TEST(BuildFromFaces, SaysWhatIsWrongWithEachOffendingEdge) {
    const BuildResult incoherent = build(FaceList{{0, 1, 2}, {0, 1, 3}, {1, 3, 2}, {2, 3, 0}}, 4);
    ASSERT_FALSE(incoherent);
    const Violation& first = incoherent.report.violations.front();
    EXPECT_EQ(first.code, directed_edge_repeats);
    EXPECT_EQ(where(first), "face 0, side 0");
    EXPECT_EQ(first.found, 1);
    EXPECT_THAT(first.witness, ElementsAre(0, 1));

    EXPECT_TRUE(build(faces_of(testing::book(3)), 5).report.has(edge_in_more_than_two_faces));
    EXPECT_TRUE(build(faces_of(testing::disc()), 5).report.has(side_unglued));
    EXPECT_TRUE(build(testing::tetrahedron_faces(), 5).report.has(vertex_unused));
    EXPECT_TRUE(build(testing::tetrahedron_faces(), 3).report.has(corner_out_of_range));
    EXPECT_TRUE(build(FaceList{}, 3).report.has(no_faces));
    EXPECT_TRUE(build(FaceList{{0, 0, 1}}, 2).report.has(corners_not_distinct));
}

}  // namespace
}  // namespace tightflip::kernel
