/// \file
/// The audit once more, from its definitions, with maps and sets, in quadratic to exponential time:
/// a second opinion that shares no line and no idea with the library's.
#pragma once

#include "surfaces.hpp"
#include <tightflip/kernel/audit.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tightflip::kernel::testing {

/// Labels 0 .. n - 1, all pairs that belong together joined by painting one class in the other's
/// colour.
class Classes {
public:
    explicit Classes(Index n) {
        for (Index i = 0; i < n; ++i)
            colour_[i] = i;
    }
    void join(Index a, Index b) {
        const Index from = colour_.at(a);
        const Index to = colour_.at(b);
        for (auto& [item, colour] : colour_) {
            if (colour == from) colour = to;
        }
    }
    [[nodiscard]] Index of(Index item) const { return colour_.at(item); }
    /// How many of the items with these colours there are, the most first.
    [[nodiscard]] std::vector<Index> sizes() const {
        std::map<Index, Index> count;
        for (const auto& [item, colour] : colour_)
            ++count[colour];
        std::vector<Index> sizes;
        for (const auto& [colour, size] : count)
            sizes.push_back(size);
        std::sort(sizes.rbegin(), sizes.rend());
        return sizes;
    }

private:
    std::map<Index, Index> colour_;
};

/// Everything the judge should say of a gluing; the part about the whole surface only where the
/// tables are well formed.
class NaiveAudit {
public:
    using Places = std::map<ViolationCode, std::multiset<Index>>;

    explicit NaiveAudit(const Gluing& gluing) : gluing_(gluing) {
        judge_tables();
        judge_sides();
        judge_faces();
        if (!well_formed) return;
        judge_components();
        judge_orientability();
        judge_vertices();
        count();
    }

    bool well_formed = true;
    bool coherently_stored = true;
    Places places;  ///< of every violation; -1 for the whole surface and for not_orientable
    std::vector<Index> component_sizes;
    std::vector<Index> part_sizes;  ///< faces in the parts that share vertices
    std::map<Index, Index> fans;
    Topology topology;
    DegreeStatistics degrees;
    ParallelStatistics parallels;

    /// The side behind a side, where the two are glued properly.
    [[nodiscard]] std::optional<Index> behind(Index s) const {
        const auto found = partner_.find(s);
        return found == partner_.end() ? std::nullopt : std::optional(found->second);
    }
    [[nodiscard]] bool turns_over(Index s) const {
        const Index t = partner_.at(s);
        return is_loop(s) ? side(gluing_, s).is_reversed()
                          : start_of(gluing_, s) == start_of(gluing_, t);
    }

private:
    using enum ViolationCode;

    void report(ViolationCode code, Index place = -1) { places[code].insert(place); }
    [[nodiscard]] bool is_loop(Index s) const { return start_of(gluing_, s) == end_of(gluing_, s); }
    [[nodiscard]] std::multiset<Index> ends(Index s) const {
        return {start_of(gluing_, s), end_of(gluing_, s)};
    }

    void judge_tables() {
        if (gluing_.faces.empty()) report(no_faces);
        if (!gluing_.faces.empty() && gluing_.vertex_count > side_count(gluing_)) {
            report(more_vertices_than_corners);
        }
        for (Index s = 0; s < side_count(gluing_); ++s) {
            const Index corner = start_of(gluing_, s);
            if (corner < 0 || corner >= gluing_.vertex_count) report(corner_out_of_range, s);
            if (side(gluing_, s).is_glued() && !exists(side(gluing_, s).side())) {
                report(gluing_out_of_range, s);
            }
        }
        well_formed = places.empty();
    }
    [[nodiscard]] bool exists(Index s) const { return s >= 0 && s < side_count(gluing_); }

    void judge_sides() {
        for (Index s = 0; s < side_count(gluing_); ++s) {
            const SideGluing here = side(gluing_, s);
            if (!here.is_glued()) {
                report(side_unglued, s);
                continue;
            }
            const Index t = here.side();
            if (!exists(t)) continue;
            const SideGluing there = side(gluing_, t);
            const bool points_back = there.is_glued() && there.side() == s;
            if (t == s) {
                report(side_glued_to_itself, s);
            } else if (!points_back) {
                report(gluing_not_involution, s);
            } else if (ends(s) != ends(t)) {
                if (s < t) report(labels_disagree, s);
            } else if (is_loop(s) && here.is_reversed() != there.is_reversed()) {
                report(gluing_not_involution, s);
            } else {
                partner_[s] = t;
                if (here.is_reversed() != turns_over(s)) {
                    report(coherence_bit_contradicts_labels, s);
                }
                coherently_stored = coherently_stored && !turns_over(s);
            }
        }
    }

    void judge_faces() {
        for (Index f = 0; f < face_count(gluing_); ++f) {
            const auto& c = nth(gluing_.faces, f).corners;
            const bool distinct = std::set<Index>(c.begin(), c.end()).size() == 3;
            if (!distinct) report(corners_not_distinct, f);

            std::set<Index> neighbours;
            int glued_sides = 0;
            for (Index s = 3 * f; s < 3 * f + 3; ++s) {
                if (!behind(s)) continue;
                ++glued_sides;
                neighbours.insert(*behind(s) / 3);
            }
            const bool broken = neighbours.contains(f) || neighbours.size() == 1;
            const bool only_two_faces =
                neighbours.size() == 1 && face_count(gluing_) == 2 && !neighbours.contains(f);
            if (glued_sides == 3 && broken && !only_two_faces) {
                report(three_neighbour_rule_broken, f);
            }
        }
    }

    void judge_components() {
        Classes by_sides(face_count(gluing_));
        for (const auto& [s, t] : partner_)
            by_sides.join(s / 3, t / 3);
        Classes by_vertices = by_sides;
        for (Index s = 0; s < side_count(gluing_); ++s) {
            for (Index t = 0; t < s; ++t) {
                if (start_of(gluing_, s) == start_of(gluing_, t)) by_vertices.join(s / 3, t / 3);
            }
        }
        component_sizes = by_sides.sizes();
        part_sizes = by_vertices.sizes();
        if (component_sizes.size() > 1) report(faces_not_strongly_connected);
        if (part_sizes.size() > 1) report(vertices_not_connected);
        topology.components = static_cast<Index>(component_sizes.size());
    }

    /// Tries every choice of orientations; where they are too many, looks for a face that is joined
    /// to itself turned over.
    void judge_orientability() {
        topology.orientable = face_count(gluing_) <= 12 ? some_orientation_fits()
                                                        : no_face_meets_itself_turned_over();
        if (!topology.orientable) report(not_orientable);
    }
    [[nodiscard]] bool some_orientation_fits() const {
        for (std::uint32_t turned = 0; turned < (1U << face_count(gluing_)); turned += 2) {
            if (std::ranges::all_of(partner_, [&](const auto& crossing) {
                    const auto [s, t] = crossing;
                    const bool differ = (((turned >> (s / 3)) ^ (turned >> (t / 3))) & 1U) != 0;
                    return differ == turns_over(s);
                })) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] bool no_face_meets_itself_turned_over() const {
        Classes sheets(2 * face_count(gluing_));
        for (const auto& [s, t] : partner_) {
            const Index change = turns_over(s) ? 1 : 0;
            sheets.join(2 * (s / 3), 2 * (t / 3) + change);
            sheets.join(2 * (s / 3) + 1, 2 * (t / 3) + 1 - change);
        }
        for (Index f = 0; f < face_count(gluing_); ++f) {
            if (sheets.of(2 * f) == sheets.of(2 * f + 1)) return false;
        }
        return true;
    }

    /// Corners at a vertex belong to one fan where a glued side leads from one to the other.
    void judge_vertices() {
        Classes corners(side_count(gluing_));
        const auto far = [](Index s) { return s - s % 3 + (s + 1) % 3; };
        for (const auto& [s, t] : partner_) {
            corners.join(s, turns_over(s) ? t : far(t));
            corners.join(far(s), turns_over(s) ? far(t) : t);
        }
        std::map<Index, std::set<Index>> fans_at;
        for (Index s = 0; s < side_count(gluing_); ++s) {
            fans_at[start_of(gluing_, s)].insert(corners.of(s));
        }
        for (Index v = 0; v < gluing_.vertex_count; ++v) {
            fans[v] = static_cast<Index>(fans_at[v].size());
            if (fans[v] == 0) report(vertex_unused, v);
            if (fans[v] > 1) report(vertex_with_several_fans, v);
        }
    }

    void count() {
        std::map<Index, Index> degree;
        std::map<std::pair<Index, Index>, Index> joining;
        for (Index s = 0; s < side_count(gluing_); ++s) {
            if (behind(s) && *behind(s) < s) continue;
            const Index a = start_of(gluing_, s);
            const Index b = end_of(gluing_, s);
            ++degree[a];
            ++degree[b];
            ++topology.edges;
            if (a == b) {
                ++parallels.loops;
            } else {
                ++joining[std::minmax(a, b)];
            }
        }
        topology.vertices = gluing_.vertex_count;
        topology.faces = face_count(gluing_);
        topology.euler_characteristic = topology.vertices - topology.edges + topology.faces;
        for (const auto& [ends, edges] : joining) {
            if (edges > 1) ++parallels.pairs_joined_twice;
            parallels.max_multiplicity = std::max(parallels.max_multiplicity, edges);
        }
        std::vector<Index> sorted;
        for (const auto& [vertex, d] : degree)
            sorted.push_back(d);
        std::ranges::sort(sorted);
        degrees = {.min = sorted.front(),
                   .max = sorted.back(),
                   .degree_two_vertices = static_cast<Index>(std::ranges::count(sorted, Index{2}))};
        const bool closed_surface =
            places.empty() || (places.size() == 1 && places.contains(not_orientable));
        if (closed_surface) {
            topology.genus = (2 - topology.euler_characteristic) / (topology.orientable ? 2 : 1);
        }
    }

    const Gluing& gluing_;
    std::map<Index, Index> partner_;
};

/// Whether a closed walk over these faces, each adjacent to the following one and the last to the
/// first, can be made to reverse the orientation.
[[nodiscard]] inline bool reverses_orientation(const Gluing& gluing, std::vector<Index> walk) {
    if (walk.empty()) return false;
    const NaiveAudit judge(gluing);
    walk.push_back(walk.front());
    std::set<bool> reachable{false};  // what the orientation can have become so far
    for (std::size_t i = 0; i + 1 < walk.size(); ++i) {
        if (walk[i] < 0 || walk[i] >= face_count(gluing)) return false;
        std::set<bool> further;
        for (Index s = 3 * walk[i]; s < 3 * walk[i] + 3; ++s) {
            if (judge.behind(s).value_or(-1) / 3 != walk[i + 1] || !judge.behind(s)) continue;
            for (const bool turned : reachable)
                further.insert(turned != judge.turns_over(s));
        }
        reachable = further;
    }
    return reachable.contains(true);
}

}  // namespace tightflip::kernel::testing
