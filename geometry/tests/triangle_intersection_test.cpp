/// \file
/// Pairs of triangles against linear programming in fractions, and by hand.
#include "common_points.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/triangle_intersection.hpp>

#include <algorithm>
#include <map>
#include <ostream>

#include <gtest/gtest.h>

namespace tightflip::geometry {

static void PrintTo(Contact contact, std::ostream* out) {
    *out << static_cast<int>(contact);
}

namespace {

Triangle random_triangle(kernel::RandomStream& random, std::uint32_t bound) {
    return {random_grid_point(random, bound), random_grid_point(random, bound),
            random_grid_point(random, bound)};
}

/// On a grid; often with corners of each other, in one plane, or on a line.
std::pair<Triangle, Triangle> random_pair(kernel::RandomStream& random) {
    const std::uint32_t bound = 1 + random.below(3);
    Triangle f = random_triangle(random, bound);
    Triangle g = random_triangle(random, bound);
    for (std::size_t i = random.below(8); i < 3; ++i)
        g.at(random.below(3)) = f.at(i);
    if (random.below(3) == 0) {
        for (std::size_t i = 0; i < 3; ++i)
            f.at(i).z() = g.at(i).z() = 0;
    }
    if (random.below(6) == 0) {
        for (Point& corner : g)
            corner.y() = corner.x();
    }
    return {f, g};
}

std::string text(const Triangle& f, const Triangle& g) {
    std::ostringstream out;
    for (const Triangle& t : {f, g}) {
        for (const Point& p : t)
            out << '(' << p.transpose() << ") ";
    }
    return out.str();
}

/// Corners of both, none, one or two of them.
std::vector<Point> some_shared_corners(const Triangle& f, const Triangle& g,
                                       kernel::RandomStream& random) {
    std::vector<Point> shared;
    for (const Point& corner : f) {
        if (std::ranges::find(g, corner) != g.end() && shared.size() < 2) shared.push_back(corner);
    }
    if (!shared.empty()) shared.resize(random.below(static_cast<std::uint32_t>(shared.size() + 1)));
    return shared;
}

bool beyond_by_definition(const std::vector<FractionPoint>& common,
                          const std::vector<Point>& shared) {
    return std::ranges::any_of(common, [&](const FractionPoint& x) {
        return shared.empty() ||
               !lies_in_hull(x, as_fractions(shared.front()), as_fractions(shared.back()));
    });
}

TEST(TriangleIntersection, AgreesWithLinearProgramming) {
    kernel::RandomStream random(4242);
    std::map<Contact, int> seen;
    std::map<bool, int> seen_beyond;
    for (int trial = 0; trial < 15000; ++trial) {
        const auto [f, g] = random_pair(random);
        const auto common = common_points(f, g);
        const Contact expected = dimension(common);
        ASSERT_EQ(contact(f, g), expected) << text(f, g);
        ASSERT_EQ(triangles_meet(f, g), expected != Contact::none) << text(f, g);
        const auto shared = some_shared_corners(f, g, random);
        const bool is_beyond = beyond_by_definition(common, shared);
        ASSERT_EQ(triangles_meet_beyond(f, g, shared), is_beyond)
            << text(f, g) << " but " << shared.size();
        ++seen[expected];
        if (!shared.empty()) ++seen_beyond[is_beyond];
    }
    for (const auto kind : {Contact::none, Contact::point, Contact::segment, Contact::area}) {
        EXPECT_GT(seen[kind], 500);
    }
    EXPECT_GT(seen_beyond[false], 500);
    EXPECT_GT(seen_beyond[true], 500);
}

TEST(TriangleIntersection, IsTheSameForAnyOrderOfCornersAndTrianglesAndAnyScale) {
    kernel::RandomStream random(17);
    for (int trial = 0; trial < 500; ++trial) {
        auto [f, g] = random_pair(random);
        const Contact expected = contact(f, g);
        for (int order = 0; order < 12; ++order) {
            random.shuffle(std::span<Point>(f));
            random.shuffle(std::span<Point>(g));
            std::swap(f, g);
            const int exponent = static_cast<int>(random.below(2000)) - 1000;
            Triangle scaled_f = f;
            Triangle scaled_g = g;
            for (Triangle* t : {&scaled_f, &scaled_g}) {
                for (Point& p : *t)
                    p = {std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                         std::ldexp(p.z(), exponent)};
            }
            ASSERT_EQ(contact(scaled_f, scaled_g), expected) << text(f, g) << exponent;
        }
    }
}

TEST(TriangleIntersection, ContainsThePointsThatCornersSpan) {
    kernel::RandomStream random(31);
    std::map<bool, int> seen;
    for (int trial = 0; trial < 5000; ++trial) {
        const auto [f, g] = random_pair(random);
        const bool expected = !common_points(f, {g[0], g[0], g[0]}).empty();
        ASSERT_EQ(triangle_contains(f, g[0]), expected) << text(f, g);
        ++seen[expected];
    }
    EXPECT_GT(seen[false], 500);
    EXPECT_GT(seen[true], 500);
}

TEST(TriangleIntersection, KindsByHand) {
    const Triangle base{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
    const Point up(1, 1, 2);
    const Point down(1, 1, -2);
    EXPECT_EQ(contact(base, base), Contact::area);
    EXPECT_EQ(contact(base, {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}), Contact::area);      // inside
    EXPECT_EQ(contact(base, {{{3, 3, 0}, {-1, 3, 0}, {3, -1, 0}}}), Contact::area);    // a star
    EXPECT_EQ(contact(base, {{{3, 3, 0}, {4, 3, 0}, {3, 4, 0}}}), Contact::none);      // coplanar
    EXPECT_EQ(contact(base, {{{1, -1, 0}, {3, -1, 0}, {2, 0, 0}}}), Contact::point);   // on a side
    EXPECT_EQ(contact(base, {{{1, 0, 0}, {6, 0, 0}, {5, -1, 0}}}), Contact::segment);  // sides
    EXPECT_EQ(contact(base, {{{4, 0, 0}, {6, 0, 0}, {5, -1, 0}}}), Contact::point);
    EXPECT_EQ(contact(base, {{up, {9, 9, 1}, {1, 1, 0}}}), Contact::point);
    EXPECT_EQ(contact(base, {{up, down, {9, 9, 0}}}), Contact::segment);
    EXPECT_EQ(contact(base, {{up, {1, 2, 2}, {2, 1, 2}}}), Contact::none);
    EXPECT_EQ(contact(base, {{up, down, down}}), Contact::point);  // a needle
    EXPECT_EQ(contact(base, {{up, {1, 1, 1}, {1, 1, 0.5}}}), Contact::none);
    EXPECT_EQ(contact(base, {{{-1, 1, 0}, {9, 1, 0}, {2, 1, 0}}}), Contact::segment);
    EXPECT_EQ(contact({{up, up, up}}, {{up, up, up}}), Contact::point);
    EXPECT_EQ(contact({{up, up, up}}, {{up, down, down}}), Contact::point);
    EXPECT_EQ(contact({{up, up, up}}, base), Contact::none);
}

TEST(TriangleIntersection, IsDecidedWhereRoundingCannot) {
    // A corner one unit in the last place above, on and below the other triangle.
    const Triangle base{{{0, 0, 0}, {1, 0, 1e-300}, {0, 1, 1e-300}}};
    const auto above = [&](double z) {
        return Triangle{{{0.5, 0.5, z}, {0.5, 0.5, 1}, {1, 1, 1}}};
    };
    EXPECT_EQ(contact(base, above(1e-300)), Contact::point);
    EXPECT_EQ(contact(base, above(std::nextafter(1e-300, 1))), Contact::none);
    EXPECT_EQ(contact(base, above(std::nextafter(1e-300, 0))), Contact::point);  // it goes through
    const double huge = std::numeric_limits<double>::max();
    const Triangle far{{{-huge, -huge, 0}, {huge, -huge, 0}, {0, huge, 0}}};
    EXPECT_EQ(contact(far, {{{0, 0, -huge}, {0, 0, huge}, {1, 0, huge}}}), Contact::segment);
    EXPECT_EQ(contact(far, {{{0, 0, 5e-324}, {0, 0, huge}, {1, 0, huge}}}), Contact::none);
}

}  // namespace
}  // namespace tightflip::geometry
