#include "shapes.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/cross_sections.hpp>
#include <tightflip/geometry/surface_measures.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

Contour polygon(int corners, double radius, double height, double turn = 0) {
    Contour contour;
    for (int i = 0; i < corners; ++i) {
        const double angle = turn + 2 * std::numbers::pi * i / corners;
        contour.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
    return contour;
}

Contour square(double height) {
    return {{0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height}};
}

Surface sewn(const std::vector<Contour>& sections) {
    return surface_from_cross_sections(sections).value();
}

bool is_simple(const Triangulation& t) {
    std::set<std::pair<Index, Index>> pairs;
    for (Index h = 0; h < t.halfedge_count(); ++h)
        pairs.insert({t.origin({h}).id, t.target({h}).id});
    return pairs.size() == static_cast<std::size_t>(t.halfedge_count());
}

TEST(CrossSections, SquaresMakeABox) {
    const Surface surface = sewn({square(0), square(1), square(3)});
    EXPECT_EQ(surface.triangulation().genus(), 0);
    EXPECT_EQ(surface.triangulation().vertex_count(), 12);
    EXPECT_DOUBLE_EQ(measure(surface.view()).volume, 3);
    EXPECT_DOUBLE_EQ(measure(surface.view()).area, 14);
    EXPECT_TRUE(is_convex_surface(surface.view(), FlatEdges::admitted));
}

TEST(CrossSections, EitherDirectionOfTurningWillDo) {
    Contour turned = square(1);
    std::ranges::reverse(turned);
    Contour shifted = square(3);
    std::rotate(shifted.begin(), shifted.begin() + 2, shifted.end());
    const Surface surface = sewn({square(0), turned, shifted});
    EXPECT_DOUBLE_EQ(measure(surface.view()).volume, 3);
    EXPECT_TRUE(is_convex_surface(surface.view(), FlatEdges::admitted));
}

TEST(CrossSections, BandsBetweenDifferentNumbersAreSimple) {
    for (const int m : {3, 4, 9, 30}) {
        for (const int n : {3, 5, 40}) {
            for (const double radius : {0.001, 0.5, 1.0, 100.0}) {
                const Surface surface =
                    sewn({polygon(m, 1, 0), polygon(n, radius, 0.5, 0.3), polygon(m, 1, 2, 0.1)});
                EXPECT_EQ(surface.triangulation().genus(), 0);
                EXPECT_EQ(surface.triangulation().vertex_count(), 2 * m + n);
                EXPECT_TRUE(is_simple(surface.triangulation())) << m << ' ' << n << ' ' << radius;
                EXPECT_GT(measure(surface.view()).volume, 0);
            }
        }
    }
}

TEST(CrossSections, ABarrelIsNearlyRoundAndConvexInItsData) {
    const int k = 60;
    const Surface surface = sewn({polygon(k, 1, 0), polygon(k, 0.85, 1), polygon(k, 0.6, 2)});
    EXPECT_TRUE(is_convex_data(surface.points()));
    const auto frustum = [](double r, double s) {
        return std::numbers::pi * (r * r + r * s + s * s) / 3;
    };
    const double volume = frustum(1, 0.85) + frustum(0.85, 0.6);
    EXPECT_NEAR(measure(surface.view()).volume, volume, 0.003 * volume);
}

/// Of all bands from one pair of corners round to it again, given as the rings that the triangles
/// have their sides on, the least area of those that change rings there and join no pair twice.
double least_area(const Contour& low, const Contour& high, std::size_t i0, std::size_t j0) {
    const auto at = [](const Contour& ring, std::size_t k) { return ring[k % ring.size()]; };
    std::vector<int> word(low.size(), 0);
    word.resize(low.size() + high.size(), 1);
    double least = 1e300;
    do {
        if (word.front() == word.back()) continue;
        double area = 0;
        std::size_t i = 0;
        std::size_t j = 0;
        std::set<std::pair<std::size_t, std::size_t>> pairs;
        for (const int ring : word) {
            pairs.insert({i % low.size(), j % high.size()});
            const Point a = at(low, i0 + i);
            const Point b = at(high, j0 + j);
            const Point c = ring == 0 ? at(low, i0 + ++i) : at(high, j0 + ++j);
            area += (b - a).cross(c - a).norm() / 2;
        }
        if (pairs.size() == word.size()) least = std::min(least, area);
    } while (std::ranges::next_permutation(word).found);
    return least;
}

TEST(CrossSections, TheBandHasTheLeastAreaThroughTheShortestSegment) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        kernel::RandomStream random(seed);
        const auto ring = [&](int corners, double height) {
            Contour contour = polygon(corners, 1, height);
            for (Point& point : contour) {
                const double factor = 1 + 0.2 * random_coordinate(random);
                point.x() *= factor;
                point.y() *= factor;
            }
            return contour;
        };
        const Contour low = ring(6, 0);
        const Contour high = ring(5, 1);
        std::size_t i0 = 0;
        std::size_t j0 = 0;
        for (std::size_t i = 0; i < low.size(); ++i) {
            for (std::size_t j = 0; j < high.size(); ++j) {
                if ((low[i] - high[j]).norm() < (low[i0] - high[j0]).norm()) {
                    i0 = i;
                    j0 = j;
                }
            }
        }
        const Surface surface = sewn({low, high});
        double band = 0;
        for (const Halfedge h : surface.triangulation().faces()) {
            const SurfaceView view = surface.view();
            const Point& a = view.origin(h);
            if (a.z() == view.target(h).z() && a.z() == view.opposite(h).z()) continue;
            band += (view.target(h) - a).cross(view.opposite(h) - a).norm() / 2;
        }
        EXPECT_NEAR(band, least_area(low, high, i0, j0), 1e-12);
    }
}

TEST(CrossSections, RefusesWithThePlace) {
    const auto refusal = [](const std::vector<Contour>& sections) {
        return surface_from_cross_sections(sections).refusal();
    };
    EXPECT_EQ(refusal({square(0)}).fault, DataFault::too_few_sections);
    EXPECT_EQ(refusal({square(0), {{0, 0, 1}, {1, 0, 1}}}),
              (DataRefusal{DataFault::contour_too_short, {1, -1}}));
    EXPECT_EQ(refusal({square(0), square(0)}),
              (DataRefusal{DataFault::contours_not_ascending, {1, -1}}));
    Contour bent = square(1);
    bent[2].z() = 1.5;
    EXPECT_EQ(refusal({square(0), bent}), (DataRefusal{DataFault::contour_not_horizontal, {1, 6}}));
    bent = square(1);
    std::swap(bent[1], bent[2]);
    EXPECT_EQ(refusal({square(0), bent}), (DataRefusal{DataFault::contour_not_simple, {4, 6}}));
    bent = square(1);
    bent[3].x() = NAN;
    EXPECT_EQ(refusal({square(0), bent}), (DataRefusal{DataFault::not_finite, {7, -1}}));
}

TEST(CrossSections, HugeContoursAreSewnToo) {
    Contour low = square(-1e308);
    Contour high = square(1e308);
    for (Contour* contour : {&low, &high}) {
        for (Point& point : *contour)
            point.head<2>() = (point.head<2>().array() - 0.5) * 1.6e308;
    }
    EXPECT_EQ(sewn({low, high}).triangulation().genus(), 0);
}

}  // namespace
}  // namespace tightflip::geometry
