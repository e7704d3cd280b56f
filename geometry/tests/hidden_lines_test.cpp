#include "hidden_lines.hpp"

#include "shapes.hpp"

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

constexpr std::array<Index, 2> no_faces{-1, -1};

/// Whether the line from a place towards the viewer meets the triangle beyond the place, by
/// Cramer's rule.
bool hides(const Piece& piece, const Point& place) {
    Eigen::Matrix3d sides;
    sides << piece.corners[1] - piece.corners[0], piece.corners[2] - piece.corners[0],
        -Point::UnitZ();
    const Point solution = sides.inverse() * (place - piece.corners[0]);
    return solution[0] > 0 && solution[1] > 0 && solution[0] + solution[1] < 1 &&
           solution[2] > 1e-6;
}

std::vector<Piece> random_triangles(std::uint64_t seed, Index count, double size) {
    kernel::RandomStream random(seed);
    std::vector<Piece> pieces;
    for (Index i = 0; i < count; ++i) {
        const Point middle = random_point(random);
        pieces.push_back(
            {{middle + size * random_point(random), middle + size * random_point(random),
              middle + size * random_point(random)},
             i,
             true});
    }
    return pieces;
}

double length_of(const std::vector<Interval>& parts) {
    double sum = 0;
    for (const Interval& part : parts)
        sum += part.end - part.begin;
    return sum;
}

TEST(HidingFaces, AgreeWithRaysFromPointsOfALine) {
    constexpr int samples = 500;
    for (const auto& [count, size] :
         {std::pair{5, 0.8}, std::pair{60, 0.3}, std::pair{1500, 0.05}}) {
        const std::vector<Piece> triangles = random_triangles(4, count, size);
        HidingFaces faces(triangles);
        kernel::RandomStream random(9);
        double all = 0;
        for (int i = 0; i < 40; ++i) {
            const Point a = random_point(random);
            const Point b = random_point(random);
            const std::vector<Interval> parts = faces.visible(a, b, no_faces);
            int seen = 0;
            for (int k = 0; k < samples; ++k) {
                const double t = (k + 0.5) / samples;
                const Point place = a + t * (b - a);
                const bool is_hidden = std::ranges::any_of(
                    triangles, [&](const Piece& piece) { return hides(piece, place); });
                seen += is_hidden ? 0 : 1;
                EXPECT_EQ(faces.is_visible(place, -1), !is_hidden);
            }
            // Two ends for each triangle that the line passes behind, each half a sample off.
            const double ends = 2.0 * static_cast<double>(parts.size()) + 2;
            EXPECT_NEAR(length_of(parts), static_cast<double>(seen) / samples, ends / samples);
            all += length_of(parts);
        }
        EXPECT_GT(all, 4);   // something is seen
        EXPECT_LT(all, 36);  // and something hidden
    }
}

TEST(HidingFaces, PartsAreInOrderAndApart) {
    const std::vector<Piece> triangles = random_triangles(5, 300, 0.2);
    HidingFaces faces(triangles);
    kernel::RandomStream random(2);
    for (int i = 0; i < 200; ++i) {
        double from = 0;
        for (const Interval& part :
             faces.visible(random_point(random), random_point(random), no_faces)) {
            EXPECT_GE(part.begin, from);
            EXPECT_GT(part.end, part.begin);
            from = part.end;
        }
        EXPECT_LE(from, 1);
    }
}

TEST(HidingFaces, NothingHidesItselfOrWhatLiesOnIt) {
    const Piece triangle{{{0, 0, 0}, {1, 0, 0.5}, {0, 1, -0.5}}, 6, true};
    HidingFaces faces({triangle});
    const auto on = [&](double s, double t) {
        return Point(triangle.corners[0] + s * (triangle.corners[1] - triangle.corners[0]) +
                     t * (triangle.corners[2] - triangle.corners[0]));
    };
    EXPECT_TRUE(faces.is_visible(on(0.3, 0.3), -1));
    EXPECT_TRUE(faces.is_visible(on(0, 0.5), -1));
    EXPECT_EQ(length_of(faces.visible(on(0.1, 0.2), on(0.7, 0.1), no_faces)), 1);
    const Point below = on(0.3, 0.3) - Point(0, 0, 0.1);
    EXPECT_FALSE(faces.is_visible(below, -1));
    EXPECT_TRUE(faces.is_visible(below, 6));
    EXPECT_TRUE(faces.is_visible(on(0.3, 0.3) + Point(0, 0, 0.1), -1));
    // What runs exactly behind its outline is hidden too.
    const Point down(0, 0, 0.1);
    EXPECT_TRUE(faces.visible(on(0, 0) - down, on(1, 0) - down, no_faces).empty());
    EXPECT_EQ(length_of(faces.visible(on(0, 0) - down, on(1, 0) - down, {6, -1})), 1);
}

TEST(HidingFaces, SegmentsWithoutLengthAndFacesWithoutArea) {
    const Piece from_the_side{{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 1}}, 0, true};
    const Piece point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, 3, true};
    HidingFaces none({from_the_side, point});
    EXPECT_TRUE(none.is_visible({0.5, 0, -1}, -1));
    EXPECT_TRUE(none.is_visible({1, 1, 0}, -1));
    HidingFaces empty({});
    EXPECT_EQ(length_of(empty.visible({0, 0, 0}, {1, 1, 1}, no_faces)), 1);
}

}  // namespace
}  // namespace tightflip::geometry
