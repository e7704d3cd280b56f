/// \file
/// A closed surface from polygonal cross sections, as of an organ from the slices of a scan.
#pragma once

#include <tightflip/geometry/data_refusal.hpp>
#include <tightflip/geometry/surface.hpp>

#include <span>
#include <vector>

namespace tightflip::geometry {

/// The corners of a simple polygon at one height, in either direction of turning.
using Contour = std::vector<Point>;

/// A sphere through the corners of contours at ascending heights, labelled in the order given. The
/// lowest and the highest are closed by triangles in their planes. Between two neighbours there is
/// a band of triangles, each with a side of one contour and a corner of the other, of least total
/// area (Fuchs, Kedem and Uselton, CACM 20 (1977)) among those bands that use the shortest segment
/// between the contours and change there from one contour to the other; so no two vertices are
/// joined twice. Bands of contours that differ much may intersect themselves. Time and memory O(m
/// n) for neighbours of m and n corners. Refused: not_finite, too_few_sections, contour_too_short,
/// contour_not_horizontal, contours_not_ascending, contour_not_simple.
[[nodiscard]] Outcome<Surface> surface_from_cross_sections(std::span<const Contour> sections);

}  // namespace tightflip::geometry
