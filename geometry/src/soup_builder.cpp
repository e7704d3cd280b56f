#include "soup_builder.hpp"

#include <algorithm>
#include <utility>

namespace tightflip::geometry {

SoupBuilder::SoupBuilder(const MeshInput& input, FileError::Unit unit, std::int64_t first_label)
    : first_label_(first_label),
      triangulate_(input.options.triangulate_polygons),
      faces_required_(input.options.faces_required),
      max_faces_(std::clamp(input.options.max_faces, Index{0}, kernel::max_faces)) {
    soup_.source = input.source;
    soup_.unit = unit;
}

void SoupBuilder::reserve(std::size_t points, std::size_t triangles) {
    const auto limit = static_cast<std::size_t>(max_faces_);
    soup_.points.reserve(std::min(points, 3 * limit));
    soup_.point_positions.reserve(std::min(points, 3 * limit));
    soup_.triangles.reserve(std::min(triangles, limit));
    soup_.triangle_positions.reserve(std::min(triangles, limit));
}

void SoupBuilder::add_point(const Eigen::Vector3d& point, std::uint64_t position) {
    if (!point.allFinite()) {
        fail(position, "a coordinate of vertex " + std::to_string(label_of(point_count())) +
                           " is not finite; repair the program or the data that it came from");
    }
    if (point_count() == 3 * max_faces_) {
        fail(position, "more vertices than " + std::to_string(max_faces_) + " faces have corners");
    }
    soup_.points.push_back(point);
    soup_.point_positions.push_back(position);
}

void SoupBuilder::add_polygon(std::span<const std::int64_t> corners, std::uint64_t position) {
    const std::size_t n = corners.size();
    if (n < 3) {
        fail(position, "a face has " + std::to_string(n) + " corners; it needs three");
    }
    if (n > 3 && !triangulate_) {
        fail(position, "a face has " + std::to_string(n) +
                           " corners, not three; triangulate the mesh, or have every polygon cut "
                           "into a fan (--triangulate; in the library, triangulate_polygons)");
    }
    if (std::cmp_greater(n - 2, max_faces_ - std::ssize(soup_.triangles))) {
        fail(position, "more than " + std::to_string(max_faces_) + " faces, which is the limit");
    }
    const Index hub = checked(corners[0], position);
    for (std::size_t i = 2; i < n; ++i) {
        soup_.triangles.push_back(
            {hub, checked(corners[i - 1], position), checked(corners[i], position)});
        soup_.triangle_positions.push_back(position);
    }
}

void SoupBuilder::add_glued_sides(std::span<const std::int64_t> sides, std::uint64_t position) {
    if (soup_.glued_sides.size() + 1 != soup_.triangles.size()) {
        fail(position,
             "a face whose glued sides are listed has more than three corners; only "
             "triangles can be glued");
    }
    if (sides.size() != 3) {
        fail(position,
             std::to_string(sides.size()) + " glued sides are listed for a face, which has three");
    }
    std::array<Index, 3>& glued = soup_.glued_sides.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
        if (sides[i] < -1 || sides[i] >= 3 * max_faces_) fail_for_side(sides[i], position);
        glued[i] = static_cast<Index>(sides[i]);
    }
}

TriangleSoup SoupBuilder::finish() && {
    refuse_missing_corners();
    refuse_missing_sides();
    if (faces_required_ && soup_.triangles.empty()) {
        throw FileError(soup_.source, "the file has no faces, and so describes no surface");
    }
    return std::move(soup_);
}

void SoupBuilder::refuse_missing_corners() const {
    for (std::size_t f = 0; f < soup_.triangles.size(); ++f) {
        for (const Index corner : soup_.triangles[f]) {
            if (corner < point_count()) continue;
            fail(soup_.triangle_positions[f],
                 "vertex " + std::to_string(label_of(corner)) + " does not exist: the file has " +
                     std::to_string(point_count()) + " vertices, numbered from " +
                     std::to_string(first_label_));
        }
    }
}

void SoupBuilder::refuse_missing_sides() const {
    for (std::size_t f = 0; f < soup_.glued_sides.size(); ++f) {
        for (const Index side : soup_.glued_sides[f]) {
            if (side < 3 * std::ssize(soup_.triangles)) continue;
            fail_for_side(side, soup_.triangle_positions[f]);
        }
    }
}

Index SoupBuilder::checked(std::int64_t corner, std::uint64_t position) const {
    if (corner < 0 || corner >= 3 * max_faces_) {
        fail(position, "vertex " + std::to_string(label_of(corner)) +
                           " does not exist: vertices are numbered from " +
                           std::to_string(first_label_) + " and stay below " +
                           std::to_string(label_of(3 * max_faces_)));
    }
    return static_cast<Index>(corner);
}

void SoupBuilder::fail_for_side(std::int64_t side, std::uint64_t position) const {
    fail(position, "a side is glued to " + std::to_string(side) +
                       ", which does not exist: sides are numbered 3 * face + side, from 0, and -1 "
                       "means glued to none");
}

void SoupBuilder::fail(std::uint64_t position, std::string reason) const {
    throw FileError(soup_.source, soup_.unit, position, std::move(reason));
}

}  // namespace tightflip::geometry
