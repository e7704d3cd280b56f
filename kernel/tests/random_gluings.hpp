/// \file
/// Random gluings of every kind for the kernel's tests: honest surfaces, surfaces with one fault,
/// and garbage. The same seed gives the same gluing everywhere.
#pragma once

#include "surfaces.hpp"
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/halfedge_table.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <vector>

namespace tightflip::kernel::testing {

class RandomGluings {
public:
    explicit RandomGluings(std::uint64_t seed) : random_(seed) {}

    [[nodiscard]] RandomStream& stream() { return random_; }
    [[nodiscard]] Index below(Index bound) {
        return static_cast<Index>(random_.below(static_cast<std::uint32_t>(bound)));
    }

    /// Sides paired and directed at random, corners named as the pairing demands: closed surfaces
    /// of any genus, orientable or not, connected or not, most with loops.
    [[nodiscard]] Gluing sewn(Index face_pairs) {
        const Index sides = 6 * face_pairs;
        Gluing gluing = unglued(0, FaceList(static_cast<std::size_t>(2 * face_pairs)));
        std::vector<Index> order(static_cast<std::size_t>(sides));
        std::iota(order.begin(), order.end(), 0);
        random_.shuffle(std::span(order));
        const bool may_reverse = below(2) == 0;
        const auto far = [](Index s) { return s - s % 3 + (s + 1) % 3; };
        std::vector<std::pair<Index, Index>> same;  // corners that are one vertex
        for (std::size_t k = 0; k < order.size(); k += 2) {
            const Index s = order[k];
            const Index t = order[k + 1];
            const bool reversed = may_reverse && below(2) == 0;
            side(gluing, s) = reversed ? SideGluing::reversed(t) : SideGluing::coherent(t);
            side(gluing, t) = reversed ? SideGluing::reversed(s) : SideGluing::coherent(s);
            same.emplace_back(s, reversed ? t : far(t));
            same.emplace_back(far(s), reversed ? far(t) : t);
        }
        name_corners(gluing, same);
        return gluing;
    }

    /// An oriented surface of the allowed class, many flips away from a small one.
    [[nodiscard]] Gluing flipped() {
        static const std::vector<Gluing> starts{
            tetrahedron(), two_face_sphere(), book(3), book(4), octahedron(), seven_vertex_torus()};
        Gluing gluing = starts[random_.below(static_cast<std::uint32_t>(starts.size()))];
        std::vector<HalfedgeRecord> table = halfedge_table(gluing);
        for (int flips = 30; flips > 0; --flips) {
            static_cast<void>(flip(MutableHalfedgeTable(table),
                                   Edge{below(static_cast<Index>(table.size() / 2))}));
        }
        return gluing_of(table, gluing.vertex_count);
    }

    /// A surface as one might honestly list it: faces turned over, vertices renamed.
    [[nodiscard]] Gluing disguised(Gluing gluing) {
        for (Index f = 0; f < face_count(gluing); ++f) {
            if (below(3) == 0) gluing = with_face_turned_over(std::move(gluing), f);
        }
        std::vector<Index> labels(static_cast<std::size_t>(gluing.vertex_count));
        std::iota(labels.begin(), labels.end(), 0);
        random_.shuffle(std::span(labels));
        return relabelled(gluing, labels, gluing.vertex_count);
    }

    /// Any of the above and of the hand-made ones.
    [[nodiscard]] Gluing honest() {
        static const std::vector<Gluing> hand_made{projective_plane(),
                                                   pinched_tetrahedra(),
                                                   tetrahedra_sharing_an_edge(),
                                                   disc(),
                                                   disjoint_tetrahedra(),
                                                   disjoint_two_face_spheres(),
                                                   moebius_strip(),
                                                   looped_tetrahedron(),
                                                   lone_triangle()};
        switch (below(3)) {
            case 0:
                return disguised(sewn(1 + below(6)));
            case 1:
                return disguised(flipped());
            default:
                return disguised(
                    hand_made[random_.below(static_cast<std::uint32_t>(hand_made.size()))]);
        }
    }

    /// One fault, which may happen to be none.
    void damage(Gluing& gluing) {
        const Index s = below(side_count(gluing));
        const Index t = below(side_count(gluing));
        switch (below(9)) {
            case 0:
                side(gluing, s) = SideGluing::coherent(t);
                break;
            case 1:
                side(gluing, s) = {};
                break;
            case 2:  // cut an edge open
                if (exists(gluing, side(gluing, s).side())) {
                    side(gluing, side(gluing, s).side()) = {};
                }
                side(gluing, s) = {};
                break;
            case 3:
                join(gluing, s, t);
                break;
            case 4:
                std::swap(side(gluing, s), side(gluing, t));
                break;
            case 5:
                invert_bit(gluing, s);
                break;
            case 6:
                std::swap(corner(gluing, s), corner(gluing, t));
                break;
            case 7:
                corner(gluing, s) = below(gluing.vertex_count + 1);
                break;
            default:  // two vertices become one
                const Index from = corner(gluing, s);
                const Index to = corner(gluing, t);
                for (GluedFace& face : gluing.faces) {
                    for (Index& label : face.corners)
                        label = label == from ? to : label;
                }
        }
    }

    /// Anything at all, up to 12 faces.
    [[nodiscard]] Gluing garbage() {
        const Index faces = below(13);
        Gluing gluing{.vertex_count = any_index(8), .faces = {}};
        gluing.faces.resize(static_cast<std::size_t>(faces));
        const bool wild = below(2) == 0;
        for (Index s = 0; s < 3 * faces; ++s) {
            corner(gluing, s) = wild ? any_index(8) : below(4);
            const Index t = wild ? any_index(3 * faces) : below(3 * faces);
            if (below(8) != 0) {
                side(gluing, s) = below(2) == 0 ? SideGluing::coherent(t) : SideGluing::reversed(t);
            }
        }
        if (!wild) gluing.vertex_count = 4;
        return gluing;
    }

    // ---- between the two kinds of table, written for the tests alone ----

    /// Precondition: every side is glued coherently.
    [[nodiscard]] static std::vector<HalfedgeRecord> halfedge_table(const Gluing& gluing) {
        std::map<Index, Index> halfedge;
        for (Index s = 0; s < side_count(gluing); ++s) {
            if (halfedge.contains(s)) continue;
            const auto number = static_cast<Index>(halfedge.size());
            halfedge[s] = number;
            halfedge[side(gluing, s).side()] = number + 1;
        }
        std::vector<HalfedgeRecord> table(halfedge.size());
        for (const auto& [s, h] : halfedge) {
            nth(table, h) = {.next = {halfedge.at(s - s % 3 + (s + 1) % 3)},
                             .origin = {start_of(gluing, s)}};
        }
        return table;
    }
    /// Precondition: the table is one of triangles.
    [[nodiscard]] static Gluing gluing_of(const std::vector<HalfedgeRecord>& table,
                                          Index vertex_count) {
        std::map<Index, Index> side_of_halfedge;
        Gluing gluing{.vertex_count = vertex_count, .faces = {}};
        for (Index start = 0; start < static_cast<Index>(table.size()); ++start) {
            if (side_of_halfedge.contains(start)) continue;
            GluedFace face;
            Index h = start;
            for (Index& label : face.corners) {
                const auto number = static_cast<Index>(side_of_halfedge.size());
                side_of_halfedge[h] = number;
                label = nth(table, h).origin.id;
                h = nth(table, h).next.id;
            }
            gluing.faces.push_back(face);
        }
        for (const auto& [h, s] : side_of_halfedge) {
            side(gluing, s) = SideGluing::coherent(side_of_halfedge.at(h ^ 1));
        }
        return gluing;
    }

private:
    [[nodiscard]] static bool exists(const Gluing& gluing, Index s) {
        return s >= 0 && s < side_count(gluing);
    }
    [[nodiscard]] static Index& corner(Gluing& gluing, Index s) {
        return nth(nth(gluing.faces, s / 3).corners, s % 3);
    }
    /// Mostly below the bound, sometimes just outside, sometimes extreme.
    [[nodiscard]] Index any_index(Index bound) {
        static constexpr std::array<Index, 6> extremes{std::numeric_limits<Index>::min(),
                                                       std::numeric_limits<Index>::min() + 1,
                                                       std::numeric_limits<Index>::max(),
                                                       std::numeric_limits<Index>::max() - 1,
                                                       Index{1} << 30,
                                                       -(Index{1} << 30)};
        const Index kind = below(40);
        if (kind == 0) return extremes[random_.below(6)];
        if (kind == 1) return -1;
        if (kind == 2 || bound == 0) return bound;
        return below(bound);
    }
    static void name_corners(Gluing& gluing, const std::vector<std::pair<Index, Index>>& same) {
        std::vector<Index> name(static_cast<std::size_t>(side_count(gluing)));
        std::iota(name.begin(), name.end(), 0);
        for (const auto& [a, b] : same) {
            const Index old = nth(name, a);
            std::ranges::replace(name, old, Index{nth(name, b)});
        }
        std::map<Index, Index> number;
        for (const Index n : name)
            number.emplace(n, static_cast<Index>(number.size()));
        for (Index s = 0; s < side_count(gluing); ++s) {
            corner(gluing, s) = number.at(nth(name, s));
        }
        gluing.vertex_count = static_cast<Index>(number.size());
    }

    RandomStream random_;
};

}  // namespace tightflip::kernel::testing
