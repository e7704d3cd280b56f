/// \file
/// An initial triangulation of any data: points put one by one into the faces of a tetrahedron.
#pragma once

#include <tightflip/geometry/data_refusal.hpp>
#include <tightflip/geometry/surface.hpp>

#include <cstdint>

namespace tightflip::geometry {

/// Which face takes the next point.
enum class StackingFace : std::uint8_t {
    random,   ///< any, all equally likely; linear time
    nearest,  ///< the one whose centroid is nearest to the point; quadratic time
};

/// Points in random order: four make a tetrahedron, each other is put into a face. Genus 0, simple,
/// and in general full of self-intersections. The tetrahedron's faces are counter-clockwise seen
/// from outside (any way where the four lie in one plane). Coincident points are allowed, and make
/// faces of no area. Refused: too_few_points (below 4), not_finite.
[[nodiscard]] Outcome<Surface> stacked_surface(std::vector<Point> points, std::uint64_t seed,
                                               StackingFace choice = StackingFace::random);

}  // namespace tightflip::geometry
