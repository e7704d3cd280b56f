#include "criteria.hpp"

#include <algorithm>
#include <array>

namespace tightflip::geometry {
namespace {

using enum CriterionKind;

constexpr bool heights = true;
constexpr bool exact = true;

constexpr std::array table{
    CriterionInfo{tight, "tight", "total absolute curvature, Omega_abs"},
    CriterionInfo{mean, "mean", "absolute mean curvature, H_abs"},
    CriterionInfo{mean_weighted, "mean_weighted", "absolute mean curvature times edge length"},
    CriterionInfo{area, "area", "area"},
    CriterionInfo{edge_length, "edge_length", "total length of the edges"},
    CriterionInfo{volume, "volume", "minus the signed volume (flips concave edges)", !heights,
                  exact},
    CriterionInfo{abn, "abn", "angles between normals"},
    CriterionInfo{abn_squares, "abn_squares", "squares of the angles between normals"},
    CriterionInfo{delaunay, "delaunay", "cotangents of all angles (Delaunay, within the surface)"},
    CriterionInfo{min_angle, "min_angle", "what smallest angles lack of pi/3"},
    CriterionInfo{jnd, "jnd", "jumps of the normal derivative", heights},
    CriterionInfo{delaunay_plane, "delaunay_plane",
                  "volume under the lifted points (Delaunay, in the plane)", heights, exact},
    CriterionInfo{bending, "bending", "energy of a thin plate", heights},
};

}  // namespace

std::span<const CriterionInfo> all_criteria() {
    return table;
}

const CriterionInfo& info(CriterionKind kind) {
    return table.at(static_cast<std::size_t>(kind));
}

std::optional<CriterionKind> criterion_by_name(std::string_view name) {
    const auto* found = std::ranges::find(table, name, &CriterionInfo::name);
    if (found == table.end()) return std::nullopt;
    return found->kind;
}

std::unique_ptr<Criterion> make_criterion(CriterionKind kind, const SurfaceView& surface,
                                          Vertex marked) {
    std::unique_ptr<Criterion> made;
    for (const auto make :
         {make_tight_criterion, make_edge_criterion, make_face_criterion, make_volume_criterion}) {
        if (made == nullptr) made = make(kind, surface, marked);
    }
    return made;
}

}  // namespace tightflip::geometry
