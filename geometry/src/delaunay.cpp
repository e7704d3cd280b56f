#include "face_mesh.hpp"
#include "lexicographic.hpp"
#include <tightflip/geometry/delaunay.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <cstdint>

namespace tightflip::geometry {
namespace {

constexpr Index none = -1;

/// The bits of a number spread to every second place.
std::uint64_t spread(std::uint64_t bits) {
    std::uint64_t result = 0;
    for (unsigned i = 0; i < 16; ++i)
        result |= (bits >> i & 1) << 2 * i;
    return result;
}

/// Rounds of doubling size, each random among what is left, and each along a curve that fills the
/// plane. Which order it is matters for speed alone.
void order_for_insertion(Points points, std::vector<Index>& labels) {
    Eigen::Vector2d low = points[static_cast<std::size_t>(labels.front())].head<2>();
    Eigen::Vector2d high = low;
    for (const Index i : labels) {
        low = low.cwiseMin(points[static_cast<std::size_t>(i)].head<2>());
        high = high.cwiseMax(points[static_cast<std::size_t>(i)].head<2>());
    }
    const auto cell = [&](double x, double from, double to) {
        const double part = (x * 0.5 - from * 0.5) / (to * 0.5 - from * 0.5);
        return spread(part >= 0 && part <= 1 ? static_cast<std::uint64_t>(part * 65535) : 0);
    };
    const auto place = [&](Index i) {
        const Point& p = points[static_cast<std::size_t>(i)];
        return cell(p.x(), low.x(), high.x()) | cell(p.y(), low.y(), high.y()) << 1;
    };
    kernel::RandomStream(0).shuffle(std::span(labels));
    std::vector<std::pair<std::uint64_t, Index>> round;
    for (std::size_t begin = 0; begin < labels.size();) {
        const std::size_t end = std::min(labels.size(), std::max<std::size_t>(1024, 2 * begin));
        round.clear();
        for (std::size_t i = begin; i < end; ++i)
            round.emplace_back(place(labels[i]), labels[i]);
        std::ranges::sort(round);
        for (std::size_t i = begin; i < end; ++i)
            labels[i] = round[i - begin].second;
        begin = end;
    }
}

/// The triangulation closed by a vertex at infinity, joined to all of the boundary.
class Delaunay {
public:
    /// Starts from a triangle, counter-clockwise.
    Delaunay(Points points, const Face& triangle)
        : points_(points),
          infinity_(static_cast<Index>(points.size())),
          mesh_(start(triangle, infinity_), infinity_ + 1) {}

    void insert(Index v) {
        const Index f = locate(v);
        const Index side = side_under(f, v);
        const auto first_new = static_cast<Index>(mesh_.faces().size());
        mesh_.split_face(f, v);
        std::vector<Index>& suspects = suspects_;
        suspects.assign({3 * f, 3 * first_new, 3 * (first_new + 1)});
        if (side != none) {
            const Index under = side == 3 * f ? side : 3 * (first_new + side - 3 * f - 1);
            const Index beyond = mesh_.twin(under) / 3;
            mesh_.flip(under);
            suspects.push_back(3 * beyond);
        }
        while (!suspects.empty()) {
            const Index s = suspects.back();
            suspects.pop_back();
            const Index beyond = mesh_.twin(s) / 3;
            if (!conflicts(beyond, v)) continue;
            mesh_.flip(s);
            suspects.push_back(s);
            suspects.push_back(3 * beyond);
        }
        last_ = f;
    }

    [[nodiscard]] PlaneTriangulation result() const;

private:
    static std::array<Face, 4> start(const Face& triangle, Index infinity) {
        const auto [a, b, c] = triangle;
        return {{{a, b, c}, {b, a, infinity}, {c, b, infinity}, {a, c, infinity}}};
    }

    [[nodiscard]] const Point& point(Index i) const { return points_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] Sign turn(Index a, Index b, Index c) const {
        return orientation_in_plane(point(a), point(b), point(c));
    }

    /// The side of a face that is opposite the vertex at infinity; none of a finite face.
    [[nodiscard]] Index finite_side(Index f) const {
        for (Index s = 3 * f; s < 3 * f + 3; ++s) {
            if (mesh_.corner(FaceMesh::before(s)) == infinity_) return s;
        }
        return none;
    }

    /// Whether v lies inside the circle of a face; of a face at infinity, beyond its side.
    [[nodiscard]] bool conflicts(Index f, Index v) const {
        const Index s = finite_side(f);
        if (s != none) {
            return turn(mesh_.corner(s), mesh_.corner(FaceMesh::after(s)), v) == Sign::positive;
        }
        const auto [a, b, c] = mesh_.corners(f);
        const Sign inside = in_circle_in_plane(point(a), point(b), point(c), point(v));
        if (inside != Sign::zero) return inside == Sign::positive;
        // The determinant grows with the height of each lifted point by the turn of the others.
        const Index highest = std::max({a, b, c, v});
        if (highest == v) return false;
        if (highest == a) return turn(b, c, v) == Sign::positive;
        if (highest == b) return turn(c, a, v) == Sign::positive;
        return turn(a, b, v) == Sign::positive;
    }

    /// The finite face that contains v, or a face at infinity beyond whose side v lies. The walk
    /// ends: in a Delaunay triangulation no faces hide each other in a cycle.
    [[nodiscard]] Index locate(Index v) const {
        Index f = last_;
        if (const Index s = finite_side(f); s != none) f = mesh_.twin(s) / 3;
        while (finite_side(f) == none) {
            Index s = 3 * f;
            while (s < 3 * f + 3 &&
                   turn(mesh_.corner(s), mesh_.corner(FaceMesh::after(s)), v) != Sign::negative) {
                ++s;
            }
            if (s == 3 * f + 3) return f;
            f = mesh_.twin(s) / 3;
        }
        return f;
    }

    /// The side of a finite face that a point of it lies on; none where it is inside.
    [[nodiscard]] Index side_under(Index f, Index v) const {
        if (finite_side(f) != none) return none;
        for (Index s = 3 * f; s < 3 * f + 3; ++s) {
            if (turn(mesh_.corner(s), mesh_.corner(FaceMesh::after(s)), v) == Sign::zero) return s;
        }
        return none;
    }

    Points points_;
    Index infinity_;
    FaceMesh mesh_;
    Index last_ = 0;
    std::vector<Index> suspects_;
};

PlaneTriangulation Delaunay::result() const {
    PlaneTriangulation result;
    std::vector<Index> following(points_.size(), none);
    for (Index f = 0; f < static_cast<Index>(mesh_.faces().size()); ++f) {
        const Index s = finite_side(f);
        if (s != none) {  // seen from infinity the boundary runs clockwise
            const Index to = mesh_.corner(s);
            following[static_cast<std::size_t>(mesh_.corner(FaceMesh::after(s)))] = to;
            continue;
        }
        Face face = mesh_.corners(f);
        std::rotate(face.begin(), std::ranges::min_element(face), face.end());
        result.faces.push_back(face);
    }
    std::ranges::sort(result.faces);
    const auto lowest = std::ranges::find_if(following, [](Index after) { return after != none; });
    const auto first = static_cast<Index>(lowest - following.begin());
    Index v = first;
    do {
        result.boundary.push_back(v);
        v = following[static_cast<std::size_t>(v)];
    } while (v != first);
    return result;
}

}  // namespace

Outcome<PlaneTriangulation> delaunay_in_plane(Points points) {
    if (const auto bad = point_not_finite(points)) {
        return DataRefusal{DataFault::not_finite, {*bad, -1}};
    }
    if (points.size() < 3) return DataRefusal{DataFault::too_few_points};
    std::vector<std::array<Index, 2>> coincident;
    std::vector<Index> labels = distinct_in_plane(points, coincident);
    if (!coincident.empty()) {
        const auto [label, first] = coincident.front();
        return DataRefusal{DataFault::coincident_points, {first, label}};
    }
    const Index a = labels.front();
    const Index b = labels.back();
    const auto turn = [&](Index c) {
        return orientation_in_plane(points[static_cast<std::size_t>(a)],
                                    points[static_cast<std::size_t>(b)],
                                    points[static_cast<std::size_t>(c)]);
    };
    const auto third = std::ranges::find_if(labels, [&](Index c) { return turn(c) != Sign::zero; });
    if (third == labels.end()) return DataRefusal{DataFault::collinear_points};
    const Index c = *third;
    Delaunay triangulation(points, turn(c) == Sign::positive ? Face{a, b, c} : Face{b, a, c});
    order_for_insertion(points, labels);
    for (const Index i : labels) {
        if (i != a && i != b && i != c) triangulation.insert(i);
    }
    return triangulation.result();
}

}  // namespace tightflip::geometry
