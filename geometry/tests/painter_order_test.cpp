#include "painter_order.hpp"

#include "shapes.hpp"

#include <map>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

double area_of(const Piece& piece) {
    double sum = 0;
    for (std::size_t i = 2; i < piece.corners.size(); ++i)
        sum += seen_area(piece.corners[0], piece.corners[i - 1], piece.corners[i]);
    return sum;
}

/// Whether a convex piece covers a place in the picture, by more than a rounding.
bool covers(const Piece& piece, const Point& place) {
    const double turn = area_of(piece) > 0 ? 1 : -1;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
        const Point& a = piece.corners[i];
        const Point& b = piece.corners[(i + 1) % piece.corners.size()];
        if (turn * seen_area(a, b, place) < 1e-9) return false;
    }
    return true;
}

double depth_at(const Piece& piece, const Point& place) {
    const Point& a = piece.corners[0];
    const Point normal = (piece.corners[1] - a).cross(piece.corners[2] - a);
    return a.z() - normal.head<2>().dot((place - a).head<2>()) / normal.z();
}

/// Triangles about random points, of a size.
std::vector<Piece> random_triangles(std::uint64_t seed, int count, double size) {
    kernel::RandomStream random(seed);
    std::vector<Piece> pieces;
    for (Index i = 0; i < count; ++i) {
        const Point middle = random_point(random);
        std::vector<Point> corners;
        for (int k = 0; k < 3; ++k)
            corners.emplace_back(middle + size * random_point(random));
        const bool is_front = seen_area(corners[0], corners[1], corners[2]) > 0;
        pieces.push_back({corners, i, is_front});
    }
    return pieces;
}

void expect_nearest_painted_last(const std::vector<Piece>& given, std::uint64_t seed) {
    const std::vector<Piece> painted = painter_order(given, 1 << 20);
    std::map<Index, double> area;
    for (const Piece& piece : painted)
        area[piece.face] += area_of(piece);
    for (const Piece& piece : given)
        EXPECT_NEAR(area[piece.face], area_of(piece), 1e-5) << piece.face;

    kernel::RandomStream random(seed);
    int covered = 0;
    for (int i = 0; i < 300; ++i) {
        const Point place = random_point(random);
        double nearest = -1e9;
        for (const Piece& piece : given) {
            if (covers(piece, place)) nearest = std::max(nearest, depth_at(piece, place));
        }
        const auto last = std::find_if(painted.rbegin(), painted.rend(),
                                       [&](const Piece& p) { return covers(p, place); });
        if (last == painted.rend()) continue;
        ++covered;
        const Piece& whole = given[static_cast<std::size_t>(last->face)];
        EXPECT_NEAR(depth_at(whole, place), nearest, 1e-5);
    }
    EXPECT_GT(covered, 100);
}

TEST(PainterOrder, NearCoversFarWhereTrianglesIntersect) {
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        expect_nearest_painted_last(random_triangles(seed, 30, 1), seed);
}

TEST(PainterOrder, NearCoversFarAmongManySmallTriangles) {
    expect_nearest_painted_last(random_triangles(1, 2000, 0.15), 1);
}

TEST(PainterOrder, CyclesOfOverlapAreCut) {
    // Three slats, each over the next.
    std::vector<Piece> slats;
    for (Index i = 0; i < 3; ++i) {
        const Eigen::AngleAxisd turn(2.0943951023931953 * i, Point::UnitZ());
        std::vector<Point> corners;
        for (const Point& corner :
             {Point(-1, -0.5, -0.3), Point(1, -0.5, 0.3), Point(1, -0.3, 0.3)}) {
            corners.emplace_back(turn * corner);
        }
        slats.push_back({corners, i, true});
    }
    const std::vector<Piece> painted = painter_order(slats, 100);
    EXPECT_GT(painted.size(), slats.size());
    std::map<Index, double> area;
    for (const Piece& piece : painted)
        area[piece.face] += area_of(piece);
    for (const Piece& slat : slats)
        EXPECT_NEAR(area[slat.face], area_of(slat), 1e-6);
}

TEST(PainterOrder, OfPiecesOnEachOtherInnerSidesComeFirst) {
    const std::vector<Point> corners{{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0.25}};
    const std::vector<Point> turned{corners[0], corners[2], corners[1]};
    for (const bool front_first : {true, false}) {
        const Piece front{corners, 7, true};
        const Piece back{turned, 3, false};
        const std::vector<Piece> painted =
            painter_order(front_first ? std::vector{front, back} : std::vector{back, front}, 10);
        ASSERT_EQ(painted.size(), 2U);
        EXPECT_FALSE(painted[0].is_front);
        EXPECT_TRUE(painted[1].is_front);
    }
}

TEST(PainterOrder, ConvexSolidsStayWhole) {
    for (const Surface& surface : {cube(), icosahedron(), octahedron(), regular_tetrahedron()}) {
        const std::vector<Point> seen = project(surface.points(), 31, 17);
        const SurfaceView projected{surface.triangulation().table(), seen};
        std::vector<Piece> pieces = face_pieces(projected, EdgeLines(projected));
        const std::size_t whole = pieces.size();
        EXPECT_EQ(painter_order(std::move(pieces), 1000).size(), whole);
    }
}

TEST(PainterOrder, CutsNoMoreThanAllowedAndLeavesOutWhatCannotBeSeen) {
    const std::vector<Piece> given = random_triangles(3, 200, 1);
    EXPECT_GT(painter_order(given, 1 << 20).size(), 2000U);
    for (const std::size_t most : {0U, 200U, 500U, 1000U}) {
        const std::vector<Piece> painted = painter_order(given, most);
        EXPECT_GE(painted.size(), given.size());
        EXPECT_LE(painted.size(), std::max(most, given.size()));
    }
    const Piece from_the_side{{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 1}}, 0, true};
    const Piece no_area{{{0, 0, 0}, {1, 1, 1}, {0.5, 0.5, 0.5}}, 3, true};
    const Piece point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, 6, true};
    EXPECT_TRUE(painter_order({from_the_side, no_area, point}, 10).empty());
    EXPECT_TRUE(painter_order({}, 10).empty());
}

}  // namespace
}  // namespace tightflip::geometry
