/// \file
/// Triangles glued side to side, that grow by splits: what initial triangulations are made in.
#pragma once

#include <tightflip/geometry/surface.hpp>
#include <tightflip/kernel/build.hpp>

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace tightflip::geometry {

/// Face f has the sides 3f, 3f + 1 and 3f + 2; side 3f + i runs from corner i to corner i + 1.
/// After a split or a flip the corner it is about is corner 2 of all faces made, which therefore
/// have their first side opposite to it.
class FaceMesh {
public:
    /// Closed, coherently oriented, without parallel edges.
    explicit FaceMesh(std::span<const std::array<Index, 3>> faces, Index vertices)
        : corners_(faces.begin(), faces.end()), twins_(3 * faces.size()) {
        const kernel::FaceListReading reading = kernel::glue_faces(faces, vertices);
        for (std::size_t s = 0; s < twins_.size(); ++s)
            twins_[s] = reading.gluing.faces[s / 3].sides[s % 3].side();
    }

    [[nodiscard]] const std::vector<std::array<Index, 3>>& faces() const { return corners_; }
    [[nodiscard]] const std::array<Index, 3>& corners(Index f) const { return corners_[at(f)]; }
    [[nodiscard]] Index twin(Index side) const { return twins_[at(side)]; }
    [[nodiscard]] Index corner(Index side) const { return corners_[at(side / 3)][at(side % 3)]; }
    [[nodiscard]] static Index after(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
    [[nodiscard]] static Index before(Index side) { return after(after(side)); }

    /// Puts v into face f, which keeps its side 3f; the faces on its sides 3f + 1 and 3f + 2 are
    /// the last but one and the last.
    void split_face(Index f, Index v) {
        const auto [a, b, c] = corners(f);
        const auto bc = static_cast<Index>(twins_.size());
        const Index ca = bc + 3;
        const Index beyond_bc = twin(3 * f + 1);
        const Index beyond_ca = twin(3 * f + 2);
        corners_[at(f)] = {a, b, v};
        corners_.insert(corners_.end(), {{b, c, v}, {c, a, v}});
        twins_.resize(twins_.size() + 6);
        link(bc, beyond_bc);
        link(ca, beyond_ca);
        link(3 * f + 1, bc + 2);
        link(bc + 1, ca + 2);
        link(ca + 1, 3 * f + 2);
    }

    /// Flips side ab of a face abc; the two new faces are adc, in place of abc, and dbc.
    void flip(Index side) {
        const Index t = twin(side);
        const Index f = side / 3;
        const Index g = t / 3;
        const std::array corners{corner(side), corner(t), corner(before(side)), corner(before(t))};
        const auto [a, b, c, d] = corners;
        const std::array outer{twin(after(side)), twin(before(side)), twin(after(t)),
                               twin(before(t))};
        const auto [beyond_bc, beyond_ca, beyond_ad, beyond_db] = outer;
        corners_[at(f)] = {a, d, c};
        corners_[at(g)] = {d, b, c};
        link(3 * f, beyond_ad);
        link(3 * f + 2, beyond_ca);
        link(3 * g, beyond_db);
        link(3 * g + 1, beyond_bc);
        link(3 * f + 1, 3 * g + 2);
    }

private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    void link(Index s, Index t) {
        twins_[at(s)] = t;
        twins_[at(t)] = s;
    }

    std::vector<std::array<Index, 3>> corners_;
    std::vector<Index> twins_;
};

/// The surface of a face list on these points. Precondition: the list is a closed surface.
[[nodiscard]] inline Surface surface_of_faces(std::span<const std::array<Index, 3>> faces,
                                              std::vector<Point> points) {
    const auto count = static_cast<Index>(points.size());
    return {kernel::build(faces, count).value(), std::move(points)};
}

}  // namespace tightflip::geometry
