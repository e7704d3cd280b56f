#include "painter_order.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

using Pieces = std::vector<Piece>;

/// Coordinates are about one; less than this is rounding.
constexpr double tolerance = 1e-7;
/// So many pieces are first parted by planes along the axes, so that no list gets long.
constexpr std::size_t many = 64;
constexpr std::size_t candidates = 8;

struct Plane {
    Point normal;  // of length one
    double offset = 0;

    [[nodiscard]] double height(const Point& p) const { return normal.dot(p) - offset; }
};

Point area_vector(const Piece& piece) {
    Point sum = Point::Zero();
    for (std::size_t i = 2; i < piece.corners.size(); ++i) {
        sum += (piece.corners[i - 1] - piece.corners[0]).cross(piece.corners[i] - piece.corners[0]);
    }
    return sum;
}

bool can_be_seen(const Piece& piece) {
    const Point area = area_vector(piece);
    constexpr double least = 1e-12;
    return std::abs(area.z()) > least && std::abs(area.z()) > tolerance * area.norm();
}

Plane plane_of(const Piece& piece) {
    const Point normal = area_vector(piece).normalized();
    return {normal, normal.dot(piece.corners[0])};
}

double depth(const Piece& piece) {
    double sum = 0;
    for (const Point& corner : piece.corners)
        sum += corner.z();
    return sum / static_cast<double>(piece.corners.size());
}

/// Where a piece lies with regard to a plane.
struct Sides {
    bool is_below = false;
    bool is_above = false;
    [[nodiscard]] bool is_cut() const { return is_below && is_above; }
};

Sides sides_of(const Plane& plane, const Piece& piece) {
    Sides sides;
    for (const Point& corner : piece.corners) {
        const double height = plane.height(corner);
        sides.is_below |= height < -tolerance;
        sides.is_above |= height > tolerance;
    }
    return sides;
}

/// The part of a piece on one side of a plane.
Piece part_of(const Plane& plane, const Piece& piece, double side) {
    Piece part{{}, piece.face, piece.is_front};
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
        const Point& a = piece.corners[i];
        const Point& b = piece.corners[(i + 1) % piece.corners.size()];
        const double height_a = side * plane.height(a);
        const double height_b = side * plane.height(b);
        if (height_a >= 0) part.corners.push_back(a);
        if ((height_a > 0 && height_b < 0) || (height_a < 0 && height_b > 0)) {
            part.corners.push_back(a + height_a / (height_a - height_b) * (b - a));
        }
    }
    return part;
}

struct Parts {
    Pieces below;
    Pieces on;
    Pieces above;
};

Parts partition(const Plane& plane, Pieces pieces) {
    Parts parts;
    for (Piece& piece : pieces) {
        const Sides sides = sides_of(plane, piece);
        if (sides.is_cut()) {
            for (auto& [list, side] : {std::pair{&parts.below, -1.0}, {&parts.above, 1.0}}) {
                Piece part = part_of(plane, piece, side);
                if (part.corners.size() > 2 && can_be_seen(part)) list->push_back(std::move(part));
            }
        } else {
            Pieces& list = sides.is_below ? parts.below : sides.is_above ? parts.above : parts.on;
            list.push_back(std::move(piece));
        }
    }
    return parts;
}

/// Across the longest extent, half of the pieces on either side.
Plane middle_plane(const Pieces& pieces) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point least = Point::Constant(infinity);
    Point greatest = -least;
    for (const Piece& piece : pieces) {
        for (const Point& corner : piece.corners) {
            least = least.cwiseMin(corner);
            greatest = greatest.cwiseMax(corner);
        }
    }
    Eigen::Index axis = 0;
    (greatest - least).maxCoeff(&axis);
    std::vector<double> places;
    places.reserve(pieces.size());
    for (const Piece& piece : pieces)
        places.push_back(piece.corners[0][axis]);
    const auto middle = std::next(places.begin(), std::ssize(places) / 2);
    std::ranges::nth_element(places, middle);
    return {Point::Unit(axis), *middle};
}

/// How far a plane is from parting pieces evenly without cuts.
std::size_t badness(const Plane& plane, const Pieces& pieces) {
    std::size_t below = 0;
    std::size_t above = 0;
    std::size_t cut = 0;
    for (const Piece& piece : pieces) {
        const Sides sides = sides_of(plane, piece);
        below += sides.is_below ? 1U : 0U;
        above += sides.is_above ? 1U : 0U;
        cut += sides.is_cut() ? 1U : 0U;
    }
    constexpr std::size_t price_of_a_cut = 8;
    return price_of_a_cut * cut + std::max(below, above);
}

/// Of some pieces the one whose plane parts all best.
std::size_t best_divider(const Pieces& pieces) {
    const std::size_t step = std::max<std::size_t>(1, pieces.size() / candidates);
    std::size_t best = 0;
    std::size_t least = badness(plane_of(pieces.front()), pieces);
    for (std::size_t i = step; i < pieces.size(); i += step) {
        const std::size_t found = badness(plane_of(pieces[i]), pieces);
        if (found < least) {
            least = found;
            best = i;
        }
    }
    return best;
}

/// Paints lists, the last one first, until none is left.
class Painter {
public:
    Painter(Pieces pieces, std::size_t most) : most_(most) { put_off(std::move(pieces), false); }

    Pieces paint() {
        while (!lists_.empty()) {
            List list = std::move(lists_.back());
            lists_.pop_back();
            Pieces& pieces = list.pieces;
            waiting_ -= pieces.size();
            if (!list.is_in_order && pieces.size() > 1) {
                // Dividing may cut every piece.
                if (painted_.size() + waiting_ + 2 * pieces.size() <= most_) {
                    divide(std::move(pieces));
                    continue;
                }
                std::ranges::stable_sort(pieces, {}, depth);
            }
            std::ranges::move(pieces, std::back_inserter(painted_));
        }
        return std::move(painted_);
    }

private:
    struct List {
        Pieces pieces;
        bool is_in_order = false;
    };

    void divide(Pieces pieces) {
        if (pieces.size() > many) {
            const Plane plane = middle_plane(pieces);
            // Not where the pieces are large and lie all over each other.
            if (badness(plane, pieces) < pieces.size()) {
                put_off(plane, partition(plane, std::move(pieces)));
                return;
            }
        }
        // The face of the divider leaves the list, whatever the roundings, which gets shorter so.
        const Piece& divider = pieces[best_divider(pieces)];
        const Plane plane = plane_of(divider);
        const auto rest = std::stable_partition(
            pieces.begin(), pieces.end(),
            [face = divider.face](const Piece& piece) { return piece.face == face; });
        Pieces others(std::make_move_iterator(rest), std::make_move_iterator(pieces.end()));
        pieces.erase(rest, pieces.end());
        Parts parts = partition(plane, std::move(others));
        std::ranges::move(pieces, std::back_inserter(parts.on));
        put_off(plane, std::move(parts));
    }
    void put_off(const Plane& plane, Parts parts) {
        std::ranges::sort(parts.on, {},
                          [](const Piece& p) { return std::pair(p.is_front, p.face); });
        const bool above_is_near = plane.normal.z() > 0;
        put_off(std::move(above_is_near ? parts.above : parts.below), false);
        put_off(std::move(parts.on), true);
        put_off(std::move(above_is_near ? parts.below : parts.above), false);
    }
    void put_off(Pieces pieces, bool is_in_order) {
        if (pieces.empty()) return;
        waiting_ += pieces.size();
        lists_.push_back({std::move(pieces), is_in_order});
    }

    std::size_t most_;
    std::size_t waiting_ = 0;
    std::vector<List> lists_;
    Pieces painted_;
};

}  // namespace

std::vector<Piece> painter_order(std::vector<Piece> pieces, std::size_t most_pieces) {
    std::erase_if(pieces, [](const Piece& piece) { return !can_be_seen(piece); });
    return Painter(std::move(pieces), most_pieces).paint();
}

}  // namespace tightflip::geometry
