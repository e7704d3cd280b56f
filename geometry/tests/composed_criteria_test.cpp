#include "shapes.hpp"
#include <tightflip/geometry/composed_criteria.hpp>

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Surface sample() {
    return with_random_points(kernel::families::random(25, 0, 11), 12);
}

TEST(ComposedCriteria, WeightedSumsAddUp) {
    Surface surface = sample();
    const auto area = make_criterion(CriterionKind::area, surface.view());
    const auto mean = make_criterion(CriterionKind::mean, surface.view());
    const auto sum = parse_criterion("2*area + 0.25 * mean", surface.view());
    const auto expected = [&](const Energy& a, const Energy& m) {
        return 2 * a.first() + 0.25 * m.first();
    };
    EXPECT_DOUBLE_EQ(sum->value().first(), expected(area->value(), mean->value()));
    kernel::RandomStream random(1);
    for (int i = 0; i < 50; ++i) {
        const Edge e{static_cast<Index>(
            random.below(static_cast<std::uint32_t>(surface.triangulation().edge_count())))};
        if (!surface.triangulation().can_flip(e)) continue;
        ASSERT_NEAR(sum->change(e).first(), expected(area->change(e), mean->change(e)), 1e-12);
        ASSERT_TRUE(surface.triangulation().flip(e));
        for (const auto& criterion : {&area, &mean, &sum})
            (*criterion)->flipped(e);
    }
}

TEST(ComposedCriteria, OrdersDecideByRank) {
    const Surface surface = cube();
    const auto order = parse_criterion("volume,edge_length", surface.view());
    EXPECT_EQ(order->level_count(), 2);
    // A diagonal of a square face: the volume stays, and so does the length.
    const Energy flat = order->change(edge_between(surface, 0, 3));
    EXPECT_EQ(flat.levels[0], 0);
    EXPECT_NEAR(flat.levels[1], 0, 1e-12);
    // An edge of the cube: its flip cuts off a tetrahedron.
    const Energy cut = order->change(edge_between(surface, 0, 1));
    EXPECT_GT(cut.levels[0], 0.1);
    EXPECT_GT(cut, flat);
    EXPECT_EQ(order->value().levels[0],
              make_criterion(CriterionKind::volume, surface.view())->value().first());
}

TEST(ComposedCriteria, RoundingsDecideNothing) {
    const Surface surface = sample();
    const auto mean = make_criterion(CriterionKind::mean, surface.view());
    const auto order = parse_criterion("mean,area", surface.view(), {}, 0.5);
    int small = 0;
    for (Index e = 0; e < surface.triangulation().edge_count(); ++e) {
        if (!surface.triangulation().can_flip(Edge{e})) continue;
        const double change = mean->change(Edge{e}).first();
        const bool counts = std::abs(change) > 0.5;
        EXPECT_EQ(order->change(Edge{e}).levels[0], counts ? change : 0);
        small += counts ? 0 : 1;
    }
    EXPECT_GT(small, 0);
}

TEST(ComposedCriteria, LevelsAreAppended) {
    const Surface surface = sample();
    const auto order = parse_criterion("delaunay,area", surface.view());
    EXPECT_EQ(order->level_count(), 3);
    const auto cotangents = make_criterion(CriterionKind::delaunay, surface.view())->value();
    EXPECT_EQ(order->value().levels[1], cotangents.levels[1]);
    EXPECT_EQ(order->value().levels[2],
              make_criterion(CriterionKind::area, surface.view())->value().first());
    EXPECT_THAT([&] { (void)parse_criterion("delaunay,delaunay", surface.view()); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("1 to 3 levels, not 4")));
    EXPECT_THROW((void)lexicographic({}), std::invalid_argument);
}

TEST(ComposedCriteria, WhatOneForbidsIsForbidden) {
    // Over the unit square, closed by the marked vertex 4.
    const Surface surface =
        make_surface({{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}},
                     {{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 1}, {0, 1, 0}, {0, 0, -1}});
    const Vertex marked{4};
    const Edge folding = edge_between(surface, 0, 2);
    EXPECT_FALSE(parse_criterion("area", surface.view(), marked)->change(folding).is_forbidden());
    EXPECT_TRUE(
        parse_criterion("area+-1*jnd", surface.view(), marked)->change(folding).is_forbidden());
    EXPECT_TRUE(
        parse_criterion("area,jnd", surface.view(), marked)->change(folding).is_forbidden());
}

TEST(ComposedCriteria, BadTextIsRefusedWithItsPlace) {
    const Surface surface = sample();
    const auto message = [&](std::string_view text) -> std::string {
        try {
            (void)parse_criterion(text, surface.view());
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(message("tight;mean"), HasSubstr("character 6: '+', ',' or the end"));
    EXPECT_THAT(message("tigth"),
                HasSubstr("character 1: a criterion is expected: one of tight, mean"));
    EXPECT_THAT(message(""), HasSubstr("character 1: a criterion is expected"));
    EXPECT_THAT(message("area+"), HasSubstr("character 6"));
    EXPECT_THAT(message("2 area"), HasSubstr("character 3: '*' is expected"));
    EXPECT_THAT(message("1e999*area"), HasSubstr("character 1"));
    EXPECT_THAT(message("inf*area"), HasSubstr("finite"));
    EXPECT_THAT(message("area,"), HasSubstr("character 6"));
    EXPECT_EQ(message("  area , mean "), "");
}

}  // namespace
}  // namespace tightflip::geometry
