#include "flip_geometry.hpp"

#include "target_corpus.hpp"
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/kernel/random.hpp>

#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using geometry::EdgeShape;
using geometry::VertexType;
using Bytes = std::vector<std::uint8_t>;

TEST(FlipGeometry, TakesStartSizeFlipsAndCoordinates) {
    // The book of 3 + 2 vertices; coordinates to 2; one flip.
    const GeometryCase decoded =
        decode_geometry_case(Bytes{0, 2, 0, 0, 1, 1, 4, 1, 0, 1, 2, 3, 4, 5});
    const kernel::Index edges = decoded.start.triangulation().edge_count();
    EXPECT_EQ(decoded.script, (properties::FlipScript{{(4 + 256) % edges}}));
    EXPECT_EQ(decoded.start.point({0}), geometry::Point(-2, -1, 0));
    EXPECT_EQ(decoded.start.point({1}), geometry::Point(1, 2, -2));
    EXPECT_EQ(decoded.start.point({2}), geometry::Point(-2, -2, -2));
}

TEST(FlipGeometry, HoldsForEveryByteString) {
    kernel::RandomStream random(1);
    std::set<kernel::Index> genera;
    for (int k = 0; k < 300; ++k) {
        Bytes bytes(random.below(90));
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random.bits());
        const GeometryCase decoded = decode_geometry_case(bytes);
        genera.insert(decoded.start.triangulation().genus());
        ASSERT_EQ(geometry_objection(decoded), "");
    }
    EXPECT_EQ(genera.size(), 4U);
}

TEST(FlipGeometry, TheCorpusHasEveryShapeAndType) {
    std::set<EdgeShape> shapes;
    std::set<VertexType> types;
    for (const Bytes& bytes : corpus("flip_geometry")) {
        const auto sums = measure(decode_geometry_case(bytes).start.view());
        for (const EdgeShape shape : {EdgeShape::convex, EdgeShape::concave, EdgeShape::flat,
                                      EdgeShape::folded, EdgeShape::degenerate}) {
            if (sums.count(shape) > 0) shapes.insert(shape);
        }
        for (const VertexType type :
             {VertexType::convex, VertexType::saddle, VertexType::mixed, VertexType::flat}) {
            if (sums.count(type) > 0) types.insert(type);
        }
    }
    EXPECT_EQ(shapes.size(), 5U);
    EXPECT_EQ(types.size(), 4U);
}

}  // namespace
}  // namespace tightflip::fuzz
