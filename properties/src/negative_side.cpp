#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/negative_side.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace tightflip::properties {
namespace {

using geometry::orientation;
using geometry::Point;
using geometry::Points;
using geometry::Sign;
using geometry::SurfaceView;
using kernel::Halfedge;
using kernel::Index;
using kernel::Vertex;

using Corners = std::array<Vertex, 3>;

Corners corners_of(const SurfaceView& surface, Halfedge h) {
    const Halfedge next = at(surface.table, h).next;
    return {at(surface.table, h).origin, at(surface.table, next).origin,
            at(surface.table, at(surface.table, next).next).origin};
}

template <class Visit>
void each_face(const SurfaceView& surface, Visit&& visit) {
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        const Halfedge h{id};
        const Halfedge next = at(surface.table, h).next;
        if (h < next && h < at(surface.table, next).next) visit(h);
    }
}

/// Sums of oriented triangles: each by its ascending corners, with a negative number where it is
/// turned the other way.
class Chain {
public:
    void add(Corners corners, int times) {
        int sign = times;
        for (const auto& [i, j] : {std::pair{0U, 1U}, std::pair{1U, 2U}, std::pair{0U, 1U}}) {
            if (corners.at(i) < corners.at(j)) continue;
            std::swap(corners.at(i), corners.at(j));
            sign = -sign;
        }
        int& number = numbers_[corners];
        number += sign;
        if (number == 0) numbers_.erase(corners);
    }

    /// The outward boundary of a tetrahedron whose corner d is behind its face abc.
    void add_boundary(const Tetrahedron& tetrahedron, int times) {
        const auto& [a, b, c, d] = tetrahedron;
        add({a, b, c}, times);
        add({a, d, b}, times);
        add({b, d, c}, times);
        add({c, d, a}, times);
    }

    [[nodiscard]] bool is_zero() const noexcept { return numbers_.empty(); }
    /// Any triangle, turned as it occurs.
    [[nodiscard]] Corners any() const {
        const auto& [corners, number] = *numbers_.begin();
        return number > 0 ? corners : Corners{corners[1], corners[0], corners[2]};
    }

private:
    std::map<Corners, int> numbers_;
};

Chain chain_of(const SurfaceView& surface) {
    Chain chain;
    each_face(surface, [&](Halfedge h) { chain.add(corners_of(surface, h), 1); });
    return chain;
}

Sign orientation_of(const SurfaceView& surface, const Tetrahedron& t) {
    return orientation(surface.point(t[0]), surface.point(t[1]), surface.point(t[2]),
                       surface.point(t[3]));
}

/// Takes tetrahedra away from the chain, each behind one of its triangles, until nothing is left.
bool take_apart(const SurfaceView& surface, Chain& chain, std::size_t most,
                std::vector<Tetrahedron>& taken) {
    if (chain.is_zero()) return true;
    if (taken.size() == most) return false;
    const auto [a, b, c] = chain.any();
    for (Index id = 0; id < static_cast<Index>(surface.points.size()); ++id) {
        const Tetrahedron tetrahedron{a, b, c, Vertex{id}};
        if (orientation_of(surface, tetrahedron) != Sign::negative) continue;
        chain.add_boundary(tetrahedron, -1);
        taken.push_back(tetrahedron);
        if (take_apart(surface, chain, most, taken)) return true;
        taken.pop_back();
        chain.add_boundary(tetrahedron, 1);
    }
    return false;
}

/// What a segment does to a face.
enum class Passage : std::uint8_t { misses, inwards, outwards, touches };

/// Exact; says that it touches also where a line through its ends meets the line of a side, or an
/// end lies in the plane of the face, though it might miss.
Passage passage(const SurfaceView& surface, Halfedge face, const Point& from, const Point& to) {
    const Corners corners = corners_of(surface, face);
    const Point& a = surface.point(corners[0]);
    const Point& b = surface.point(corners[1]);
    const Point& c = surface.point(corners[2]);
    const std::array<Sign, 2> ends{orientation(a, b, c, from), orientation(a, b, c, to)};
    const std::array<Sign, 3> turns{orientation(from, to, a, b), orientation(from, to, b, c),
                                    orientation(from, to, c, a)};
    const auto is_zero = [](Sign sign) { return sign == Sign::zero; };
    if (std::ranges::any_of(ends, is_zero) || std::ranges::any_of(turns, is_zero)) {
        return Passage::touches;
    }
    if (ends[0] == ends[1] || turns[0] != turns[1] || turns[1] != turns[2]) {
        return Passage::misses;
    }
    return ends[0] == Sign::positive ? Passage::inwards : Passage::outwards;
}

/// Whether all points are beyond x on one side along an axis.
bool is_outside_box(Points points, const Point& x) {
    for (int i = 0; i < 3; ++i) {
        const auto below = [&](const Point& p) { return p[i] < x[i]; };
        const auto above = [&](const Point& p) { return p[i] > x[i]; };
        if (std::ranges::all_of(points, below) || std::ranges::all_of(points, above)) return true;
    }
    return false;
}

/// Uniform in 0 .. 1.
double fraction(kernel::RandomStream& random) {
    return static_cast<double>(random.bits() >> 11U) * 0x1p-53;
}

NegativeView random_ray(const SurfaceView& surface, const std::vector<Halfedge>& faces, double size,
                        kernel::RandomStream& random) {
    const Halfedge face = faces[random.below(static_cast<std::uint32_t>(faces.size()))];
    const Corners corners = corners_of(surface, face);
    double u = fraction(random);
    double v = fraction(random);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const Point& a = surface.point(corners[0]);
    const Point target =
        a + u * (surface.point(corners[1]) - a) + v * (surface.point(corners[2]) - a);
    Point direction;
    do {
        for (double& coordinate : direction)
            coordinate = 2 * fraction(random) - 1;
    } while (direction.norm() > 1 || direction.norm() < 0.01);
    direction.normalize();
    return {target + 4 * size * direction, target - 1e-9 * size * direction, face};
}

}  // namespace

bool is_sum_of_tetrahedra(const SurfaceView& surface, std::span<const Tetrahedron> tetrahedra) {
    Chain chain = chain_of(surface);
    for (Tetrahedron tetrahedron : tetrahedra) {
        const Sign sign = orientation_of(surface, tetrahedron);
        if (sign == Sign::zero) return false;
        if (sign == Sign::positive) std::swap(tetrahedron[0], tetrahedron[1]);
        chain.add_boundary(tetrahedron, -1);
    }
    return chain.is_zero();
}

std::optional<std::vector<Tetrahedron>> as_sum_of_tetrahedra(const SurfaceView& surface,
                                                             std::size_t most) {
    Chain chain = chain_of(surface);
    std::vector<Tetrahedron> taken;
    if (!take_apart(surface, chain, most, taken)) return {};
    return taken;
}

bool is_negative_view(const SurfaceView& surface, const NegativeView& view) {
    if (!is_outside_box(surface.points, view.from)) return false;
    if (passage(surface, view.face, view.from, view.to) != Passage::outwards) return false;
    Index met = 0;
    each_face(surface, [&](Halfedge h) {
        met += passage(surface, h, view.from, view.to) == Passage::misses ? 0 : 1;
    });
    return met == 1;
}

std::optional<NegativeView> find_negative_view(const SurfaceView& surface, int rays,
                                               std::uint64_t seed) {
    std::vector<Halfedge> faces;
    each_face(surface, [&](Halfedge h) { faces.push_back(h); });
    double size = 0;
    for (const Point& point : surface.points)
        size = std::max(size, point.lpNorm<Eigen::Infinity>());
    kernel::RandomStream random(seed);
    for (int ray = 0; ray < rays; ++ray) {
        const NegativeView view = random_ray(surface, faces, size, random);
        if (is_negative_view(surface, view)) return view;
    }
    return {};
}

}  // namespace tightflip::properties
