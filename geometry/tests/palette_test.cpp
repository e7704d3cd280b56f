#include "palette.hpp"

#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry::palette {
namespace {

TEST(Palette, ColoursAreSixDigits) {
    EXPECT_EQ(hexadecimal({0, 0, 0}), "#000000");
    EXPECT_EQ(hexadecimal({1, 1, 1}), "#ffffff");
    EXPECT_EQ(hexadecimal({1, 0.5, 0}), "#ff8000");
}

TEST(Palette, SignsAreToldByHueAndSizesByStrength) {
    for (const double value : {0.05, 0.3, 1.0}) {
        const Colour high = diverging(value);
        const Colour low = diverging(-value);
        EXPECT_GT(high[0], high[2]);
        EXPECT_GT(low[2], low[0]);
    }
    EXPECT_GT(diverging(0).minCoeff(), 0.95);
    EXPECT_LT(diverging(1).sum(), diverging(0.5).sum());
    EXPECT_LT(diverging(-1).sum(), diverging(-0.5).sum());
}

TEST(Palette, LightMakesFacesLighterAndTheirTwoSidesDiffer) {
    for (const bool is_front : {true, false}) {
        EXPECT_TRUE((face(is_front, 0) < face(is_front, 0.5)).all());
        EXPECT_TRUE((face(is_front, 0.5) < face(is_front, 1)).all());
        EXPECT_LE(face(is_front, 1).maxCoeff(), 1);
    }
    EXPECT_TRUE((face(false, 0.5) < face(true, 0.5)).all());
}

TEST(Palette, KindsDifferInColourAndInMarkOrWidth) {
    std::set<std::string_view> fills;
    std::set<std::pair<Mark, double>> marks;
    for (const VertexLook& look : vertices) {
        fills.insert(look.fill);
        marks.emplace(look.mark, look.size);
    }
    EXPECT_EQ(fills.size(), vertices.size());
    EXPECT_EQ(marks.size(), vertices.size());
    std::set<std::string_view> colours;
    for (const EdgeLook& look : edges)
        colours.insert(look.colour);
    EXPECT_EQ(colours.size(), edges.size());
}

}  // namespace
}  // namespace tightflip::geometry::palette
