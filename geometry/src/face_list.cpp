#include "face_list.hpp"

#include <algorithm>

namespace tightflip::geometry {
namespace {

/// Calls `visit` with the three halfedges of each face.
template <class Visit>
void for_each_face(kernel::HalfedgeTable table, Visit visit) {
    for (Index h = 0; h < std::ssize(table); ++h) {
        const Halfedge second = at(table, Halfedge{h}).next;
        const Halfedge third = at(table, second).next;
        if (h < second.id && h < third.id) visit(std::array{Halfedge{h}, second, third});
    }
}

}  // namespace

std::vector<FaceCorners> corners_of_faces(kernel::HalfedgeTable table) {
    std::vector<FaceCorners> faces;
    faces.reserve(table.size() / 3);
    for_each_face(table, [&](const std::array<Halfedge, 3>& sides) {
        FaceCorners& corners = faces.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = at(table, sides[i]).origin.id;
    });
    return faces;
}

std::vector<FaceCorners> glued_sides_of_faces(kernel::HalfedgeTable table) {
    std::vector<Index> side(table.size());  // of a halfedge
    Index count = 0;
    for_each_face(table, [&](const std::array<Halfedge, 3>& sides) {
        for (const Halfedge h : sides)
            side[static_cast<std::size_t>(h.id)] = count++;
    });
    std::vector<FaceCorners> glued(table.size() / 3);
    for (std::size_t h = 0; h < table.size(); ++h) {
        const auto s = static_cast<std::size_t>(side[h]);
        glued[s / 3][s % 3] =
            side[static_cast<std::size_t>(twin(Halfedge{static_cast<Index>(h)}).id)];
    }
    return glued;
}

std::optional<std::pair<Vertex, Vertex>> parallel_edges(kernel::HalfedgeTable table) {
    std::vector<std::pair<Index, Index>> ends;
    ends.reserve(table.size() / 2);
    for (std::size_t h = 0; h < table.size(); h += 2)
        ends.push_back(std::minmax(table[h].origin.id, table[h + 1].origin.id));
    std::ranges::sort(ends);
    const auto twice = std::ranges::adjacent_find(ends);
    if (twice == ends.end()) return std::nullopt;
    return std::pair{Vertex{twice->first}, Vertex{twice->second}};
}

}  // namespace tightflip::geometry
