#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/general_position.hpp>
#include <tightflip/geometry/triangle_intersection.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/properties/embedded_triangulations.hpp>

#include <algorithm>
#include <bit>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace tightflip::properties {
namespace {

using geometry::Point;
using geometry::Points;
using geometry::Sign;
using Corners = std::array<Index, 3>;

constexpr Index least_vertices = 4;
constexpr Index most_vertices = 8;
constexpr std::size_t most_faces = 56;

constexpr std::array<Corners, most_faces> all_faces = [] {
    std::array<Corners, most_faces> faces{};
    std::size_t bit = 0;
    for (Index c = 2; c < most_vertices; ++c) {
        for (Index b = 1; b < c; ++b) {
            for (Index a = 0; a < b; ++a)
                faces.at(bit++) = {a, b, c};
        }
    }
    return faces;
}();

FaceSet face(Index x, Index y, Index z) {
    Corners corners{x, y, z};
    std::ranges::sort(corners);
    const auto [a, b, c] = corners;
    return FaceSet{1} << static_cast<unsigned>(a + b * (b - 1) / 2 + c * (c - 1) * (c - 2) / 6);
}

/// The number of the lowest face.
std::size_t lowest(FaceSet faces) {
    return static_cast<std::size_t>(std::countr_zero(faces));
}

/// For each pair of vertices, all faces with both; so a graph has the edge where it has any.
using EdgeFaces = std::array<std::array<FaceSet, most_vertices>, most_vertices>;
const EdgeFaces& edge_faces() {
    static const EdgeFaces table = [] {
        EdgeFaces faces{};
        for (const Corners& corners : all_faces) {
            for (const Index x : corners) {
                for (const Index y : corners) {
                    faces.at(static_cast<std::size_t>(x)).at(static_cast<std::size_t>(y)) |=
                        face(corners[0], corners[1], corners[2]);
                }
            }
        }
        return faces;
    }();
    return table;
}

FaceSet faces_at(FaceSet sphere, Index x, Index y) {
    return sphere & edge_faces().at(static_cast<std::size_t>(x)).at(static_cast<std::size_t>(y));
}

Index third_corner(const Corners& corners, Index x, Index y) {
    return corners[0] + corners[1] + corners[2] - x - y;
}

/// The flip of the edge ab of a simple sphere, as far as the graph says.
ConventionalFlip flip_of(FaceSet sphere, Index a, Index b) {
    const FaceSet both = faces_at(sphere, a, b);
    const Index c = third_corner(all_faces.at(lowest(both)), a, b);
    const Index d = third_corner(all_faces.at(lowest(both & (both - 1))), a, b);
    ConventionalFlip flip{.edge = {a, b}, .new_edge = {std::min(c, d), std::max(c, d)}};
    if (faces_at(sphere, c, d) != 0) {
        flip.obstacle = FlipObstacle::parallel_edge;
    } else {
        flip.result = (sphere & ~both) | face(a, c, d) | face(b, c, d);
    }
    return flip;
}

std::vector<ConventionalFlip> flips_of(FaceSet sphere) {
    std::vector<ConventionalFlip> flips;
    for (Index a = 0; a < most_vertices; ++a) {
        for (Index b = a + 1; b < most_vertices; ++b) {
            if (faces_at(sphere, a, b) != 0) flips.push_back(flip_of(sphere, a, b));
        }
    }
    return flips;
}

/// Two vertices joined to all others, which form a path.
FaceSet double_fan(Index vertices) {
    FaceSet sphere = face(0, 1, 2) | face(0, 1, vertices - 1);
    for (Index v = 2; v + 1 < vertices; ++v)
        sphere |= face(0, v, v + 1) | face(1, v, v + 1);
    return sphere;
}

void require_vertices(Index vertices) {
    if (vertices < least_vertices || vertices > most_vertices) {
        throw std::invalid_argument("4 to 8 points are needed, not " + std::to_string(vertices));
    }
}

template <std::size_t size>
void refuse_any(const geometry::OffendingSets<size>& sets, std::string_view what) {
    if (sets.count == 0) return;
    std::string names;
    for (const geometry::Vertex v : sets.first.front())
        names += (names.empty() ? "" : ", ") + std::to_string(v.id);
    throw std::invalid_argument("not in general position: the points " + names + " " +
                                std::string(what));
}

std::vector<Point> in_general_position(std::vector<Point> points) {
    require_vertices(static_cast<Index>(points.size()));
    const auto infinite =
        std::ranges::find_if(points, [](const Point& p) { return !p.allFinite(); });
    if (infinite != points.end()) {
        throw std::invalid_argument("point " + std::to_string(infinite - points.begin()) +
                                    " is not finite");
    }
    const geometry::GeneralPosition position = geometry::general_position(points, 1);
    refuse_any(position.coincident, "coincide");
    refuse_any(position.collinear, "lie on a line");
    refuse_any(position.coplanar, "lie in a plane");
    return points;
}

/// How many of the faces on vertices below a number there are: they come first.
std::size_t face_count(std::size_t vertices) {
    return vertices * (vertices - 1) * (vertices - 2) / 6;
}

bool faces_conflict(Points points, const Corners& f, const Corners& g) {
    const auto at = [points](Index v) -> const Point& {
        return points[static_cast<std::size_t>(v)];
    };
    std::vector<Point> shared;
    for (const Index v : f) {
        if (std::ranges::find(g, v) != g.end()) shared.push_back(at(v));
    }
    return geometry::triangles_meet_beyond({at(f[0]), at(f[1]), at(f[2])},
                                           {at(g[0]), at(g[1]), at(g[2])}, shared);
}

std::array<FaceSet, 64> conflicts_among(Points points) {
    std::array<FaceSet, 64> conflicts{};
    for (std::size_t f = 0; f < face_count(points.size()); ++f) {
        for (std::size_t g = 0; g < f; ++g) {
            if (!faces_conflict(points, all_faces.at(f), all_faces.at(g))) continue;
            conflicts.at(f) |= FaceSet{1} << g;
            conflicts.at(g) |= FaceSet{1} << f;
        }
    }
    return conflicts;
}

/// Whether a vertex's edge is extreme among its edges: with another one it spans a plane that has
/// all the others on one side.
bool is_extreme(const geometry::SurfaceView& surface, kernel::Halfedge edge) {
    const kernel::Neighbours neighbours(surface.table, edge);
    const Point& apex = surface.origin(edge);
    return std::ranges::any_of(neighbours, [&](kernel::Vertex second) {
        std::array<bool, 2> sides{};
        for (const kernel::Vertex v : neighbours) {
            const Sign side = geometry::orientation(apex, surface.target(edge),
                                                    surface.point(second), surface.point(v));
            if (side != Sign::zero) sides.at(side == Sign::positive ? 1 : 0) = true;
        }
        return sides[0] != sides[1];
    });
}

/// Whether the faces of an embedded surface are counter-clockwise seen from outside. At a corner of
/// the hull the body lies in the convex cone of its edges, so that it has a convex angle at those
/// which are extreme.
bool is_outward(const geometry::SurfaceView& surface,
                const std::vector<kernel::Halfedge>& outgoing) {
    const auto corner =
        std::ranges::min_element(surface.points, [](const Point& p, const Point& q) {
            return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
        });
    kernel::Halfedge edge = outgoing.at(static_cast<std::size_t>(corner - surface.points.begin()));
    while (!is_extreme(surface, edge))
        edge = kernel::twin(at(surface.table, at(surface.table, edge).next).next);
    return edge_shape(surface, kernel::edge_of(edge)) == geometry::EdgeShape::convex;
}

}  // namespace

std::vector<std::array<Index, 3>> faces_of(FaceSet faces) {
    std::vector<Corners> corners;
    for (; faces != 0; faces &= faces - 1)
        corners.push_back(all_faces.at(lowest(faces)));
    return corners;
}

std::vector<FaceSet> simple_spheres(Index vertices) {
    require_vertices(vertices);
    std::vector<FaceSet> spheres{double_fan(vertices)};
    std::unordered_set<FaceSet> seen(spheres.begin(), spheres.end());
    for (std::size_t next = 0; next < spheres.size(); ++next) {
        for (const ConventionalFlip& flip : flips_of(spheres[next])) {
            if (flip.obstacle == FlipObstacle::none && seen.insert(flip.result).second) {
                spheres.push_back(flip.result);
            }
        }
    }
    std::ranges::sort(spheres);
    return spheres;
}

EmbeddedTriangulations::EmbeddedTriangulations(const std::vector<Point>& points)
    : EmbeddedTriangulations(points, simple_spheres(static_cast<Index>(points.size()))) {}

EmbeddedTriangulations::EmbeddedTriangulations(std::vector<Point> points,
                                               std::span<const FaceSet> spheres)
    : points_(in_general_position(std::move(points))), conflicts_(conflicts_among(points_)) {
    std::ranges::copy_if(spheres, std::back_inserter(all_),
                         [this](FaceSet sphere) { return are_embedded(sphere); });
    find_components();
}

void EmbeddedTriangulations::find_components() {
    const auto place = [this](FaceSet sphere) {
        return static_cast<std::size_t>(std::ranges::lower_bound(all_, sphere) - all_.begin());
    };
    std::vector<bool> seen(all_.size());
    for (std::size_t start = 0; start < all_.size(); ++start) {
        if (seen[start]) continue;
        seen[start] = true;
        std::vector<FaceSet> component{all_[start]};
        for (std::size_t next = 0; next < component.size(); ++next) {
            for (const ConventionalFlip& flip : flips(component[next])) {
                if (flip.obstacle != FlipObstacle::none || seen[place(flip.result)]) continue;
                seen[place(flip.result)] = true;
                component.push_back(flip.result);
            }
        }
        std::ranges::sort(component);
        components_.push_back(std::move(component));
    }
    std::ranges::stable_sort(components_, {}, &std::vector<FaceSet>::size);
}

bool EmbeddedTriangulations::are_embedded(FaceSet faces) const noexcept {
    for (FaceSet rest = faces; rest != 0; rest &= rest - 1) {
        if ((conflicts_[lowest(rest)] & faces) != 0) return false;
    }
    return true;
}

std::vector<ConventionalFlip> EmbeddedTriangulations::flips(FaceSet sphere) const {
    std::vector<ConventionalFlip> flips = flips_of(sphere);
    for (ConventionalFlip& flip : flips) {
        if (!are_embedded(flip.result)) flip.obstacle = FlipObstacle::self_intersection;
    }
    return flips;
}

geometry::Surface EmbeddedTriangulations::surface(FaceSet sphere) const {
    if (!std::ranges::binary_search(all_, sphere)) {
        throw std::invalid_argument("not an embedded triangulation of the points");
    }
    std::vector<Corners> faces = faces_of(sphere);
    const auto built = [&faces, this] {
        const auto vertices = static_cast<Index>(points_.size());
        return geometry::Surface(build(kernel::glue_faces(faces, vertices).gluing).value(),
                                 points_);
    };
    geometry::Surface surface = built();
    if (is_outward(surface.view(), surface.triangulation().outgoing())) return surface;
    std::swap(faces.front()[0], faces.front()[1]);  // the others are turned to agree with it
    return built();
}

}  // namespace tightflip::properties
