#include "face_mesh.hpp"
#include "lexicographic.hpp"
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/stacked_surface.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <numeric>

namespace tightflip::geometry {
namespace {

using Faces = std::vector<std::array<Index, 3>>;

Index nearest_face(const Faces& faces, Points points, const Point& x) {
    const auto at = [&](Index i) -> const Point& { return points[static_cast<std::size_t>(i)]; };
    const auto distance = [&](const std::array<Index, 3>& face) {
        const Point centroid = at(face[0]) / 3 + at(face[1]) / 3 + at(face[2]) / 3;
        return (centroid - x).stableNorm();
    };
    return static_cast<Index>(std::ranges::min_element(faces, {}, distance) - faces.begin());
}

}  // namespace

Outcome<Surface> stacked_surface(std::vector<Point> points, std::uint64_t seed,
                                 StackingFace choice) {
    if (const auto bad = point_not_finite(points)) {
        return DataRefusal{DataFault::not_finite, {*bad, -1}};
    }
    if (points.size() < 4) return DataRefusal{DataFault::too_few_points};
    const auto at = [&](Index i) -> const Point& { return points[static_cast<std::size_t>(i)]; };
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    kernel::RandomStream random(seed);
    random.shuffle(std::span(order));
    if (orientation(at(order[0]), at(order[1]), at(order[2]), at(order[3])) == Sign::positive) {
        std::swap(order[0], order[1]);
    }
    const Index a = order[0];
    const Index b = order[1];
    const Index c = order[2];
    const Index d = order[3];
    const Faces tetrahedron{{a, b, c}, {b, a, d}, {c, b, d}, {a, c, d}};
    FaceMesh mesh(tetrahedron, static_cast<Index>(points.size()));
    for (const Index v : std::span(order).subspan(4)) {
        const auto count = static_cast<std::uint32_t>(mesh.faces().size());
        const Index f = choice == StackingFace::random ? static_cast<Index>(random.below(count))
                                                       : nearest_face(mesh.faces(), points, at(v));
        mesh.split_face(f, v);
    }
    return surface_of_faces(mesh.faces(), std::move(points));
}

}  // namespace tightflip::geometry
