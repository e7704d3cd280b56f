#include "weld.hpp"

#include "merge_equal_points.hpp"
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace tightflip::geometry {
namespace {

/// The corner of a cell of the grid, in units of its width; whole numbers of any size.
using Cell = std::array<double, 3>;

struct CellHash {
    std::size_t operator()(const Cell& cell) const noexcept {
        std::uint64_t hash = 0;
        for (const double c : cell)
            hash = kernel::mix(hash + std::bit_cast<std::uint64_t>(c + 0.0));
        return hash;
    }
};

/// Points by the cells of a grid. Cells are numbered in floating point: where numbers are so large
/// that neighbouring cells share one, the search finds more candidates and misses none, because
/// rounding keeps order.
class Grid {
public:
    Grid(const std::vector<Eigen::Vector3d>& points, double distance)
        : points_(points), distance_(distance) {
        double largest = 0;
        for (const auto& p : points)
            largest = std::max(largest, p.cwiseAbs().maxCoeff());
        width_ = std::max(distance, largest * 0x1p-1020);  // so that no cell's number overflows
    }

    void insert(Index v) { cells_[cell_of(point(v), 0)].push_back(v); }

    /// The first point that was inserted and is near enough; -1 where there is none.
    [[nodiscard]] Index first_near(Index v) const {
        const Cell low = cell_of(point(v), -distance_);
        const Cell high = cell_of(point(v), distance_);
        Index first = -1;
        for (const double x : numbers(low[0], high[0])) {
            for (const double y : numbers(low[1], high[1])) {
                for (const double z : numbers(low[2], high[2]))
                    search({x, y, z}, v, first);
            }
        }
        return first;
    }

private:
    [[nodiscard]] const Eigen::Vector3d& point(Index v) const {
        return points_[static_cast<std::size_t>(v)];
    }
    [[nodiscard]] Cell cell_of(const Eigen::Vector3d& p, double offset) const {
        const auto number = [&](double x) {
            constexpr double most = std::numeric_limits<double>::max();
            return std::floor(std::clamp(x + offset, -most, most) / width_);
        };
        return {number(p[0]), number(p[1]), number(p[2])};
    }
    /// The numbers of all cells of a row from one to another; there are but a few.
    static std::vector<double> numbers(double low, double high) {
        std::vector<double> found;
        double cell = low;
        while (cell <= high) {
            found.push_back(cell);
            cell =
                std::max(cell + 1, std::nextafter(cell, std::numeric_limits<double>::infinity()));
        }
        return found;
    }
    void search(const Cell& cell, Index v, Index& first) const {
        const auto found = cells_.find(cell);
        if (found == cells_.end()) return;
        for (const Index candidate : found->second) {  // in ascending order
            if (first >= 0 && candidate >= first) return;
            const Eigen::Vector3d d = point(candidate) - point(v);
            if (std::hypot(d[0], d[1], d[2]) <= distance_) first = candidate;
        }
    }

    const std::vector<Eigen::Vector3d>& points_;
    double distance_;
    double width_ = 0;
    std::unordered_map<Cell, std::vector<Index>, CellHash> cells_;
};

}  // namespace

void weld(TriangleSoup& soup, double distance) {
    merge_equal_points(soup);
    if (distance == 0) return;
    Grid grid(soup.points, distance);
    std::vector<Index> merged(soup.points.size());  // the new number of each vertex
    std::vector<Index> kept;
    for (Index v = 0; v < soup.vertex_count(); ++v) {
        const Index near = grid.first_near(v);
        if (near >= 0) {
            merged[static_cast<std::size_t>(v)] = merged[static_cast<std::size_t>(near)];
            continue;
        }
        grid.insert(v);
        merged[static_cast<std::size_t>(v)] = static_cast<Index>(kept.size());
        kept.push_back(v);
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
        soup.points[i] = soup.points[static_cast<std::size_t>(kept[i])];
        soup.point_positions[i] = soup.point_positions[static_cast<std::size_t>(kept[i])];
    }
    soup.points.resize(kept.size());
    soup.point_positions.resize(kept.size());
    for (auto& triangle : soup.triangles) {
        for (Index& corner : triangle)
            corner = merged[static_cast<std::size_t>(corner)];
    }
}

}  // namespace tightflip::geometry
