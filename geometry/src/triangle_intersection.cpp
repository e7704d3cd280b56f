#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/triangle_intersection.hpp>

#include <algorithm>

namespace tightflip::geometry {
namespace {

/// Up to three points of a triangle and their hull.
class Simplex {
public:
    Simplex() = default;
    explicit Simplex(const Triangle& triangle)
        : corners_{&triangle[0], &triangle[1], &triangle[2]}, size_(3) {}

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    /// Cyclic: `i` may go once more round.
    [[nodiscard]] const Point& corner(std::size_t i) const {
        return *corners_.at(i < size_ ? i : i - size_);
    }
    [[nodiscard]] bool has_corner(const Point& x) const {
        for (std::size_t i = 0; i < size_; ++i) {
            if (corner(i) == x) return true;
        }
        return false;
    }
    /// From corner i to the next; a segment has one side, a point has none.
    [[nodiscard]] std::size_t side_count() const noexcept { return size_ < 3 ? size_ / 2 : 3; }

    void add(const Point& x) {
        if (!has_corner(x)) corners_.at(size_++) = &x;
    }

private:
    std::array<const Point*, 3> corners_{};
    std::size_t size_ = 0;
};

using Sides = std::array<Sign, 3>;

/// Whether x, on the line of a and b, lies between them.
bool lies_between(const Point& a, const Point& b, const Point& x) {
    return (a.cwiseMin(b).array() <= x.array()).all() && (x.array() <= a.cwiseMax(b).array()).all();
}

/// Of a simplex with a corner on one side of something and none on the other, leaves the face that
/// lies on neither; of another simplex, everything.
void keep_supported_face(Simplex& simplex, const Sides& sides) {
    Simplex face;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
        if (sides.at(i) == Sign::zero) face.add(simplex.corner(i));
    }
    simplex = face;
}

bool has(const Sides& sides, std::size_t count, Sign sign) {
    return std::find(sides.begin(), sides.begin() + count, sign) != sides.begin() + count;
}

/// Three corners on a line are the hull of the two of them between which the third lies.
Simplex hull_on_line(const Simplex& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Point& a = corners.corner(i);
        const Point& b = corners.corner(i + 1);
        if (!lies_between(a, b, corners.corner(i + 2))) continue;
        Simplex hull;
        hull.add(a);
        hull.add(b);
        return hull;
    }
    return corners;
}

/// The sides of the plane of `f` on which the corners of `g` lie.
Sides sides_of_plane(const Simplex& f, const Simplex& g) {
    Sides sides{};
    for (std::size_t i = 0; i < g.size(); ++i) {
        if (f.has_corner(g.corner(i))) continue;  // where the filter of the predicate would fail
        sides.at(i) = orientation(f.corner(0), f.corner(1), f.corner(2), g.corner(i));
    }
    return sides;
}

/// For a triangle `f` and `g` in one plane: the face of `g` that alone can meet `f`, where a side
/// of `f` has `g` beyond it.
void narrow_in_plane(const Simplex& f, Simplex& g) {
    for (std::size_t side = 0; side < 3; ++side) {
        const Point& a = f.corner(side);
        const Point& b = f.corner(side + 1);
        Sides sides{};
        for (std::size_t i = 0; i < g.size(); ++i) {
            if (g.corner(i) == a || g.corner(i) == b) continue;
            sides.at(i) = coplanar_side(a, b, f.corner(side + 2), g.corner(i));
            if (sides.at(i) == Sign::positive) break;
        }
        if (has(sides, g.size(), Sign::positive)) continue;
        if (has(sides, g.size(), Sign::negative)) keep_supported_face(g, sides);
    }
}

/// Narrows `g` to a face of it that holds all that it has in common with `f`, where the plane or a
/// side of `f` show one; and a triangle `f` on a line to the segment or point it is.
void narrow(Simplex& f, Simplex& g) {
    if (f.size() < 3) return;
    const Sides sides = sides_of_plane(f, g);
    const bool is_above = has(sides, g.size(), Sign::positive);
    const bool is_below = has(sides, g.size(), Sign::negative);
    if (is_above != is_below) {
        keep_supported_face(g, sides);
    } else if (!is_above) {
        if (are_collinear(f.corner(0), f.corner(1), f.corner(2))) {
            f = hull_on_line(f);
        } else {
            narrow_in_plane(f, g);
        }
    }
}

bool contains(const Simplex& simplex, const Point& x) {
    if (simplex.has_corner(x)) return true;
    if (simplex.size() < 2) return false;
    const Point& a = simplex.corner(0);
    const Point& b = simplex.corner(1);
    if (simplex.size() == 2) return lies_between(a, b, x) && are_collinear(a, b, x);
    const Point& c = simplex.corner(2);
    return orientation(a, b, c, x) == Sign::zero && coplanar_side(a, b, c, x) != Sign::negative &&
           coplanar_side(b, c, a, x) != Sign::negative &&
           coplanar_side(c, a, b, x) != Sign::negative;
}

/// Whether the segment pq, without its ends, meets the interior of a triangle in one point.
bool crosses_interior(const Point& p, const Point& q, const Simplex& triangle) {
    const Point& a = triangle.corner(0);
    const Point& b = triangle.corner(1);
    const Point& c = triangle.corner(2);
    if (triangle.has_corner(p) || triangle.has_corner(q)) return false;
    const Sign side = orientation(a, b, c, p);
    if (side == Sign::zero || orientation(a, b, c, q) != -side) return false;
    // Seen from p above the plane, q lies beyond the interior where all sides turn the same way.
    return orientation(a, b, p, q) == -side && orientation(b, c, p, q) == -side &&
           orientation(c, a, p, q) == -side;
}

bool lie_on_other_sides(const Point& a, const Point& b, const Point& p, const Point& q) {
    return !are_collinear(a, b, p) && coplanar_side(a, b, p, q) == Sign::negative;
}

/// Whether two segments, both without their ends, meet in one point and no more.
bool segments_cross(const Point& a, const Point& b, const Point& p, const Point& q) {
    if (a == p || a == q || b == p || b == q) return false;
    return orientation(a, b, p, q) == Sign::zero && lie_on_other_sides(a, b, p, q) &&
           lie_on_other_sides(p, q, a, b);
}

/// Shows the extreme points of what two simplices have in common until `is_enough` says so: a
/// corner by its address (equal corners of both come twice), a crossing, which is no corner and
/// comes once, as a null pointer. Returns whether it was enough.
template <class IsEnough>
bool show_extreme_points(const Simplex& f, const Simplex& g, const IsEnough& is_enough) {
    for (const auto& [from, in] : {std::pair{&f, &g}, std::pair{&g, &f}}) {
        for (std::size_t i = 0; i < from->size(); ++i) {
            if (contains(*in, from->corner(i)) && is_enough(&from->corner(i))) return true;
        }
        if (in->size() < 3) continue;
        for (std::size_t i = 0; i < from->side_count(); ++i) {
            if (crosses_interior(from->corner(i), from->corner(i + 1), *in) && is_enough(nullptr)) {
                return true;
            }
        }
    }
    for (std::size_t i = 0; i < f.side_count(); ++i) {
        for (std::size_t j = 0; j < g.side_count(); ++j) {
            if (segments_cross(f.corner(i), f.corner(i + 1), g.corner(j), g.corner(j + 1)) &&
                is_enough(nullptr)) {
                return true;
            }
        }
    }
    return false;
}

/// Whether the hull of no more than the shared points is left.
bool is_left_with(const Simplex& simplex, std::span<const Point> shared) {
    for (std::size_t i = 0; i < simplex.size(); ++i) {
        if (std::ranges::find(shared, simplex.corner(i)) == shared.end()) return false;
    }
    return true;
}

}  // namespace

Contact contact(const Triangle& f, const Triangle& g) {
    Simplex left(f);
    Simplex right(g);
    narrow(left, right);
    narrow(right, left);
    // Extreme points that differ: one is a point, two a segment, three an area.
    Simplex corners;
    std::size_t crossings = 0;
    const auto count = [&] { return corners.size() + crossings; };
    show_extreme_points(left, right, [&](const Point* corner) {
        if (corner != nullptr) {
            corners.add(*corner);
        } else {
            ++crossings;
        }
        return count() == 3;
    });
    return static_cast<Contact>(count());
}

bool triangles_meet(const Triangle& f, const Triangle& g) {
    return triangles_meet_beyond(f, g, {});
}

bool triangles_meet_beyond(const Triangle& f, const Triangle& g, std::span<const Point> shared) {
    Simplex left(f);
    Simplex right(g);
    narrow(left, right);
    if (is_left_with(right, shared)) return false;
    narrow(right, left);
    if (is_left_with(left, shared)) return false;
    // Two segments that cross have that point alone in common, so it is the shared one if there is
    // any: a corner of both triangles, which both lie on lines and have it in the middle.
    const bool may_cross_in_shared = !shared.empty() && left.size() == 2 && right.size() == 2;
    return show_extreme_points(left, right, [&](const Point* corner) {
        return corner == nullptr ? !may_cross_in_shared
                                 : std::ranges::find(shared, *corner) == shared.end();
    });
}

bool triangle_contains(const Triangle& triangle, const Point& x) {
    Simplex simplex(triangle);
    if (are_collinear(triangle[0], triangle[1], triangle[2])) simplex = hull_on_line(simplex);
    return contains(simplex, x);
}

}  // namespace tightflip::geometry
