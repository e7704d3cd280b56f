#include "coplanar_triangle.hpp"
#include "face_mesh.hpp"
#include "lexicographic.hpp"
#include "simplex.hpp"
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

constexpr Index none = -1;

/// Lists of points, one a face, without memory of their own.
struct PointList {
    Index head = none;

    void push(std::vector<Index>& next, Index point) {
        next[static_cast<std::size_t>(point)] = head;
        head = point;
    }
};

struct HullFace {
    std::array<Index, 3> corners{};
    std::array<Index, 3> twins{};  ///< of side i, from corner i to corner i + 1: 3 face + side
    PointList above;               ///< points strictly above its plane, not yet added
    PointList on;                  ///< points on it, which may never be added
    Index facet = none;
    bool is_alive = true;
};

class HullBuilder {
public:
    explicit HullBuilder(Points points)
        : points_(points), next_(points.size(), none), fan_(points.size(), none) {}

    /// Builds the hull of the distinct points of these labels, in lexicographic order.
    DataFault build(const std::vector<Index>& labels) {
        std::array<Index, 4> corners{};
        const DataFault fault = choose_simplex(points_, labels, corners);
        if (fault != DataFault::none) return fault;
        start(labels, corners);
        while (!pending_.empty()) {
            // In turn, so that all parts grow alike: were one finished first, points elsewhere
            // would have to be compared with all its faces.
            const Index f = pending_.front();
            pending_.pop_front();
            if (face(f).is_alive && face(f).above.head != none) add_point_above(f);
        }
        return DataFault::none;
    }

    [[nodiscard]] ConvexHull result();

private:
    [[nodiscard]] const Point& point(Index i) const { return points_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] HullFace& face(Index f) { return faces_[static_cast<std::size_t>(f)]; }
    [[nodiscard]] Index twin(Index s) { return face(s / 3).twins[static_cast<std::size_t>(s % 3)]; }
    [[nodiscard]] Index corner(Index s) {
        return face(s / 3).corners[static_cast<std::size_t>(s % 3)];
    }
    void link(Index s, Index t) {
        face(s / 3).twins[static_cast<std::size_t>(s % 3)] = t;
        face(t / 3).twins[static_cast<std::size_t>(t % 3)] = s;
    }
    [[nodiscard]] Sign side_of(Index f, Index i) {
        const auto [a, b, c] = face(f).corners;
        return orientation(point(a), point(b), point(c), point(i));
    }

    void start(const std::vector<Index>& labels, std::array<Index, 4> corners);
    Index new_face(Index a, Index b, Index c);
    void add_point_above(Index f);
    [[nodiscard]] Index take_furthest(Index f);
    void find_seen(Index f, Index apex);
    void put_down(Index i);

    void find_facets();
    void mark_facet(Index f, Index facet);
    [[nodiscard]] bool is_flat(Index s) {
        return side_of(s / 3, corner(FaceMesh::before(twin(s)))) == Sign::zero;
    }
    [[nodiscard]] std::vector<Index> facet_polygon(Index start_side);

    Points points_;
    std::vector<HullFace> faces_;
    std::vector<Index> next_;  // of each point in its list
    std::vector<Index> fan_;   // of each point on the horizon, the new face whose side starts there
    std::deque<Index> pending_;   // faces that may have points above
    std::vector<Index> seen_;     // the faces the point to add sees
    std::vector<Index> free_;     // faces that are no more
    std::vector<Index> horizon_;  // sides of faces that stay, towards the faces seen
    std::vector<Index> made_;     // the faces at the point just added
    std::vector<Index> bends_;    // of each point, how many edges that are not flat meet there
};

void HullBuilder::start(const std::vector<Index>& labels, std::array<Index, 4> corners) {
    const auto [a, b, c, d] = corners;
    new_face(a, b, c);
    new_face(b, a, d);
    new_face(c, b, d);
    new_face(a, c, d);
    for (Index i = 0; i < 3; ++i) {
        link(i, 3 * (i + 1));
        link(3 * (i + 1) + 1, 3 * ((i + 2) % 3 + 1) + 2);
    }
    for (const Index i : labels) {
        if (std::ranges::find(corners, i) == corners.end()) put_down(i);
    }
}

Index HullBuilder::new_face(Index a, Index b, Index c) {
    auto f = static_cast<Index>(faces_.size());
    if (free_.empty()) {
        faces_.emplace_back();
    } else {
        f = free_.back();
        free_.pop_back();
    }
    face(f) = HullFace{};
    face(f).corners = {a, b, c};
    made_.push_back(f);
    pending_.push_back(f);
    return f;
}

Index HullBuilder::take_furthest(Index f) {
    const auto [a, b, c] = face(f).corners;
    const Point& origin = point(a);
    const Point normal = (point(b) - origin).cross(point(c) - origin);
    Index* furthest = &face(f).above.head;
    double largest = normal.dot(point(*furthest) - origin);
    for (Index* link = furthest; *link != none; link = &next_[static_cast<std::size_t>(*link)]) {
        const double height = normal.dot(point(*link) - origin);
        if (height > largest) {
            largest = height;
            furthest = link;
        }
    }
    const Index taken = *furthest;
    *furthest = next_[static_cast<std::size_t>(taken)];
    return taken;
}

/// The faces strictly below the apex, and the horizon about them: one closed path through each of
/// its corners once, for the hull is convex.
void HullBuilder::find_seen(Index f, Index apex) {
    seen_.assign(1, f);
    horizon_.clear();
    face(f).is_alive = false;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const Index g = seen_[i];
        for (const Index t : std::array(face(g).twins)) {
            if (!face(t / 3).is_alive) continue;
            if (side_of(t / 3, apex) == Sign::positive) {
                face(t / 3).is_alive = false;
                seen_.push_back(t / 3);
            } else {
                horizon_.push_back(t);
            }
        }
    }
}

void HullBuilder::add_point_above(Index f) {
    const Index apex = take_furthest(f);
    find_seen(f, apex);
    Index loose = none;
    const auto gather = [&](Index head) {
        while (head != none) {
            const Index after = next_[static_cast<std::size_t>(head)];
            next_[static_cast<std::size_t>(head)] = loose;
            loose = head;
            head = after;
        }
    };
    for (const Index g : seen_) {
        gather(face(g).above.head);
        gather(face(g).on.head);
    }
    free_.insert(free_.end(), seen_.begin(), seen_.end());
    made_.clear();
    for (const Index t : horizon_) {
        const Index start = corner(FaceMesh::after(t));
        const Index made = new_face(start, corner(t), apex);
        link(3 * made, t);
        fan_[static_cast<std::size_t>(start)] = made;
    }
    for (const Index made : made_) {
        const Index following = fan_[static_cast<std::size_t>(face(made).corners[1])];
        link(3 * made + 1, 3 * following + 2);
    }
    while (loose != none) {
        const Index after = next_[static_cast<std::size_t>(loose)];
        put_down(loose);
        loose = after;
    }
}

/// Hands a point to a new face it is strictly above, or on. A point that was above or on a face
/// that is no more, and is neither with one of the new faces, is inside: the points that see a hull
/// see a connected part of it, and who sees the faces on both sides of the horizon also sees the
/// new one there.
void HullBuilder::put_down(Index i) {
    Index rest = none;
    for (const Index f : made_) {
        const Sign side = side_of(f, i);
        if (side == Sign::positive) {
            face(f).above.push(next_, i);
            return;
        }
        if (side != Sign::zero || rest != none) continue;
        const auto [a, b, c] = face(f).corners;
        if (triangle_contains(point(a), point(b), point(c), point(i))) rest = f;
    }
    if (rest != none) face(rest).on.push(next_, i);
}

// ---- the result ----

void HullBuilder::mark_facet(Index f, Index facet) {
    std::vector<Index>& reached = seen_;
    reached.assign(1, f);
    face(f).facet = facet;
    for (std::size_t i = 0; i < reached.size(); ++i) {
        for (Index s = 3 * reached[i]; s < 3 * reached[i] + 3; ++s) {
            if (!is_flat(s)) {
                ++bends_[static_cast<std::size_t>(corner(s))];  // once from each end
                continue;
            }
            HullFace& other = face(twin(s) / 3);
            if (other.facet != none) continue;
            other.facet = facet;
            reached.push_back(twin(s) / 3);
        }
    }
}

void HullBuilder::find_facets() {
    bends_.assign(points_.size(), 0);
    Index facets = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (faces_[f].is_alive && faces_[f].facet == none) {
            mark_facet(static_cast<Index>(f), facets++);
        }
    }
}

/// The extreme corners of the facet with a side that is not flat, from the lowest on.
std::vector<Index> HullBuilder::facet_polygon(Index start_side) {
    std::vector<Index> polygon;
    Index s = start_side;
    do {
        const Index v = corner(s);
        if (bends_[static_cast<std::size_t>(v)] > 2) polygon.push_back(v);
        s = FaceMesh::after(s);
        while (face(twin(s) / 3).facet == face(s / 3).facet)
            s = FaceMesh::after(twin(s));
    } while (s != start_side);
    std::rotate(polygon.begin(), std::ranges::min_element(polygon), polygon.end());
    return polygon;
}

/// Of the fan over a polygon from its first corner, the number of a triangle that contains a point
/// of the polygon.
std::size_t fan_triangle(Points points, const std::vector<Index>& polygon, const Point& x) {
    const auto at = [&](std::size_t i) -> const Point& {
        return points[static_cast<std::size_t>(polygon[i])];
    };
    std::size_t low = 1;
    std::size_t high = polygon.size() - 1;
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        const bool is_after = coplanar_side(at(0), at(middle), at(middle + 1), x) != Sign::negative;
        (is_after ? low : high) = middle;
    }
    return low - 1;
}

ConvexHull HullBuilder::result() {
    find_facets();
    ConvexHull hull;
    hull.positions.assign(points_.size(), HullPosition::inside);
    hull.face_of.assign(points_.size(), none);

    // Edges of a corner: 0 within a facet, 2 within an edge of the hull, otherwise at a corner.
    std::vector<std::vector<Index>> polygons;
    const auto is_corner = [&](Index v) { return bends_[static_cast<std::size_t>(v)] > 2; };
    const auto polygon_of = [&](Index facet) -> std::vector<Index>& {
        const auto i = static_cast<std::size_t>(facet);
        if (i >= polygons.size()) polygons.resize(i + 1);
        return polygons[i];
    };
    const auto alive = [&](Index f) { return face(f).is_alive; };
    const auto count = static_cast<Index>(faces_.size());
    for (Index s = 0; s < 3 * count; ++s) {
        if (!alive(s / 3) || face(twin(s) / 3).facet == face(s / 3).facet) continue;
        std::vector<Index>& polygon = polygon_of(face(s / 3).facet);
        if (polygon.empty()) polygon = facet_polygon(s);
    }
    for (const std::vector<Index>& polygon : polygons) {
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            hull.faces.push_back({polygon[0], polygon[i], polygon[i + 1]});
    }
    std::ranges::sort(hull.faces);

    const auto rest = [&](Index i, Index facet) {
        const std::vector<Index>& polygon = polygon_of(facet);
        const std::size_t k = fan_triangle(points_, polygon, point(i));
        const Face triangle{polygon[0], polygon[k + 1], polygon[k + 2]};
        const auto found = std::ranges::lower_bound(hull.faces, triangle);
        hull.face_of[static_cast<std::size_t>(i)] = static_cast<Index>(found - hull.faces.begin());
        hull.positions[static_cast<std::size_t>(i)] = HullPosition::boundary;
    };
    for (Index f = 0; f < count; ++f) {
        if (!alive(f)) continue;
        for (const Index v : std::array(face(f).corners)) {
            if (is_corner(v)) {
                hull.positions[static_cast<std::size_t>(v)] = HullPosition::extreme;
            } else if (hull.face_of[static_cast<std::size_t>(v)] == none) {
                rest(v, face(f).facet);
            }
        }
        for (Index i = face(f).on.head; i != none; i = next_[static_cast<std::size_t>(i)])
            rest(i, face(f).facet);
    }
    return hull;
}

/// Splits the faces of a hull at its boundary points. Points not yet put in are listed with a face
/// they lie on.
class FacetSplitter {
public:
    FacetSplitter(Points points, const ConvexHull& hull)
        : points_(points),
          mesh_(hull.faces, static_cast<Index>(points.size())),
          face_of_(hull.face_of),
          next_(points.size(), none),
          waiting_(hull.faces.size()) {}

    std::vector<Face> run() {
        std::vector<Index> order;
        for (std::size_t i = 0; i < face_of_.size(); ++i) {
            if (face_of_[i] != none) order.push_back(static_cast<Index>(i));
        }
        kernel::RandomStream(0).shuffle(std::span(order));
        for (const Index i : order)
            put_down(i, face_of_[static_cast<std::size_t>(i)]);
        for (const Index i : order)
            insert(i);
        return mesh_.faces();
    }

private:
    [[nodiscard]] const Point& point(Index i) const { return points_[static_cast<std::size_t>(i)]; }

    void put_down(Index i, Index f) {
        face_of_[static_cast<std::size_t>(i)] = f;
        waiting_[static_cast<std::size_t>(f)].push(next_, i);
    }

    [[nodiscard]] bool contains(Index f, Index i) const {
        const auto [a, b, c] = mesh_.corners(f);
        return orientation(point(a), point(b), point(c), point(i)) == Sign::zero &&
               triangle_contains(point(a), point(b), point(c), point(i));
    }

    void insert(Index v) {
        const Index f = face_of_[static_cast<std::size_t>(v)];
        const Index side = side_under(f, v);
        std::vector<Index> changed{f};
        if (side != none) changed.push_back(mesh_.twin(side) / 3);
        std::vector<Index> loose;
        for (const Index g : changed) {
            for (Index i = waiting_[static_cast<std::size_t>(g)].head; i != none;
                 i = next_[static_cast<std::size_t>(i)]) {
                if (i != v) loose.push_back(i);
            }
        }
        const auto first_new = static_cast<Index>(mesh_.faces().size());
        mesh_.split_face(f, v);
        if (side != none) mesh_.flip(side == 3 * f ? side : 3 * (first_new + side - 3 * f - 1));
        changed.push_back(first_new);
        changed.push_back(first_new + 1);
        waiting_.resize(mesh_.faces().size());
        for (const Index g : changed)
            waiting_[static_cast<std::size_t>(g)].head = none;
        for (const Index i : loose)
            put_down(i, *std::ranges::find_if(changed, [&](Index g) { return contains(g, i); }));
    }

    /// The side of a face that a point of it lies on; none where it is inside.
    [[nodiscard]] Index side_under(Index f, Index v) const {
        for (Index s = 3 * f; s < 3 * f + 3; ++s) {
            const Index a = mesh_.corner(s);
            const Index b = mesh_.corner(FaceMesh::after(s));
            if (are_collinear(point(a), point(b), point(v))) return s;
        }
        return none;
    }

    Points points_;
    FaceMesh mesh_;
    std::vector<Index> face_of_;
    std::vector<Index> next_;
    std::vector<PointList> waiting_;
};

}  // namespace

Outcome<ConvexHull> convex_hull(Points points) {
    if (const auto bad = point_not_finite(points))
        return DataRefusal{DataFault::not_finite, {*bad, -1}};
    if (points.size() < 4) return DataRefusal{DataFault::too_few_points};
    std::vector<std::array<Index, 2>> coincident;
    const std::vector<Index> labels = distinct_in_space(points, coincident);
    HullBuilder builder(points);
    const DataFault fault = builder.build(labels);
    if (fault != DataFault::none) return DataRefusal{fault};
    ConvexHull hull = builder.result();
    for (const auto& [label, first] : coincident) {
        const auto copy = static_cast<std::size_t>(label);
        hull.positions[copy] = hull.positions[static_cast<std::size_t>(first)];
        hull.face_of[copy] = hull.face_of[static_cast<std::size_t>(first)];
    }
    hull.coincident = std::move(coincident);
    return hull;
}

Outcome<Surface> convex_surface(std::vector<Point> points) {
    const Outcome<ConvexHull> hull = convex_hull(points);
    if (!hull) return hull.refusal();
    const ConvexHull& found = hull.value();
    if (!found.coincident.empty()) {
        const auto [label, first] = found.coincident.front();
        return DataRefusal{DataFault::coincident_points, {first, label}};
    }
    const auto inside = std::ranges::find(found.positions, HullPosition::inside);
    if (inside != found.positions.end()) {
        return DataRefusal{DataFault::interior_point,
                           {static_cast<Index>(inside - found.positions.begin()), -1}};
    }
    const std::vector<Face> faces = FacetSplitter(points, found).run();
    return surface_of_faces(faces, std::move(points));
}

}  // namespace tightflip::geometry
