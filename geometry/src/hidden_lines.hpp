/// \file
/// Which parts of lines are behind faces.
#pragma once

#include "projection.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tightflip::geometry {

/// A part of a segment, from one parameter in 0 .. 1 to another.
struct Interval {
    double begin = 0;
    double end = 1;
};

/// Triangles that hide what is behind them, in a grid over the picture so that few are asked. A
/// triangle hides also what is behind its outline, and nothing that is as near as itself.
class HidingFaces {
public:
    explicit HidingFaces(const std::vector<Piece>& triangles);

    /// The parts of a segment that no triangle hides, in order. Those of the two named faces do not
    /// count; a segment that belongs to them names them, so that roundings do not matter.
    [[nodiscard]] std::vector<Interval> visible(const Point& a, const Point& b,
                                                std::array<Index, 2> own_faces);
    [[nodiscard]] bool is_visible(const Point& point, Index own_face);

private:
    struct Triangle {
        std::array<Point, 3> corners;  // counter-clockwise as seen
        Point least;
        Point greatest;
        Index face = 0;
        std::uint32_t last_asked = 0;

        [[nodiscard]] Interval hidden(const Point& a, const Point& b) const;
    };

    /// The cells that the box of some points meets.
    struct Cells {
        int left = 0;
        int right = 0;
        int bottom = 0;
        int top = 0;
        [[nodiscard]] std::size_t count() const {
            return static_cast<std::size_t>(right - left + 1) *
                   static_cast<std::size_t>(top - bottom + 1);
        }
    };
    [[nodiscard]] int cell(double coordinate) const;
    [[nodiscard]] Cells cells(const Point& least, const Point& greatest) const;
    [[nodiscard]] std::size_t all_cells() const;
    [[nodiscard]] std::vector<Interval> hidden(const Point& a, const Point& b,
                                               std::array<Index, 2> own_faces);
    template <class Visit>
    void for_each_in(const Cells& cells, const Visit& visit) const;

    std::vector<Triangle> triangles_;
    double reach_ = 0;                    // of the coordinates
    int width_ = 1;                       // of the grid, in cells
    std::vector<std::uint32_t> first_;    // of each cell in the list; one more at the end
    std::vector<std::uint32_t> in_cell_;  // triangles, cell by cell
    std::uint32_t questions_ = 0;
};

}  // namespace tightflip::geometry
