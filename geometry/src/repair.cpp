#include "fill_holes.hpp"
#include "weld.hpp"
#include <tightflip/geometry/repair.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tightflip::geometry {
namespace {

using Triangle = std::array<Index, 3>;

/// Keeps the faces that `keep` names; the gluing goes where one is lost.
void keep_faces(TriangleSoup& soup, const std::vector<bool>& keep) {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        if (!keep[f]) continue;
        soup.triangles[kept] = soup.triangles[f];
        soup.triangle_positions[kept++] = soup.triangle_positions[f];
    }
    if (kept < soup.triangles.size()) soup.glued_sides.clear();
    soup.triangles.resize(kept);
    soup.triangle_positions.resize(kept);
}

Index drop_faces_repeating_corners(TriangleSoup& soup) {
    std::vector<bool> keep(soup.triangles.size());
    std::transform(soup.triangles.begin(), soup.triangles.end(), keep.begin(),
                   [](const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; });
    keep_faces(soup, keep);
    return static_cast<Index>(std::count(keep.begin(), keep.end(), false));
}

Index drop_faces_repeating_faces(TriangleSoup& soup) {
    if (soup.triangles.size() == 2) return 0;  // the smallest sphere: two faces, three vertices
    std::vector<std::pair<Triangle, std::size_t>> sorted;
    sorted.reserve(soup.triangles.size());
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        Triangle corners = soup.triangles[f];
        std::ranges::sort(corners);
        sorted.emplace_back(corners, f);
    }
    std::ranges::sort(sorted);
    std::vector<bool> keep(soup.triangles.size(), true);
    for (std::size_t i = 1; i < sorted.size(); ++i)
        keep[sorted[i].second] = sorted[i].first != sorted[i - 1].first;
    keep_faces(soup, keep);
    return static_cast<Index>(std::count(keep.begin(), keep.end(), false));
}

Index drop_unused(TriangleSoup& soup) {
    std::vector<Index> number(soup.points.size(), -1);
    for (const Triangle& triangle : soup.triangles) {
        for (const Index corner : triangle)
            number[static_cast<std::size_t>(corner)] = 0;
    }
    std::size_t kept = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        soup.points[kept] = soup.points[v];
        soup.point_positions[kept] = soup.point_positions[v];
        number[v] = static_cast<Index>(kept++);
    }
    const auto dropped = static_cast<Index>(soup.points.size() - kept);
    soup.points.resize(kept);
    soup.point_positions.resize(kept);
    for (Triangle& triangle : soup.triangles) {
        for (Index& corner : triangle)
            corner = number[static_cast<std::size_t>(corner)];
    }
    return dropped;
}

struct Line {
    Index RepairReport::*count;
    const char* one;
    const char* many;
};
constexpr std::array<Line, 7> lines{
    {{&RepairReport::points_welded, "point made one with another", "points made one with others"},
     {&RepairReport::faces_repeating_corners, "face dropped that repeats a corner",
      "faces dropped that repeat a corner"},
     {&RepairReport::faces_repeating_faces, "face dropped that repeats another",
      "faces dropped that repeat others"},
     {&RepairReport::vertices_unused, "vertex dropped that no face has",
      "vertices dropped that no face has"},
     {&RepairReport::holes_filled, "hole filled", "holes filled"},
     {&RepairReport::faces_added, "face added", "faces added"},
     {&RepairReport::sides_left_open, "boundary side left that belongs to no loop",
      "boundary sides left that belong to no loop"}}};

}  // namespace

std::vector<std::string> in_words(const RepairReport& report) {
    std::vector<std::string> words;
    for (const Line& line : lines) {
        const Index count = report.*line.count;
        if (count == 0) continue;
        words.push_back(std::to_string(count) + " " + (count == 1 ? line.one : line.many));
    }
    if (report.gluing_dropped) {
        words.emplace_back("the file's gluing left out, which no longer fits the faces");
    }
    if (words.empty()) words.emplace_back("nothing to repair");
    return words;
}

RepairReport repair(TriangleSoup& soup, const RepairOptions& options) {
    if (options.weld && !(*options.weld >= 0 && std::isfinite(*options.weld))) {
        throw std::invalid_argument(
            "the distance within which points are welded must be finite "
            "and not negative");
    }
    RepairReport report;
    const bool was_glued = !soup.glued_sides.empty();
    if (options.weld) {
        const Index before = soup.vertex_count();
        weld(soup, *options.weld);
        report.points_welded = before - soup.vertex_count();
        if (report.points_welded > 0) soup.glued_sides.clear();
    }
    if (options.drop_faces) {
        report.faces_repeating_corners = drop_faces_repeating_corners(soup);
        // Where the file says how faces are glued, two may have the same corners.
        if (soup.glued_sides.empty()) {
            report.faces_repeating_faces = drop_faces_repeating_faces(soup);
        }
        if (soup.triangles.empty()) {
            throw FileError(soup.source,
                            "no face is left when those that repeat a corner are "
                            "dropped; weld within a smaller distance");
        }
    }
    if (options.drop_unused) report.vertices_unused = drop_unused(soup);
    if (options.fill_holes) {
        const FilledHoles filled = fill_holes(soup);
        report.holes_filled = filled.holes;
        report.faces_added = filled.faces;
        report.sides_left_open = filled.sides_left_open;
    }
    report.gluing_dropped = was_glued && soup.glued_sides.empty();
    return report;
}

}  // namespace tightflip::geometry
