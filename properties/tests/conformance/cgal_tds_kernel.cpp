#ifndef CGAL_NDEBUG
#define CGAL_NDEBUG
#endif

#include "kernels.hpp"

#include <map>
#include <memory>
#include <utility>

#include <CGAL/Triangulation_data_structure_2.h>

namespace tightflip::properties {
namespace {

using Tds = CGAL::Triangulation_data_structure_2<>;

/// Faces and their neighbours: a side is a face and the corner opposite.
struct TdsSide {
    Tds::Face_handle face;
    int corner = 0;
    friend bool operator<(const TdsSide& a, const TdsSide& b) {
        return std::pair(a.face, a.corner) < std::pair(b.face, b.corner);
    }
};

struct TdsKernel {
    static constexpr std::string_view name = "CGAL::Triangulation_data_structure_2";
    static constexpr KernelClass allowed = KernelClass::simple;
    static constexpr bool keeps_sides = false;
    using Side = TdsSide;

    TdsKernel(Index vertex_count, std::span<const std::array<Index, 3>> corners)
        : tds(std::make_unique<Tds>()) {
        tds->set_dimension(2);
        for (Index v = 0; v < vertex_count; ++v) {
            vertices.push_back(tds->create_vertex());
            numbers[&*vertices.back()] = v;
        }
        std::map<std::pair<Index, Index>, Side> by_ends;
        for (const auto& triangle : corners) {
            const auto at = [&](int i) { return triangle[static_cast<std::size_t>(i % 3)]; };
            const auto vertex = [&](int i) { return vertices[static_cast<std::size_t>(at(i))]; };
            const Tds::Face_handle face = tds->create_face(vertex(0), vertex(1), vertex(2));
            faces.push_back(face);
            for (int i = 0; i < 3; ++i) {
                vertex(i)->set_face(face);
                by_ends[{at(i + 1), at(i + 2)}] = {face, i};
            }
        }
        for (const auto& [ends, side] : by_ends)
            side.face->set_neighbor(side.corner, by_ends.at({ends.second, ends.first}).face);
    }

    [[nodiscard]] std::array<Index, 3> counts() const {
        return {static_cast<Index>(tds->number_of_vertices()),
                static_cast<Index>(tds->number_of_edges()),
                static_cast<Index>(tds->number_of_faces())};
    }
    [[nodiscard]] std::vector<Side> sides() const {
        std::vector<Side> all;
        for (const Tds::Face_handle face : faces) {
            for (int i = 0; i < 3; ++i)
                all.push_back({face, i});
        }
        return all;
    }
    [[nodiscard]] Side next(const Side& s) const { return {s.face, Tds::ccw(s.corner)}; }
    [[nodiscard]] Side across(const Side& s) const {
        return {s.face->neighbor(s.corner), tds->mirror_index(s.face, s.corner)};
    }
    [[nodiscard]] Index origin(const Side& s) const {
        return numbers.at(&*s.face->vertex(Tds::ccw(s.corner)));
    }
    // The documented precondition names nothing but the dimension.
    [[nodiscard]] bool can_flip(const Side&) const { return tds->dimension() == 2; }
    void flip(const Side& s) { tds->flip(s.face, s.corner); }
    [[nodiscard]] bool is_valid() const { return tds->is_valid(); }

    void set_origin(const Side& s, Index v) {
        s.face->set_vertex(Tds::ccw(s.corner), vertices[static_cast<std::size_t>(v)]);
    }
    void set_across(const Side& s, const Side& wrong) {
        s.face->set_neighbor(s.corner, wrong.face);
    }

    std::unique_ptr<Tds> tds;  // handles point into it
    std::vector<Tds::Vertex_handle> vertices;
    std::vector<Tds::Face_handle> faces;
    std::map<const void*, Index> numbers;
};

}  // namespace

KernelDescription cgal_triangulation_data_structure(KernelClass allowed) {
    return judged_as<TdsKernel>(allowed);
}

}  // namespace tightflip::properties
