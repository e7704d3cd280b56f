#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/simple_flip.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

/// The definition, by trying: the flip is done, and no other edge joins the ends of the new one.
bool flips_simply(Triangulation surface, Edge e) {
    if (!surface.flip(e)) return false;
    const Halfedge h = halfedge_of(e);
    const Neighbours around = surface.neighbours(h);
    return std::count(around.begin(), around.end(), surface.target(h)) == 1;
}

TEST(SimpleFlip, IsWhatItsDefinitionSays) {
    int refused = 0;
    int allowed = 0;
    for (const Triangulation& surface :
         {families::tetrahedron(), families::book(3), families::book(6), families::double_wheel(7),
          families::torus_grid(3, 4), families::random(9, 0, 1), families::random(9, 1, 2),
          families::random(6, 2, 3)}) {
        for (Index id = 0; id < surface.edge_count(); ++id) {
            const bool is_simple = flips_simply(surface, {id});
            EXPECT_EQ(can_flip_simply(surface.table(), {id}), is_simple) << "edge " << id;
            ++(is_simple ? allowed : refused);
        }
    }
    EXPECT_GT(refused, 20);
    EXPECT_GT(allowed, 20);
}

}  // namespace
}  // namespace tightflip::kernel
