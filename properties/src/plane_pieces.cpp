#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/properties/plane_pieces.hpp>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace tightflip::properties {
namespace {

using geometry::are_collinear;
using geometry::coplanar_side;
using geometry::orientation;
using geometry::Point;
using geometry::Sign;
using geometry::SurfaceView;
using kernel::Edge;
using kernel::Index;
using kernel::Vertex;

/// For a point on the line ab: whether it is on the side of b, the other, or at a.
Sign side_on_line(const Point& a, const Point& b, const Point& x) {
    for (int i = 0; i < 3; ++i) {
        if (a[i] == b[i]) continue;
        if (x[i] == a[i]) return Sign::zero;
        return (x[i] > a[i]) == (b[i] > a[i]) ? Sign::positive : Sign::negative;
    }
    return Sign::zero;
}

/// Where each vertex stands with respect to the flag of the plane abc, the line ab and the point a:
/// its side in the first of the three that it does not lie on.
class Flag {
public:
    Flag(const SurfaceView& surface, const std::array<Vertex, 3>& corners) {
        const Point& a = surface.point(corners[0]);
        const Point& b = surface.point(corners[1]);
        const Point& c = surface.point(corners[2]);
        sides_.reserve(surface.points.size());
        for (const Point& x : surface.points)
            sides_.push_back(side(a, b, c, x));
        in_plane_ = std::ranges::count_if(sides_, [](const Side& side) { return side.level > 0; });
    }

    /// How many points lie in the plane.
    [[nodiscard]] std::ptrdiff_t in_plane() const noexcept { return in_plane_; }

    /// The vertices above the plane once it was tilted about ab so that c is above or not, then
    /// about a so that b is, and moved so that a is.
    void above(const std::array<bool, 3>& is_above, std::vector<bool>& result) const {
        // By the level of a side: what happens to the points on the positive side.
        const std::array<bool, 4> positive{true, is_above[2], is_above[1], is_above[0]};
        result.clear();
        for (const Side& side : sides_)
            result.push_back(positive.at(side.level) == side.is_positive);
    }

private:
    struct Side {
        std::size_t level;  ///< 0 off the plane, 1 off the line, 2 off the point, 3 at it
        bool is_positive;
    };

    static Side side(const Point& a, const Point& b, const Point& c, const Point& x) {
        if (const Sign s = orientation(a, b, c, x); s != Sign::zero) {
            return {0, s == Sign::positive};
        }
        if (const Sign s = coplanar_side(a, b, c, x); s != Sign::zero) {
            return {1, s == Sign::positive};
        }
        const Sign s = side_on_line(a, b, x);
        return s == Sign::zero ? Side{3, true} : Side{2, s == Sign::positive};
    }

    std::vector<Side> sides_;
    std::ptrdiff_t in_plane_ = 0;
};

/// Counts the components above and below a plane.
class PieceCounter {
public:
    explicit PieceCounter(const SurfaceView& surface) : parent_(surface.points.size()) {
        for (Index e = 0; e < surface.edge_count(); ++e) {
            const kernel::Halfedge h = kernel::halfedge_of(Edge{e});
            edges_.emplace_back(index(at(surface.table, h).origin),
                                index(at(surface.table, twin(h)).origin));
        }
        std::ranges::sort(edges_);
        edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    }

    [[nodiscard]] std::pair<Index, Index> count(const std::vector<bool>& above) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
        const auto high = static_cast<Index>(std::ranges::count(above, true));
        std::pair<Index, Index> pieces{high, static_cast<Index>(above.size()) - high};
        for (const auto& [a, b] : edges_) {
            if (above[a] != above[b]) continue;
            const std::size_t first = root(a);
            const std::size_t second = root(b);
            if (first == second) continue;
            parent_[first] = second;
            --(above[a] ? pieces.first : pieces.second);
        }
        return pieces;
    }

private:
    static std::size_t index(Vertex v) { return static_cast<std::size_t>(v.id); }

    std::size_t root(std::size_t v) {
        while (parent_[v] != v)
            v = parent_[v] = parent_[parent_[v]];
        return v;
    }

    std::vector<std::pair<std::size_t, std::size_t>> edges_;
    std::vector<std::size_t> parent_;
};

class PlaneSearch {
public:
    explicit PlaneSearch(const SurfaceView& surface) : surface_(surface), counter_(surface) {}

    [[nodiscard]] const PlaneCut& best() const noexcept { return best_; }

    void look_at(const std::array<Vertex, 3>& corners) {
        const auto& [a, b, c] = corners;
        if (a == b || b == c || a == c) return;
        if (are_collinear(surface_.point(a), surface_.point(b), surface_.point(c))) return;
        const Flag flag(surface_, corners);
        // With no other point in the plane, its tilts about the other sides do nothing else.
        if (flag.in_plane() == 3 && !(a < b && b < c)) return;
        for (unsigned tilts = 0; tilts < 8; ++tilts) {
            const std::array<bool, 3> is_above{(tilts & 1U) != 0, (tilts & 2U) != 0,
                                               (tilts & 4U) != 0};
            flag.above(is_above, above_);
            const auto [high, low] = counter_.count(above_);
            if (high + low > best_.pieces()) best_ = {high, low, corners, is_above};
        }
    }

private:
    SurfaceView surface_;
    PieceCounter counter_;
    std::vector<bool> above_;
    PlaneCut best_;
};

}  // namespace

PlaneCut most_pieces(const SurfaceView& surface) {
    PlaneSearch search(surface);
    const auto count = static_cast<Index>(surface.points.size());
    for (Index a = 0; a < count; ++a) {
        for (Index b = 0; b < count; ++b) {
            for (Index c = 0; c < count; ++c)
                search.look_at({Vertex{a}, Vertex{b}, Vertex{c}});
        }
    }
    return search.best();
}

}  // namespace tightflip::properties
