/// \file
/// The audit itself, usable in constant expressions. Elsewhere include `audit.hpp`.
#pragma once

#include <tightflip/kernel/allowed_class.hpp>
#include <tightflip/kernel/audit.hpp>

#include <algorithm>
#include <span>
#include <utility>

namespace tightflip::kernel {
namespace detail {

/// One climb over one gluing. Three passes over the tables (sides and faces; components and
/// orientation; vertices), and a fourth for parallel edges where statistics are wanted.
class AuditLadder {
public:
    constexpr AuditLadder(GluingView gluing, const AuditOptions& options)
        : vertex_count_(gluing.vertex_count), faces_(gluing.faces), options_(options) {}

    constexpr AuditReport climb() {
        report_.topology.vertices = vertex_count_;
        report_.topology.faces = face_count();
        judge_sides_and_faces();
        if (tables_are_well_formed_) {
            judge_components_and_orientation();
            judge_vertices();
            if (options_.statistics) count_parallel_edges();
            conclude();
        }
        std::ranges::sort(report_.violations, precedes);
        return std::move(report_);
    }

private:
    /// What lies behind a side, and whether crossing it turns the orientation over.
    struct Crossing {
        Index side = -1;
        bool reversed = false;
        [[nodiscard]] constexpr bool exists() const noexcept { return side >= 0; }
    };

    /// A corner met while walking about its vertex, and the side to leave the face by.
    struct Step {
        Index corner = -1;  // as 3 * face + i
        Index exit = -1;
    };

    // ---- raw reads ----

    [[nodiscard]] constexpr Index face_count() const noexcept {
        return static_cast<Index>(faces_.size());
    }
    [[nodiscard]] constexpr SideGluing raw(Index side) const noexcept {
        return faces_[static_cast<std::size_t>(side / 3)].sides[static_cast<std::size_t>(side % 3)];
    }
    [[nodiscard]] constexpr Index label(Index corner) const noexcept {
        return faces_[static_cast<std::size_t>(corner / 3)]
            .corners[static_cast<std::size_t>(corner % 3)];
    }
    /// The following place in the same face, for sides and corners alike.
    [[nodiscard]] static constexpr Index turn(Index place) noexcept {
        return place % 3 == 2 ? place - 2 : place + 1;
    }
    [[nodiscard]] static constexpr Index turn_back(Index place) noexcept {
        return place % 3 == 0 ? place + 2 : place - 1;
    }

    // ---- what the labels say of two sides ----

    [[nodiscard]] constexpr bool agree_coherently(Index s, Index t) const noexcept {
        return label(s) == label(turn(t)) && label(turn(s)) == label(t);
    }
    [[nodiscard]] constexpr bool agree_reversed(Index s, Index t) const noexcept {
        return label(s) == label(t) && label(turn(s)) == label(turn(t));
    }
    /// Only on a loop, where the labels cannot tell, the stored bit is asked.
    [[nodiscard]] constexpr bool is_loop(Index s) const noexcept {
        return label(s) == label(turn(s));
    }
    [[nodiscard]] constexpr bool is_reversed(Index s, Index t) const noexcept {
        return is_loop(s) ? raw(s).is_reversed() : agree_reversed(s, t);
    }
    [[nodiscard]] constexpr bool points_back(Index s, Index t) const noexcept {
        return raw(t).is_glued() && raw(t).side() == s &&
               (!(is_loop(s) && agree_coherently(s, t)) ||
                raw(t).is_reversed() == raw(s).is_reversed());
    }
    [[nodiscard]] constexpr bool is_sound(Index s, Index t) const noexcept {
        return t != s && points_back(s, t) && (agree_coherently(s, t) || agree_reversed(s, t));
    }
    /// The side glued to `s`; none where the gluing is missing or defective.
    [[nodiscard]] constexpr Crossing across(Index s) const noexcept {
        if (!raw(s).is_glued()) return {};
        const Index t = raw(s).side();
        if (!all_sides_sound_ && !is_sound(s, t)) return {};
        return {t, is_reversed(s, t)};
    }

    constexpr void add(Violation violation) {
        ++report_.violation_count;
        std::int64_t& count = count_by_code_[static_cast<std::size_t>(violation.code)];
        if (count++ < options_.max_per_code) report_.violations.push_back(std::move(violation));
    }
    constexpr void add_broken_table(ViolationCode code, Index side, std::int64_t found,
                                    std::int64_t limit) {
        tables_are_well_formed_ = false;
        add({.code = code,
             .kind = side < 0 ? PlaceKind::surface : PlaceKind::side,
             .place = side,
             .found = found,
             .expected = limit});
    }

    // ---- rungs 1 to 5: tables, sides and faces ----

    constexpr void judge_sides_and_faces() {
        if (faces_.empty()) add_broken_table(ViolationCode::no_faces, -1, 0, 1);
        const std::int64_t corners = 3 * std::int64_t{face_count()};
        if (!faces_.empty() && vertex_count_ > corners) {  // also bounds the scratch memory
            add_broken_table(ViolationCode::more_vertices_than_corners, -1, vertex_count_, corners);
        }
        Index glued_sides = 0;
        bool coherent = true;
        for (Index f = 0; f < face_count(); ++f) {
            std::array<Index, 3> neighbours{};
            bool has_three = true;
            for (int i = 0; i < 3; ++i) {
                const Index s = side_of(f, i);
                if (label(s) < 0 || label(s) >= vertex_count_) {
                    add_broken_table(ViolationCode::corner_out_of_range, s, label(s),
                                     vertex_count_);
                }
                const bool sound = judge_side(s);
                all_sides_sound_ = all_sides_sound_ && (sound || !raw(s).is_glued());
                has_three = has_three && sound;
                if (!sound) continue;
                ++glued_sides;
                neighbours[static_cast<std::size_t>(i)] = raw(s).side() / 3;
                coherent = coherent && !is_reversed(s, raw(s).side());
            }
            judge_face(f, neighbours, has_three);
        }
        report_.topology.edges = 3 * face_count() - glued_sides / 2;
        report_.coherently_stored = coherent;
    }

    constexpr bool judge_side(Index s) {
        const auto report = [&](ViolationCode code, Index found) {
            add({.code = code, .kind = PlaceKind::side, .place = s, .found = found});
            return false;
        };
        if (!raw(s).is_glued()) return report(ViolationCode::side_unglued, -1);
        const Index t = raw(s).side();
        if (t < 0 || t >= 3 * face_count()) {
            add_broken_table(ViolationCode::gluing_out_of_range, s, t,
                             3 * std::int64_t{face_count()});
            return false;
        }
        if (t == s) return report(ViolationCode::side_glued_to_itself, t);
        if (!points_back(s, t)) {
            return report(ViolationCode::gluing_not_involution, t);
        }
        const bool coherent = agree_coherently(s, t);
        const bool reversed = agree_reversed(s, t);
        if (!coherent && !reversed) {
            if (s < t) report(ViolationCode::labels_disagree, t);
            return false;
        }
        if (raw(s).is_reversed() ? !reversed : !coherent) {
            report(ViolationCode::coherence_bit_contradicts_labels, t);
        }
        return true;
    }

    constexpr void judge_face(Index f, const std::array<Index, 3>& n, bool has_three) {
        const auto& [a, b, c] = faces_[static_cast<std::size_t>(f)].corners;
        if (!corners_are_distinct(a, b, c)) {
            add({.code = ViolationCode::corners_not_distinct,
                 .kind = PlaceKind::face,
                 .place = f,
                 .witness = {a, b, c}});
        }
        const bool is_two_face_sphere = face_count() == 2;
        if (has_three && !three_neighbour_rule(f, n[0], n[1], n[2], is_two_face_sphere)) {
            add({.code = ViolationCode::three_neighbour_rule_broken,
                 .kind = PlaceKind::face,
                 .place = f,
                 .witness = {n[0], n[1], n[2]}});
        }
    }

    // ---- rungs 7 and 8: components of faces, and their orientation ----

    constexpr void judge_components_and_orientation() {
        std::vector<Index> order;  // faces as they are reached; components are runs of it
        std::vector<Index> starts;
        std::vector<std::uint8_t> sheet(faces_.size(), 0);  // 0 unseen, 1 as stored, 2 turned over
        order.reserve(faces_.size());
        Crossing conflict;
        for (Index root = 0; root < face_count(); ++root) {
            if (sheet[static_cast<std::size_t>(root)] != 0) continue;
            std::size_t next = order.size();
            starts.push_back(static_cast<Index>(next));
            order.push_back(root);
            sheet[static_cast<std::size_t>(root)] = 1;
            for (; next < order.size(); ++next) {
                const Index f = order[next];
                for (int i = 0; i < 3; ++i) {
                    const Crossing crossing = across(side_of(f, i));
                    if (!crossing.exists()) continue;
                    const std::uint8_t mine = sheet[static_cast<std::size_t>(f)];
                    const auto wanted =
                        static_cast<std::uint8_t>(crossing.reversed ? 3 - mine : mine);
                    std::uint8_t& theirs = sheet[static_cast<std::size_t>(crossing.side / 3)];
                    if (theirs == 0) {
                        theirs = wanted;
                        order.push_back(crossing.side / 3);
                    } else if (theirs != wanted && !conflict.exists()) {
                        conflict = {side_of(f, i), crossing.reversed};
                    }
                }
            }
        }
        report_.topology.components = static_cast<Index>(starts.size());
        report_.topology.orientable = !conflict.exists();
        if (starts.size() > 1) judge_connectedness(order, starts);
        if (conflict.exists()) {
            std::vector<Index> cycle = orientation_reversing_cycle(conflict.side);
            Violation violation{.code = ViolationCode::not_orientable,
                                .kind = PlaceKind::face,
                                .place = cycle.front(),
                                .found = static_cast<std::int64_t>(cycle.size())};
            violation.witness = std::move(cycle);
            add(std::move(violation));
        }
    }

    /// Where faces fall into several components by sides: do they at least share vertices?
    constexpr void judge_connectedness(std::span<const Index> order,
                                       std::span<const Index> starts) {
        const std::size_t components = starts.size();
        std::vector<Index> leader(components);  // union-find over components
        for (std::size_t c = 0; c < components; ++c)
            leader[c] = static_cast<Index>(c);
        const auto find = [&](Index c) {
            while (leader[static_cast<std::size_t>(c)] != c) {
                Index& up = leader[static_cast<std::size_t>(c)];
                up = leader[static_cast<std::size_t>(up)];
                c = up;
            }
            return c;
        };
        std::vector<Index> sizes(components, 0);
        std::vector<Index> seen_in(static_cast<std::size_t>(vertex_count_), -1);
        for (std::size_t c = 0; c < components; ++c) {
            const auto end =
                c + 1 < components ? static_cast<std::size_t>(starts[c + 1]) : order.size();
            for (auto k = static_cast<std::size_t>(starts[c]); k < end; ++k) {
                ++sizes[c];
                for (const Index v : faces_[static_cast<std::size_t>(order[k])].corners) {
                    Index& other = seen_in[static_cast<std::size_t>(v)];
                    if (other < 0) other = static_cast<Index>(c);
                    leader[static_cast<std::size_t>(find(static_cast<Index>(c)))] = find(other);
                }
            }
        }
        std::vector<Index> part_sizes(components, 0);
        for (std::size_t c = 0; c < components; ++c) {
            part_sizes[static_cast<std::size_t>(find(static_cast<Index>(c)))] += sizes[c];
        }
        std::erase(part_sizes, 0);
        const auto report = [&](ViolationCode code, std::vector<Index> part) {
            std::ranges::sort(part, std::ranges::greater{});
            const auto found = static_cast<std::int64_t>(part.size());
            add({.code = code, .found = found, .expected = 1, .witness = std::move(part)});
        };
        if (part_sizes.size() > 1) report(ViolationCode::vertices_not_connected, part_sizes);
        report(ViolationCode::faces_not_strongly_connected, sizes);
    }

    /// The faces of a simple cycle along which orientation is reversed, given a side at which it
    /// shows: breadth-first from the face of `side` on its orientation cover to the face's other
    /// sheet. Only run where a surface is not orientable.
    [[nodiscard]] constexpr std::vector<Index> orientation_reversing_cycle(Index side) const {
        const Index root = 2 * (side / 3);
        std::vector<Index> parent(2 * faces_.size(), -1);
        std::vector<Index> queue{root};
        parent[static_cast<std::size_t>(root)] = root;
        for (std::size_t next = 0; next < queue.size(); ++next) {
            const Index node = queue[next];  // 2 * face + sheet
            for (int i = 0; i < 3; ++i) {
                const Crossing crossing = across(side_of(node / 2, i));
                if (!crossing.exists()) continue;
                const Index to =
                    2 * (crossing.side / 3) + ((node & 1) ^ (crossing.reversed ? 1 : 0));
                if (parent[static_cast<std::size_t>(to)] >= 0) continue;
                parent[static_cast<std::size_t>(to)] = node;
                queue.push_back(to);
            }
        }
        // The way back passes some face on both sheets, the root at the latest; between the first
        // two such passes no face comes twice.
        std::vector<Index> cycle;
        std::vector<Index> passed_at(faces_.size(), -1);
        for (Index node = root + 1;; node = parent[static_cast<std::size_t>(node)]) {
            Index& passed = passed_at[static_cast<std::size_t>(node / 2)];
            if (passed >= 0) {
                cycle.erase(cycle.begin(), cycle.begin() + passed);
                break;
            }
            passed = static_cast<Index>(cycle.size());
            cycle.push_back(node / 2);
        }
        return cycle;
    }

    // ---- rung 6: vertices ----

    constexpr void judge_vertices() {
        std::vector<std::uint8_t> seen(3 * faces_.size(), 0);  // corners walked over
        std::vector<Index> fans(static_cast<std::size_t>(vertex_count_), 0);
        std::vector<Index> degree(options_.statistics ? static_cast<std::size_t>(vertex_count_) : 0,
                                  0);
        for (Index start = 0; start < 3 * face_count(); ++start) {
            if (seen[static_cast<std::size_t>(start)] != 0) continue;
            const auto v = static_cast<std::size_t>(label(start));
            const Index edges = walk_fan(start, seen);
            ++fans[v];
            if (options_.statistics) degree[v] += edges;
        }
        for (Index v = 0; v < vertex_count_; ++v) {
            const Index count = fans[static_cast<std::size_t>(v)];
            if (count == 1) continue;
            add({.code = count == 0 ? ViolationCode::vertex_unused
                                    : ViolationCode::vertex_with_several_fans,
                 .kind = PlaceKind::vertex,
                 .place = v,
                 .found = count,
                 .expected = 1});
        }
        if (options_.statistics) summarise_degrees(degree);
    }

    /// Marks the corners of the fan about a corner's vertex; returns how many edges it has there.
    constexpr Index walk_fan(Index start, std::vector<std::uint8_t>& seen) const {
        Index corners = 0;
        const auto walk = [&](Step step) {  // true when it came round to where it started
            while (true) {
                const Crossing crossing = across(step.exit);
                if (!crossing.exists()) return false;
                // The vertex stands at the near or the far end of the side left by.
                const bool at_start = (step.exit == step.corner) != crossing.reversed;
                const Index corner = at_start ? turn(crossing.side) : crossing.side;
                if (seen[static_cast<std::size_t>(corner)] != 0) return corner == start;
                seen[static_cast<std::size_t>(corner)] = 1;
                ++corners;
                step = {corner, crossing.side == corner ? turn_back(corner) : corner};
            }
        };
        seen[static_cast<std::size_t>(start)] = 1;
        ++corners;
        const bool closed = walk({start, start});
        if (!closed) walk({start, turn_back(start)});
        return closed ? corners : corners + 1;
    }

    constexpr void summarise_degrees(std::span<const Index> degree) {
        DegreeStatistics statistics;
        for (const Index d : degree) {
            if (d == 0) continue;
            statistics.min = statistics.min == 0 ? d : std::min(statistics.min, d);
            statistics.max = std::max(statistics.max, d);
            statistics.degree_two_vertices += d == 2 ? 1 : 0;
        }
        report_.degrees = statistics;
    }

    // ---- statistics: parallel edges ----

    /// Buckets the edges by their smaller end, then counts the larger ends in each bucket.
    constexpr void count_parallel_edges() {
        ParallelStatistics statistics;
        std::vector<Index> offset(static_cast<std::size_t>(vertex_count_) + 1, 0);
        const auto for_each_edge = [&](auto&& visit) {
            for (Index s = 0; s < 3 * face_count(); ++s) {
                const Crossing crossing = across(s);
                if (!crossing.exists() || s < crossing.side) {
                    visit(std::min(label(s), label(turn(s))), std::max(label(s), label(turn(s))));
                }
            }
        };
        for_each_edge([&](Index low, Index) { ++offset[static_cast<std::size_t>(low) + 1]; });
        for (std::size_t v = 1; v < offset.size(); ++v)
            offset[v] += offset[v - 1];
        std::vector<Index> high_ends(static_cast<std::size_t>(offset.back()));
        std::vector<Index> fill(offset.begin(), offset.end() - 1);
        for_each_edge([&](Index low, Index high) {
            high_ends[static_cast<std::size_t>(fill[static_cast<std::size_t>(low)]++)] = high;
        });
        std::vector<Index> multiplicity(static_cast<std::size_t>(vertex_count_), 0);
        for (Index v = 0; v < vertex_count_; ++v) {
            const auto begin = static_cast<std::size_t>(offset[static_cast<std::size_t>(v)]);
            const auto end = static_cast<std::size_t>(offset[static_cast<std::size_t>(v) + 1]);
            const auto bucket = std::span(high_ends).subspan(begin, end - begin);
            for (const Index w : bucket) {
                if (w == v) {
                    ++statistics.loops;
                    continue;
                }
                const Index count = ++multiplicity[static_cast<std::size_t>(w)];
                statistics.pairs_joined_twice += count == 2 ? 1 : 0;
                statistics.max_multiplicity = std::max(statistics.max_multiplicity, count);
            }
            for (const Index w : bucket)
                multiplicity[static_cast<std::size_t>(w)] = 0;
        }
        report_.parallels = statistics;
    }

    // ---- the top ----

    constexpr void conclude() {
        Topology& t = report_.topology;
        report_.reached_top = true;
        t.euler_characteristic = t.vertices - t.edges + t.faces;
        if (report_.is_closed_surface()) {
            t.genus = t.orientable ? (2 - t.euler_characteristic) / 2 : 2 - t.euler_characteristic;
        }
    }

    Index vertex_count_;
    std::span<const GluedFace> faces_;
    AuditOptions options_;
    bool tables_are_well_formed_ = true;
    bool all_sides_sound_ = true;  // no glued side is defective, so `across` need not look again
    std::array<std::int64_t, 1000> count_by_code_{};
    AuditReport report_;
};

}  // namespace detail

/// `audit`, for constant expressions.
[[nodiscard]] constexpr AuditReport climb_audit_ladder(GluingView gluing,
                                                       const AuditOptions& options = {}) {
    return detail::AuditLadder(gluing, options).climb();
}

}  // namespace tightflip::kernel
