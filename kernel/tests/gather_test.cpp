#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/gather.hpp>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

Index degree_of(const Triangulation& surface, Vertex v) {
    return static_cast<Index>(std::ranges::count(surface.table(), v, &HalfedgeRecord::origin));
}

void expect_gathered(const Triangulation& surface, Vertex hub) {
    const FlipLog log = gather_at(surface, hub);
    EXPECT_EQ(log.start, surface);
    const Replay replayed = replay(log);
    ASSERT_TRUE(replayed.is_complete()) << replayed.reason;
    EXPECT_EQ(static_cast<Index>(log.flips.size()), surface.face_count() - degree_of(surface, hub));
    for (const Halfedge side : replayed.surface.faces()) {
        const auto corners = replayed.surface.face_corners(side);
        EXPECT_EQ(std::ranges::count(corners, hub), 1) << "the face of halfedge " << side.id;
    }
}

TEST(GatherAt, PutsEveryVertexIntoEveryFaceOfAnyGenus) {
    for (const Index genus : {0, 1, 2, 3}) {
        for (const Index vertices : {4, 5, 12, 40}) {
            const Triangulation surface = families::random(vertices, genus, 7);
            for (Index hub = 0; hub < vertices; ++hub)
                expect_gathered(surface, {hub});
        }
    }
}

TEST(GatherAt, FindsAHubInPlace) {
    for (const Index pole : {0, 1}) {
        EXPECT_TRUE(gather_at(families::book(30), {pole}).flips.empty());
    }
    expect_gathered(families::book(30), {2});  // a vertex of degree 2
    EXPECT_TRUE(gather_at(families::book(3), {0}).flips.empty());
    EXPECT_TRUE(gather_at(families::random(3, 2, 1), {0}).flips.empty());
}

TEST(GatherAt, RefusesAVertexThatDoesNotExist) {
    const Triangulation surface = families::tetrahedron();
    EXPECT_THROW(static_cast<void>(gather_at(surface, {4})), std::out_of_range);
    EXPECT_THROW(static_cast<void>(gather_at(surface, {-1})), std::out_of_range);
}

}  // namespace
}  // namespace tightflip::kernel
