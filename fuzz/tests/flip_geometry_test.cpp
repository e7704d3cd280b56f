#include "targets/flip_geometry.hpp"

#include "targets.hpp"
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/point_kinds.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using geometry::EdgeShape;
using geometry::VertexType;

TEST(FlipGeometry, IsStartSizeCoordinatesAndFlips) {
    // The book of 3 + 2 vertices, coordinates to 2, one flip.
    InputBytes input{1, 1, 2, 0, 0, /* points */ 1, 0, 0, 1, 2, 3, 4, 5};
    input.resize(geometry_layout.head);
    input.insert(input.end(), {4, 1});
    const GeometryCase decoded = decode_geometry_case(input);
    const kernel::Index edges = decoded.start.triangulation().edge_count();
    EXPECT_EQ(edges, 9);
    EXPECT_EQ(decoded.script, (properties::FlipScript{{(4 + 256) % edges}}));
    EXPECT_EQ(decoded.start.point({0}), geometry::Point(-2, -1, 0));
    EXPECT_EQ(decoded.start.point({1}), geometry::Point(1, 2, -2));
    EXPECT_EQ(decoded.start.point({2}), geometry::Point(-2, -2, -2));
}

TEST(FlipGeometry, TakesEveryKindOfPoints) {
    const auto kinds = properties::point_kinds();
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const auto lie = static_cast<std::uint8_t>(most_coordinate + k);
        const GeometryCase decoded = decode_geometry_case(InputBytes{1, 1, 2, 0, 0, lie, 77});
        const auto points = decoded.start.points();
        EXPECT_TRUE(std::ranges::equal(points, kinds[k].make(5, 77))) << kinds[k].name;
    }
}

TEST(FlipGeometry, HasAtMostSoManyFlips) {
    const InputBytes longer(geometry_layout.most_bytes() + 9, 1);
    EXPECT_EQ(decode_geometry_case(longer).script.size(), most_geometry_flips);
    const Input exact = Input(longer).first(geometry_layout.most_bytes());
    EXPECT_EQ(decode_geometry_case(exact).script.size(), most_geometry_flips);
}

TEST(FlipGeometry, HasCoordinatesForEveryVertexOfEveryKind) {
    for (const properties::StartKind& kind : properties::start_kinds()) {
        const kernel::Index largest =
            kind.least_vertices(kind.any_genus ? most_genus : 0) + most_spare_vertices;
        EXPECT_LE(static_cast<std::size_t>(largest), most_geometry_vertices) << kind.name;
    }
}

TEST(FlipGeometry, HoldsForEveryByteString) {
    kernel::RandomStream random(1);
    std::set<kernel::Index> genera;
    for (int k = 0; k < 300; ++k) {
        InputBytes bytes(random.below(static_cast<std::uint32_t>(geometry_layout.most_bytes())));
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random.bits());
        const GeometryCase decoded = decode_geometry_case(bytes);
        genera.insert(decoded.start.triangulation().genus());
        ASSERT_EQ(geometry_objection(decoded), "");
    }
    EXPECT_EQ(genera.size(), 4U);
}

TEST(FlipGeometry, TheSeedsHaveEveryShapeAndType) {
    std::set<EdgeShape> shapes;
    std::set<VertexType> types;
    for (const Seed& seed : flip_geometry_target.seeds()) {
        const auto sums = measure(decode_geometry_case(seed.bytes).start.view());
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
