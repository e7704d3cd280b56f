/// \file
/// The rules all formats share: finite points, existing corners, triangles, and the limits.
#pragma once

#include "formats.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace tightflip::geometry {

/// Collects points and polygons and refuses what no format may say, at the place given with it.
class SoupBuilder {
public:
    /// `unit` counts the positions; `first_label` is the number the format gives its first vertex.
    SoupBuilder(const MeshInput& input, FileError::Unit unit, std::int64_t first_label);

    /// Makes room. Only for numbers that the input's size has been seen to allow.
    void reserve(std::size_t points, std::size_t triangles);

    void add_point(const Eigen::Vector3d& point, std::uint64_t position);
    /// Corners counted from 0 whatever the format's labels; they may name points yet to come.
    void add_polygon(std::span<const std::int64_t> corners, std::uint64_t position);
    /// What the sides of the latest polygon, which must be a triangle, are glued to; -1 for
    /// nothing.
    void add_glued_sides(std::span<const std::int64_t> sides, std::uint64_t position);

    /// The soup, now that all points are known. Refuses corners without a point, glued sides
    /// without a triangle and, unless options say so, no triangles.
    [[nodiscard]] TriangleSoup finish() &&;

    [[nodiscard]] std::int64_t point_count() const noexcept { return std::ssize(soup_.points); }
    [[nodiscard]] std::int64_t label_of(std::int64_t corner) const noexcept {
        return corner + first_label_;
    }

    [[noreturn]] void fail(std::uint64_t position, std::string reason) const;

private:
    [[nodiscard]] Index checked(std::int64_t corner, std::uint64_t position) const;
    void refuse_missing_corners() const;
    void refuse_missing_sides() const;
    [[noreturn]] void fail_for_side(std::int64_t side, std::uint64_t position) const;

    TriangleSoup soup_;
    std::int64_t first_label_;
    bool triangulate_;
    bool faces_required_;
    std::int64_t max_faces_;
};

}  // namespace tightflip::geometry
