#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/properties/point_kinds.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::Point;
using geometry::Sign;
using Points = std::vector<Point>;

constexpr std::uint64_t seeds = 40;

Points made(std::string_view kind, Index count, std::uint64_t seed) {
    return find_point_kind(kind)->make(count, seed);
}

/// Of 12 points, how many fours of neighbours in the list are coplanar, and threes collinear.
struct Degeneracy {
    int fours = 0;
    int coplanar = 0;
    int collinear = 0;

    explicit Degeneracy(const Points& points) {
        for (std::size_t i = 0; i + 3 < points.size(); ++i, ++fours) {
            const Point& a = points[i];
            coplanar +=
                geometry::orientation(a, points[i + 1], points[i + 2], points[i + 3]) == Sign::zero
                    ? 1
                    : 0;
            collinear += geometry::are_collinear(a, points[i + 1], points[i + 2]) ? 1 : 0;
        }
    }
};

std::set<std::array<double, 3>> places(const Points& points) {
    std::set<std::array<double, 3>> distinct;
    for (const Point& point : points)
        distinct.insert({point.x(), point.y(), point.z()});
    return distinct;
}

double largest(const Points& points) {
    double size = 0;
    for (const Point& point : points)
        size = std::max(size, point.cwiseAbs().maxCoeff());
    return size;
}

double volume(const Points& points, std::size_t i) {
    const Point u = points[i + 1] - points[i];
    return std::abs(u.cross(points[i + 2] - points[i]).dot(Point(points[i + 3] - points[i])));
}

TEST(PointKinds, KeepTheirOrder) {  // byte strings of the fuzz targets refer to it
    std::vector<std::string_view> names;
    for (const PointKind& kind : point_kinds())
        names.push_back(kind.name);
    names.resize(17);
    EXPECT_THAT(names, ::testing::ElementsAre(
                           "general", "grid", "coincident", "collinear", "near-collinear",
                           "coplanar", "near-coplanar", "near-grid", "sphere", "cospherical", "far",
                           "needles", "huge", "tiny", "subnormal", "scales", "wild"));
}

TEST(PointKinds, AreFoundByTheirNamesAlone) {
    std::set<std::string_view> names;
    for (const PointKind& kind : point_kinds()) {
        EXPECT_EQ(find_point_kind(kind.name), &kind);
        EXPECT_TRUE(names.insert(kind.name).second) << kind.name << " twice";
        EXPECT_FALSE(kind.description.empty());
    }
    EXPECT_EQ(find_point_kind("Grid"), nullptr);
    EXPECT_EQ(find_point_kind(""), nullptr);
}

TEST(PointKinds, AreFiniteSeededAndOfTheSizeAskedFor) {
    for (const PointKind& kind : point_kinds()) {
        int distinct_seeds = 0;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const Points points = kind.make(50, seed);
            ASSERT_EQ(points.size(), 50U);
            for (const Point& point : points)
                ASSERT_TRUE(point.allFinite()) << kind.name << ", seed " << seed;
            EXPECT_EQ(points, kind.make(50, seed));
            distinct_seeds += points == kind.make(50, seed + 1) ? 0 : 1;
            // A smaller surface has the first of the points: what is shrunk keeps its shape.
            EXPECT_TRUE(std::ranges::equal(kind.make(7, seed), std::span(points).first(7)));
        }
        EXPECT_EQ(distinct_seeds, seeds) << kind.name;
        EXPECT_TRUE(kind.make(0, 1).empty());
    }
}

TEST(PointKinds, AreInGeneralPositionOrInNoneAsTheySay) {
    struct Row {
        const char* kind;
        bool all_coplanar;
        bool all_collinear;
        bool some_coplanar;
        bool some_collinear;
    };
    for (const Row& row :
         {Row{"general", false, false, false, false}, Row{"grid", false, false, true, true},
          Row{"coincident", false, false, true, true}, Row{"collinear", true, true, true, true},
          Row{"near-collinear", false, false, false, false},
          Row{"coplanar", true, false, true, true},
          Row{"near-coplanar", false, false, false, false},
          Row{"sphere", false, false, false, false}, Row{"cospherical", false, false, true, true},
          Row{"needles", false, false, false, false}, Row{"huge", false, false, false, false},
          Row{"subnormal", false, false, true, true}, Row{"scales", false, false, false, false}}) {
        int fours = 0;
        int coplanar = 0;
        int collinear = 0;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const Degeneracy seen(made(row.kind, 12, seed));
            fours += seen.fours;
            coplanar += seen.coplanar;
            collinear += seen.collinear;
        }
        EXPECT_EQ(coplanar == fours, row.all_coplanar) << row.kind;
        EXPECT_EQ(collinear == fours, row.all_collinear) << row.kind;
        // "Some": too many for chance; roundings of nearly degenerate points may hit now and then.
        EXPECT_EQ(coplanar > fours / 20, row.some_coplanar) << row.kind << ": " << coplanar;
        EXPECT_EQ(collinear > fours / 50, row.some_collinear) << row.kind << ": " << collinear;
    }
}

TEST(PointKinds, NearKindsAreWithinRoundingsOfDegenerateOnes) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const Points line = made("near-collinear", 12, seed);
        const Points plane = made("near-coplanar", 12, seed);
        const Points grid = made("near-grid", 12, seed);
        for (std::size_t i = 0; i + 3 < line.size(); ++i) {
            const Point u = line[i + 1] - line[i];
            EXPECT_LT(u.cross(Point(line[i + 2] - line[i])).norm(), 1e-13);
            EXPECT_LT(volume(plane, i), 1e-13);
            for (const double coordinate : grid[i]) {
                EXPECT_GE(coordinate, 0.999);
                EXPECT_LT(std::abs(coordinate - std::round(coordinate)), 1e-14);
            }
        }
    }
    // And not quite on them.
    int off = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        for (const Point& point : made("near-grid", 12, seed))
            off += point == point.array().round().matrix() ? 0 : 1;
    }
    EXPECT_GT(off, static_cast<int>(seeds) * 9);
}

TEST(PointKinds, HaveFewPlacesWhereTheySay) {
    std::set<std::size_t> sizes;
    for (std::uint64_t seed = 0; seed < seeds; ++seed)
        sizes.insert(places(made("coincident", 50, seed)).size());
    EXPECT_EQ(sizes, (std::set<std::size_t>{1, 2, 3, 4}));
    std::set<double> grid_sizes;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const Points points = made("grid", 100, seed);
        grid_sizes.insert(largest(points));
        for (const Point& point : points)
            EXPECT_EQ(point, point.array().round().matrix());
    }
    EXPECT_EQ(grid_sizes, (std::set<double>{1, 2, 3, 4}));
}

TEST(PointKinds, LieOnSpheres) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        for (const Point& point : made("sphere", 20, seed))
            EXPECT_NEAR(point.norm(), 1, 1e-15);
    }
    std::set<std::pair<double, std::size_t>> spheres;  // the radius squared, how many points
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const Points lattice = made("cospherical", 3000, seed);
        for (const Point& point : lattice)
            EXPECT_EQ(point.squaredNorm(), lattice.front().squaredNorm());
        spheres.emplace(lattice.front().squaredNorm(), places(lattice).size());
    }
    EXPECT_EQ(spheres, (std::set<std::pair<double, std::size_t>>{{9, 30}, {81, 102}}));
}

TEST(PointKinds, HaveTheSizesTheySay) {
    struct Row {
        const char* kind;
        int least;  // exponents of the largest coordinate of 50 points
        int most;
    };
    for (const auto& [kind, least, most] :
         {Row{"general", -1, 0}, Row{"far", 20, 50}, Row{"needles", 9, 60}, Row{"huge", 499, 1023},
          Row{"tiny", -1071, -500}, Row{"subnormal", -1074, -1072}, Row{"scales", 20, 30},
          Row{"wild", 800, 1023}}) {
        std::set<int> exponents;
        for (std::uint64_t seed = 0; seed < seeds; ++seed)
            exponents.insert(std::ilogb(largest(made(kind, 50, seed))));
        EXPECT_GE(*exponents.begin(), least) << kind;
        EXPECT_LE(*exponents.rbegin(), most) << kind;
        if (most - least > 100) {
            EXPECT_LT(*exponents.begin(), least + 150) << kind;
            EXPECT_GT(*exponents.rbegin(), most - 150) << kind;
        }
    }
}

}  // namespace
}  // namespace tightflip::properties
