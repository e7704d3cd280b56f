#include "height_grid.hpp"
#include "shapes.hpp"
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/curvature.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/hinge.hpp>
#include <tightflip/geometry/surface_measures.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

constexpr double pi = std::numbers::pi;

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Whether two energies agree in every level, up to roundings of values of size `size`.
testing::AssertionResult agree(const Energy& a, const Energy& b, const Energy& size) {
    for (std::size_t i = 0; i < Energy::max_levels; ++i) {
        if (a.levels[i] == b.levels[i]) continue;
        const double tolerance = 1e-10 * (1 + std::abs(size.levels[i]));
        if (!(std::abs(a.levels[i] - b.levels[i]) <= tolerance)) {
            return testing::AssertionFailure()
                   << "level " << i << ": " << a.levels[i] << " and " << b.levels[i];
        }
    }
    return testing::AssertionSuccess();
}

/// Flips random edges; each change announced has to be the difference of the values.
void walk(Surface surface, CriterionKind kind, Vertex marked, std::uint64_t seed, int steps) {
    SCOPED_TRACE(testing::Message() << info(kind).name << ", seed " << seed);
    kernel::RandomStream random(seed);
    const auto criterion = make_criterion(kind, surface.view(), marked);
    Triangulation& triangulation = surface.triangulation();
    Energy before = criterion->value();
    int done = 0;
    for (int step = 0; step < steps; ++step) {
        const Edge e{static_cast<Index>(
            random.below(static_cast<std::uint32_t>(triangulation.edge_count())))};
        if (!triangulation.can_flip(e)) continue;
        const Energy change = criterion->change(e);
        if (change.is_forbidden()) continue;
        ASSERT_TRUE(triangulation.flip(e));
        criterion->flipped(e);
        const Energy after = criterion->value();
        ASSERT_TRUE(agree(change, after - before, before) || agree(change, after - before, after))
            << "edge " << e.id << ", step " << step;
        // What is kept from flip to flip is what a new criterion would start from.
        if (step % 16 == 0) {
            const auto fresh = make_criterion(kind, surface.view(), marked);
            const Edge other{static_cast<Index>(
                random.below(static_cast<std::uint32_t>(triangulation.edge_count())))};
            if (triangulation.can_flip(other) && !info(kind).needs_heights) {
                EXPECT_TRUE(agree(criterion->change(other), fresh->change(other), before));
            }
        }
        before = after;
        ++done;
    }
    EXPECT_GT(done, steps / 20);
}

std::vector<CriterionKind> kinds(bool for_heights) {
    std::vector<CriterionKind> result;
    for (const CriterionInfo& info : all_criteria()) {
        if (!info.needs_heights || for_heights) result.push_back(info.kind);
    }
    return result;
}

TEST(Criterion, LocalChangeIsTheDifferenceInGeneralPosition) {
    for (const CriterionKind kind : kinds(false)) {
        std::uint64_t seed = 1;
        for (const Triangulation& family : all_families()) {
            if (family.vertex_count() < 4) continue;
            ++seed;
            walk(with_random_points(family, seed), kind, {}, seed, 120);
        }
    }
}

TEST(Criterion, LocalChangeIsTheDifferenceOnDegenerateData) {
    for (const CriterionKind kind : kinds(false)) {
        for (const std::uint32_t bound : {0U, 1U, 2U, 5U}) {
            std::uint64_t seed = 100 * bound;
            for (const Triangulation& family : all_families()) {
                if (family.vertex_count() < 4) continue;
                ++seed;
                walk(with_grid_points(family, seed, bound), kind, {}, seed, 60);
            }
        }
    }
}

TEST(Criterion, LocalChangeIsTheDifferenceOnNeedles) {
    // Points of many magnitudes: most faces have two sides far longer than the third. (The volume
    // is small beside what its faces add and take away.)
    for (const CriterionKind kind : kinds(false)) {
        if (kind == CriterionKind::volume) continue;
        for (const std::uint64_t seed : {1, 2, 3}) {
            const Surface start = with_random_points(kernel::families::random(20, 0, seed), seed);
            std::vector<Point> points(start.points().begin(), start.points().end());
            kernel::RandomStream random(seed);
            for (Point& point : points)
                point *= std::pow(10.0, static_cast<double>(random.below(61)) - 30);
            walk({start.triangulation(), points}, kind, {}, seed, 200);
        }
    }
}

TEST(Criterion, LocalChangeIsTheDifferenceOnHeights) {
    for (const CriterionKind kind : kinds(true)) {
        for (const std::uint64_t seed : {1, 2, 3}) {
            HeightGrid grid = random_height_grid(6, seed);
            walk(std::move(grid.surface), kind, grid.marked, seed, 400);
        }
        HeightGrid flat = height_grid(5, [](double x, double y) { return Point(x, y, x + y > 1); });
        walk(std::move(flat.surface), kind, flat.marked, 4, 200);
    }
}

/// Asks for all changes before and after each flip: those that are others have to be announced, and
/// what is kept has to be what a new criterion finds.
void walk_asking_for_all(Surface surface, CriterionKind kind, Vertex marked, std::uint64_t seed,
                         int steps) {
    SCOPED_TRACE(testing::Message() << info(kind).name << ", seed " << seed);
    kernel::RandomStream random(seed);
    Triangulation& triangulation = surface.triangulation();
    const auto criterion = make_criterion(kind, surface.view(), marked);
    const auto edges = static_cast<std::uint32_t>(triangulation.edge_count());
    const auto change = [&](Criterion& of, Index e) {
        return triangulation.can_flip(Edge{e}) ? of.change(Edge{e}) : Energy::forbidden();
    };
    std::vector<Energy> changes(edges);
    for (std::uint32_t e = 0; e < edges; ++e)
        changes[e] = change(*criterion, static_cast<Index>(e));
    const Energy size = criterion->value();
    for (int step = 0; step < steps; ++step) {
        const Edge flipped{static_cast<Index>(random.below(edges))};
        if (changes[static_cast<std::size_t>(flipped.id)].is_forbidden()) continue;
        step % 3 == 0 ? triangulation.unflip(flipped) : triangulation.flip(flipped);
        criterion->flipped(flipped);
        std::vector<Edge> list;
        criterion->append_affected(flipped, list);
        const std::set<Edge> affected(list.begin(), list.end());
        ASSERT_TRUE(affected.contains(flipped));
        const auto fresh =
            info(kind).needs_heights ? nullptr : make_criterion(kind, surface.view(), marked);
        for (std::uint32_t i = 0; i < edges; ++i) {
            const Edge e{static_cast<Index>(i)};
            const Energy now = change(*criterion, e.id);
            if (fresh) {
                ASSERT_TRUE(agree(now, change(*fresh, e.id), size)) << "edge " << i;
            }
            if (!affected.contains(e)) {
                ASSERT_TRUE(agree(now, changes[i], size)) << "edge " << i << " was not announced";
            }
            changes[i] = now;
            if (now.is_forbidden()) continue;
            const Energy improvement = criterion->improvement(e);
            if (now < Energy(0) || improvement < Energy(0)) {
                ASSERT_TRUE(agree(now, improvement, size)) << "edge " << i;
            }
        }
    }
}

TEST(Criterion, AnnouncesTheEdgesThatAFlipMattersTo) {
    for (const CriterionKind kind : kinds(false)) {
        std::uint64_t seed = 1;
        for (const Triangulation& family : all_families()) {
            if (family.vertex_count() < 4) continue;
            ++seed;
            walk_asking_for_all(with_random_points(family, seed), kind, {}, seed, 25);
            walk_asking_for_all(with_grid_points(family, seed, 2), kind, {}, seed, 25);
        }
    }
    for (const CriterionKind kind : kinds(true)) {
        HeightGrid grid = random_height_grid(6, 5);
        walk_asking_for_all(std::move(grid.surface), kind, grid.marked, 5, 100);
    }
}

TEST(Criterion, ValuesAreThoseOfTheWholeSurface) {
    const auto value = [](CriterionKind kind, const Surface& surface) {
        return make_criterion(kind, surface.view())->value();
    };
    for (const Surface& surface : {regular_tetrahedron(), cube(), icosahedron(),
                                   with_random_points(kernel::families::random(30, 1, 5), 7),
                                   with_grid_points(kernel::families::random(30, 0, 6), 8, 2)}) {
        const SurfaceMeasures sums = measure(surface.view());
        const auto expect = [&](CriterionKind kind, double expected) {
            EXPECT_NEAR(value(kind, surface).first(), expected, 1e-11 * (1 + std::abs(expected)))
                << info(kind).name;
        };
        expect(CriterionKind::tight, sums.total_absolute_curvature);
        expect(CriterionKind::mean, sums.mean_absolute_curvature);
        expect(CriterionKind::mean_weighted, sums.mean_absolute_curvature_weighted);
        expect(CriterionKind::abn, 2 * sums.mean_absolute_curvature);
        expect(CriterionKind::area, sums.area);
        expect(CriterionKind::volume, -sums.volume);
    }
    // The regular tetrahedron of edge sqrt(8): six edges with acos(-1/3) between normals.
    const Surface solid = regular_tetrahedron();
    const double angle = std::acos(-1.0 / 3);
    EXPECT_NEAR(value(CriterionKind::edge_length, solid).first(), 6 * std::sqrt(8.0), 1e-13);
    EXPECT_NEAR(value(CriterionKind::abn_squares, solid).first(), 6 * angle * angle, 1e-13);
    EXPECT_NEAR(value(CriterionKind::min_angle, solid).first(), 0, 1e-13);
    EXPECT_NEAR(value(CriterionKind::delaunay, solid).levels[1], 12 / std::sqrt(3.0), 1e-13);
    EXPECT_EQ(value(CriterionKind::delaunay, solid).levels[0], 0);
    EXPECT_NEAR(value(CriterionKind::min_angle, cube()).first(), 12 * (pi / 3 - pi / 4), 1e-13);
}

TEST(Criterion, FacesWithoutAreaAreCountedFirst) {
    // Six points of which three lie on a line, twice.
    std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    const Surface surface = make_surface(
        {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 4}, {3, 0, 4}, {2, 3, 4}}, std::move(points));
    EXPECT_EQ(make_criterion(CriterionKind::delaunay, surface.view())->value().levels[0], 1);
    const auto criterion = make_criterion(CriterionKind::delaunay, surface.view());
    EXPECT_EQ(criterion->change(edge_between(surface, 2, 0)).levels[0], -1);
}

TEST(Criterion, VolumeFallsExactlyAtConcaveEdges) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        for (const bool on_grid : {false, true}) {
            const Triangulation start = kernel::families::random(40, 0, seed);
            Surface surface =
                on_grid ? with_grid_points(start, seed, 2) : with_random_points(start, seed);
            const auto criterion = make_criterion(CriterionKind::volume, surface.view());
            for (Index e = 0; e < start.edge_count(); ++e) {
                if (!start.can_flip(Edge{e})) continue;
                const double change = criterion->change(Edge{e}).first();
                const EdgeShape shape = edge_shape(surface.view(), Edge{e});
                EXPECT_EQ(change < 0, shape == EdgeShape::concave);
                EXPECT_EQ(change > 0, shape == EdgeShape::convex);
            }
        }
    }
    // An edge that is concave by one unit in the last place, which products of doubles cannot see.
    const double tiny = std::numeric_limits<double>::denorm_min();
    const Surface surface = make_surface({{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}},
                                         {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, tiny}});
    const auto criterion = make_criterion(CriterionKind::volume, surface.view());
    EXPECT_EQ(edge_shape(surface.view(), edge_between(surface, 0, 1)), EdgeShape::concave);
    EXPECT_LT(criterion->change(edge_between(surface, 0, 1)).first(), 0);
}

TEST(Criterion, DelaunayInThePlane) {
    for (const std::uint64_t seed : {1, 2}) {
        const HeightGrid grid = random_height_grid(7, seed);
        const auto lifted =
            make_criterion(CriterionKind::delaunay_plane, grid.surface.view(), grid.marked);
        Index decided = 0;
        for (Index e = 0; e < grid.surface.triangulation().edge_count(); ++e) {
            const Energy change = lifted->change(Edge{e});
            if (change.is_forbidden()) continue;
            const Hinge h = Hinge::at(grid.surface.view(), Edge{e});
            const Sign inside = in_circle_in_plane(h.a, h.b, h.c, h.d);
            EXPECT_EQ(change.first() < 0, inside == Sign::positive);
            EXPECT_EQ(change.first() > 0, inside == Sign::negative);
            ++decided;
        }
        EXPECT_GT(decided, 40);
    }
}

TEST(Criterion, CotangentsFallWhereOppositeAnglesExceedPi) {
    // In a plane, where no flip changes lengths of the others.
    kernel::RandomStream random(5);
    HeightGrid grid = height_grid(7, [&](double x, double y) {
        const bool is_inner = x > 0 && x < 1 && y > 0 && y < 1;
        const double shake = is_inner ? 0.06 : 0;
        return Point(x + shake * random_coordinate(random), y + shake * random_coordinate(random),
                     0);
    });
    const auto cotangents =
        make_criterion(CriterionKind::delaunay, grid.surface.view(), grid.marked);
    const auto lifted =
        make_criterion(CriterionKind::delaunay_plane, grid.surface.view(), grid.marked);
    Index falling = 0;
    for (Index e = 0; e < grid.surface.triangulation().edge_count(); ++e) {
        if (lifted->change(Edge{e}).is_forbidden()) continue;
        const bool falls = lifted->change(Edge{e}).first() < 0;
        EXPECT_EQ(cotangents->change(Edge{e}).levels[1] < 0, falls);
        falling += falls ? 1 : 0;
    }
    EXPECT_GT(falling, 5);
}

/// The gradient of the plane of three points.
Eigen::Vector2d gradient_of(const Point& p, const Point& q, const Point& r) {
    Eigen::Matrix2d sides;
    sides << (q - p).head<2>().transpose(), (r - p).head<2>().transpose();
    return sides.inverse() * Eigen::Vector2d(q.z() - p.z(), r.z() - p.z());
}

/// |grad P1 - grad P2| across an edge, gradients by solving for the planes.
double slope_jump(const Hinge& h) {
    return (gradient_of(h.a, h.b, h.c) - gradient_of(h.b, h.a, h.d)).norm();
}

TEST(Criterion, JumpInNormalDerivative) {
    const HeightGrid grid = random_height_grid(6, 3);
    const SurfaceView view = grid.surface.view();
    double sum = 0;
    for (Index e = 0; e < grid.surface.triangulation().edge_count(); ++e) {
        const Halfedge h = halfedge_of(Edge{e});
        const Triangulation& t = grid.surface.triangulation();
        const std::set<Vertex> corners{t.origin(h), t.target(h), t.opposite(h),
                                       t.opposite(twin(h))};
        if (!corners.contains(grid.marked)) sum += slope_jump(Hinge::at(view, Edge{e}));
    }
    EXPECT_NEAR(make_criterion(CriterionKind::jnd, view, grid.marked)->value().first(), sum,
                1e-11 * sum);
}

// The paper says that the jump in normal derivative is related to the mean curvature: with the
// slope s along the edge and the gradients g1, g2 of the faces, the exterior angle 2 |H| satisfies
// sin(2 |H|) = jump sqrt(1 + s^2) / sqrt((1 + |g1|^2) (1 + |g2|^2)).
TEST(Criterion, TheJumpInNormalDerivativeIsRelatedToTheExteriorAngle) {
    kernel::RandomStream random(2);
    int agreements = 0;
    int disagreements = 0;
    for (int i = 0; i < 500; ++i) {
        // A quadrilateral with one diagonal and then the other, heights at random
        // (of a square both jumps would be equal)
        std::vector<Point> p{{0, 0, 0}, {1, 0, 0}, {1.5, 1.2, 0}, {0, 1, 0}};
        for (Point& point : p)
            point.z() = 2 * random_coordinate(random);
        const Hinge one{p[0], p[2], p[3], p[1]};
        const Hinge other{p[1], p[3], p[0], p[2]};
        for (const Hinge& h : {one, other}) {
            const double slope = (h.b.z() - h.a.z()) / (h.b - h.a).head<2>().norm();
            const double first = gradient_of(h.a, h.b, h.c).squaredNorm();
            const double second = gradient_of(h.b, h.a, h.d).squaredNorm();
            const double sine = slope_jump(h) * std::sqrt(1 + slope * slope) /
                                std::sqrt((1 + first) * (1 + second));
            EXPECT_NEAR(std::sin(std::abs(exterior_angle(h))), sine, 1e-12);
        }
        const bool jump_prefers_one = slope_jump(one) < slope_jump(other);
        const bool mean_prefers_one =
            std::abs(exterior_angle(one)) < std::abs(exterior_angle(other));
        ++(jump_prefers_one == mean_prefers_one ? agreements : disagreements);
    }
    // Related, and not the same: they disagree about some quadrilaterals.
    EXPECT_GT(agreements, disagreements);
    EXPECT_GT(disagreements, 0);
}

/// The cubic patch in Bernstein form, written out, and its energy by differences at the middles of
/// the sides, a rule that is exact for the square of a linear function.
double patch_energy(const std::array<Point, 3>& p, const std::array<Eigen::Vector2d, 3>& gradient) {
    const auto control = [&](int i, int j) {
        const Eigen::Vector2d step =
            (p[static_cast<std::size_t>(j)] - p[static_cast<std::size_t>(i)]).head<2>() / 3;
        return p[static_cast<std::size_t>(i)].z() + gradient[static_cast<std::size_t>(i)].dot(step);
    };
    double six = 0;
    for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}})
        six += control(i, j);
    const double middle = six / 4 - (p[0].z() + p[1].z() + p[2].z()) / 6;
    Eigen::Matrix2d sides;
    sides << (p[1] - p[0]).head<2>(), (p[2] - p[0]).head<2>();
    const Eigen::Matrix2d inverse = sides.inverse();
    const auto height = [&](const Eigen::Vector2d& at) {
        const Eigen::Vector2d vw = inverse * (at - p[0].head<2>());
        const double v = vw.x();
        const double w = vw.y();
        const double u = 1 - v - w;
        return p[0].z() * u * u * u + p[1].z() * v * v * v + p[2].z() * w * w * w +
               3 * (control(0, 1) * u * u * v + control(0, 2) * u * u * w +
                    control(1, 0) * v * v * u + control(1, 2) * v * v * w +
                    control(2, 0) * w * w * u + control(2, 1) * w * w * v) +
               6 * middle * u * v * w;
    };
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d at = (p[i] + p[(i + 1) % 3]).head<2>() / 2;
        const double d = 1e-3;
        const Eigen::Vector2d x(d, 0);
        const Eigen::Vector2d y(0, d);
        const double xx = (height(at + x) - 2 * height(at) + height(at - x)) / (d * d);
        const double yy = (height(at + y) - 2 * height(at) + height(at - y)) / (d * d);
        const double xy =
            (height(at + x + y) - height(at + x - y) - height(at - x + y) + height(at - x - y)) /
            (4 * d * d);
        sum += xx * xx + 2 * xy * xy + yy * yy;
    }
    return sum / 3 * std::abs(sides.determinant()) / 2;
}

TEST(Criterion, BendingEnergy) {
    const auto bending = [](const HeightGrid& grid) {
        return make_criterion(CriterionKind::bending, grid.surface.view(), grid.marked)
            ->value()
            .first();
    };
    const auto plane =
        height_grid(5, [](double x, double y) { return Point(x, y, 2 * x - 3 * y + 1); });
    EXPECT_NEAR(bending(plane), 0, 1e-20);

    const HeightGrid grid = random_height_grid(4, 9);
    const Triangulation& t = grid.surface.triangulation();
    std::vector<Eigen::Vector2d> gradients(grid.surface.points().size(), Eigen::Vector2d::Zero());
    std::vector<double> areas(gradients.size(), 0);
    const auto corners = [&](Halfedge face) {
        return std::array{t.origin(face), t.target(face), t.opposite(face)};
    };
    const auto for_each_inner_face = [&](const auto& use) {
        for (const Halfedge face : t.faces()) {
            const auto c = corners(face);
            if (std::ranges::find(c, grid.marked) == c.end()) use(c);
        }
    };
    for_each_inner_face([&](const std::array<Vertex, 3>& c) {
        const Point& p = grid.surface.point(c[0]);
        Eigen::Matrix2d sides;
        sides << (grid.surface.point(c[1]) - p).head<2>().transpose(),
            (grid.surface.point(c[2]) - p).head<2>().transpose();
        const Eigen::Vector2d gradient =
            sides.inverse() * Eigen::Vector2d(grid.surface.point(c[1]).z() - p.z(),
                                              grid.surface.point(c[2]).z() - p.z());
        for (const Vertex v : c) {
            gradients[static_cast<std::size_t>(v.id)] += gradient * sides.determinant();
            areas[static_cast<std::size_t>(v.id)] += sides.determinant();
        }
    });
    double expected = 0;
    for_each_inner_face([&](const std::array<Vertex, 3>& c) {
        std::array<Point, 3> p;
        std::array<Eigen::Vector2d, 3> g;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto v = static_cast<std::size_t>(c[i].id);
            p[i] = grid.surface.point(c[i]);
            g[i] = gradients[v] / areas[v];
        }
        expected += patch_energy(p, g);
    });
    EXPECT_NEAR(bending(grid), expected, 1e-6 * expected);
}

TEST(Criterion, TheMarkedVertexIsLeftAlone) {
    const HeightGrid grid = random_height_grid(5, 1);
    const Triangulation& t = grid.surface.triangulation();
    for (const CriterionKind kind : kinds(true)) {
        const auto criterion = make_criterion(kind, grid.surface.view(), grid.marked);
        for (Index e = 0; e < t.edge_count(); ++e) {
            const Halfedge h = halfedge_of(Edge{e});
            const bool touches = t.origin(h) == grid.marked || t.target(h) == grid.marked ||
                                 t.opposite(h) == grid.marked || t.opposite(twin(h)) == grid.marked;
            if (touches) {
                EXPECT_TRUE(criterion->change(Edge{e}).is_forbidden()) << info(kind).name;
            } else if (!info(kind).needs_heights) {
                EXPECT_FALSE(criterion->change(Edge{e}).is_forbidden()) << info(kind).name;
            }
        }
        // Nothing depends on where it is.
        std::vector<Point> points(grid.surface.points().begin(), grid.surface.points().end());
        for (const Point& place : {Point(7, -2, 40), Point(1e200, -1e300, 5)}) {
            points.back() = place;
            const Surface elsewhere(t, points);
            EXPECT_EQ(make_criterion(kind, elsewhere.view(), grid.marked)->value(),
                      criterion->value())
                << info(kind).name;
        }
    }
}

TEST(Criterion, WrongDataAreRefused) {
    const Surface solid = cube();
    EXPECT_THAT([&] { (void)make_criterion(CriterionKind::jnd, solid.view()); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("needs the marked vertex")));
    EXPECT_THAT([&] { (void)make_criterion(CriterionKind::bending, solid.view(), Vertex{0}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("is not counter-clockwise")));
    EXPECT_THAT([&] { (void)make_criterion(CriterionKind::bending, solid.view(), Vertex{8}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("needs the marked vertex")));
}

TEST(Criterion, WhatLeavesTheRangeOfDoublesKeepsItsSign) {
    const Surface surface = with_random_points(kernel::families::random(20, 0, 1), 3);
    for (const double factor : {1e200, 1e-200}) {
        const Surface scaled = moved(surface, Eigen::Affine3d(Eigen::Scaling(factor)));
        const auto moderate = make_criterion(CriterionKind::area, surface.view());
        const auto extreme = make_criterion(CriterionKind::area, scaled.view());
        EXPECT_TRUE(std::isfinite(extreme->value().first()));
        EXPECT_GT(extreme->value().first(), 0);
        for (Index e = 0; e < surface.triangulation().edge_count(); ++e) {
            if (!surface.triangulation().can_flip(Edge{e})) continue;
            const double change = extreme->change(Edge{e}).first();
            EXPECT_TRUE(std::isfinite(change));
            EXPECT_EQ(change > 0, moderate->change(Edge{e}).first() > 0);
            EXPECT_EQ(change < 0, moderate->change(Edge{e}).first() < 0);
        }
    }
}

TEST(Criterion, UnitsOfAnySize) {
    const Surface unit = with_random_points(kernel::families::random(20, 0, 3), 4);
    for (const int exponent : {-1000, -300, -40, 40, 300, 1000}) {
        std::vector<Point> points(unit.points().begin(), unit.points().end());
        for (Point& point : points) {
            for (double& x : point)
                x = std::ldexp(x, exponent);
        }
        const Surface scaled(unit.triangulation(), points);
        for (const CriterionKind kind : kinds(false)) {
            const auto criterion = make_criterion(kind, unit.view());
            const auto other = make_criterion(kind, scaled.view());
            for (Index e = 0; e < unit.triangulation().edge_count(); ++e) {
                if (!unit.triangulation().can_flip(Edge{e})) continue;
                const double one = criterion->change(Edge{e}).first();
                const double change = other->change(Edge{e}).first();
                ASSERT_FALSE(std::isnan(change)) << info(kind).name;
                const int dimension =
                    kind == CriterionKind::area     ? 2
                    : kind == CriterionKind::volume ? 3
                    : kind == CriterionKind::edge_length || kind == CriterionKind::mean_weighted
                        ? 1
                        : 0;
                if (dimension * std::abs(exponent) > 900) continue;
                EXPECT_NEAR(std::ldexp(change, -dimension * exponent), one,
                            1e-9 * (1 + std::abs(one)))
                    << info(kind).name;
            }
            EXPECT_FALSE(std::isnan(other->value().first()));
        }
    }
}

TEST(Criterion, EveryOneHasItsName) {
    std::set<std::string_view> names;
    Index place = 0;
    for (const CriterionInfo& entry : all_criteria()) {
        EXPECT_EQ(static_cast<Index>(entry.kind), place++);
        EXPECT_EQ(criterion_by_name(entry.name), entry.kind);
        EXPECT_FALSE(entry.description.empty());
        names.insert(entry.name);
    }
    EXPECT_EQ(names.size(), 13);
    EXPECT_EQ(criterion_by_name("tightest"), std::nullopt);
}

}  // namespace
}  // namespace tightflip::geometry
