#include "hidden_lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace tightflip::geometry {
namespace {

/// Coordinates are about one. A face this much nearer hides.
constexpr double nearer = 1e-6;
constexpr double rounding = 1e-9;
/// A triangle seen from the side, by the ratio of its area to its longest side's square.
constexpr double thin = 1e-6;
constexpr int widest_grid = 512;
/// The triangles in all cells together, by their number.
constexpr std::size_t most_copies = 8;

/// Keeps of an interval where a linear function with these values at 0 and 1 is at least 0.
void clip(Interval& interval, double at_0, double at_1) {
    if (at_0 < 0 && at_1 < 0) {
        interval.end = -1;
    } else if (at_0 < 0) {
        interval.begin = std::max(interval.begin, at_0 / (at_0 - at_1));
    } else if (at_1 < 0) {
        interval.end = std::min(interval.end, at_0 / (at_0 - at_1));
    }
}

}  // namespace

HidingFaces::HidingFaces(const std::vector<Piece>& triangles) {
    for (const Piece& piece : triangles) {
        const Point& a = piece.corners[0];
        const Point& b = piece.corners[1];
        const Point& c = piece.corners[2];
        const double area = seen_area(a, b, c);
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        if (!(std::abs(area) > thin * longest)) continue;
        triangles_.push_back({area > 0 ? std::array{a, b, c} : std::array{a, c, b},
                              a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), piece.face});
        for (const Point& corner : piece.corners) {
            reach_ = std::max(reach_, corner.head<2>().cwiseAbs().maxCoeff());
        }
    }
    std::ranges::stable_sort(triangles_, std::greater<>(),
                             [](const Triangle& triangle) { return triangle.greatest.z(); });
    const double root = std::sqrt(static_cast<double>(triangles_.size()));
    width_ = std::clamp(static_cast<int>(root), 1, widest_grid);
    while (width_ > 1 && all_cells() > most_copies * triangles_.size())
        width_ /= 2;

    const auto square = static_cast<std::size_t>(width_) * static_cast<std::size_t>(width_);
    first_.assign(square + 1, 0);
    for (const Triangle& triangle : triangles_) {
        for_each_in(cells(triangle.least, triangle.greatest),
                    [&](std::size_t cell) { ++first_[cell + 1]; });
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    in_cell_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
        for_each_in(cells(triangles_[i].least, triangles_[i].greatest),
                    [&](std::size_t cell) { in_cell_[next[cell]++] = i; });
    }
}

int HidingFaces::cell(double coordinate) const {
    if (reach_ == 0) return 0;
    const double place = (coordinate / reach_ + 1) / 2 * width_;
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(width_ - 1)));
}

HidingFaces::Cells HidingFaces::cells(const Point& least, const Point& greatest) const {
    return {cell(least.x()), cell(greatest.x()), cell(least.y()), cell(greatest.y())};
}

std::size_t HidingFaces::all_cells() const {
    std::size_t sum = 0;
    for (const Triangle& triangle : triangles_)
        sum += cells(triangle.least, triangle.greatest).count();
    return sum;
}

template <class Visit>
void HidingFaces::for_each_in(const Cells& cells, const Visit& visit) const {
    for (int y = cells.bottom; y <= cells.top; ++y) {
        for (int x = cells.left; x <= cells.right; ++x) {
            visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(x));
        }
    }
}

/// Where the segment runs within the outline and is farther than the triangle's plane; all of that
/// is linear in the parameter.
Interval HidingFaces::Triangle::hidden(const Point& a, const Point& b) const {
    Interval interval;
    const auto& [p, q, r] = corners;
    const double area = seen_area(p, q, r);
    std::array<double, 2> in_front{};
    for (const auto& [from, to, far] : {std::tie(p, q, r), std::tie(q, r, p), std::tie(r, p, q)}) {
        const double at_a = seen_area(from, to, a) / area;  // the weight of the third corner
        const double at_b = seen_area(from, to, b) / area;
        clip(interval, at_a + rounding, at_b + rounding);
        in_front[0] += at_a * far.z();
        in_front[1] += at_b * far.z();
    }
    clip(interval, in_front[0] - a.z() - nearer, in_front[1] - b.z() - nearer);
    return interval;
}

std::vector<Interval> HidingFaces::hidden(const Point& a, const Point& b,
                                          std::array<Index, 2> own_faces) {
    std::vector<Interval> parts;
    bool is_all = false;
    ++questions_;
    const Point least = a.cwiseMin(b) - Point::Constant(rounding);
    const Point greatest = a.cwiseMax(b) + Point::Constant(rounding);
    for_each_in(cells(least, greatest), [&](std::size_t cell) {
        // From the nearest on, so that what lies deep inside is soon known to be hidden.
        for (std::uint32_t i = first_[cell]; i < first_[cell + 1] && !is_all; ++i) {
            Triangle& triangle = triangles_[in_cell_[i]];
            if (std::exchange(triangle.last_asked, questions_) == questions_) continue;
            if (triangle.greatest.z() < least.z()) break;
            if ((triangle.greatest.head<2>().array() < least.head<2>().array()).any()) continue;
            if ((triangle.least.head<2>().array() > greatest.head<2>().array()).any()) continue;
            if (triangle.face == own_faces[0] || triangle.face == own_faces[1]) continue;
            const Interval part = triangle.hidden(a, b);
            if (part.begin <= part.end) parts.push_back(part);
            is_all = part.begin <= 0 && part.end >= 1;
        }
    });
    if (is_all) return {{0, 1}};
    std::ranges::sort(parts, {}, &Interval::begin);
    return parts;
}

std::vector<Interval> HidingFaces::visible(const Point& a, const Point& b,
                                           std::array<Index, 2> own_faces) {
    std::vector<Interval> parts;
    double from = 0;
    constexpr double least = 1e-6;
    for (const Interval& part : hidden(a, b, own_faces)) {
        if (part.begin > from + least) parts.push_back({from, part.begin});
        from = std::max(from, part.end);
    }
    if (from < 1 - least) parts.push_back({from, 1});
    return parts;
}

bool HidingFaces::is_visible(const Point& point, Index own_face) {
    return hidden(point, point, {own_face, own_face}).empty();
}

}  // namespace tightflip::geometry
