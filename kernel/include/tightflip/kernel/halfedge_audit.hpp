/// \file
/// The judge's door for halfedge tables: what a table says in faces and sides, and a constant-time
/// look at the two faces of one edge. Usable in constant expressions.
#pragma once

#include <tightflip/kernel/audit_ladder.hpp>
#include <tightflip/kernel/halfedge_table.hpp>

namespace tightflip::kernel {

/// A halfedge table read as a gluing; empty gluing and violations (codes 11x) where it is none.
struct TableReading {
    Gluing gluing;
    std::vector<Violation> violations;
};

/// Reads any table, believing nothing: linear time, one word of scratch a halfedge. Faces are
/// numbered by their smallest halfedge, which becomes their side 0.
[[nodiscard]] constexpr TableReading read_table(HalfedgeTable table, Index vertex_count) {
    TableReading reading;
    reading.gluing.vertex_count = vertex_count;
    const auto count = static_cast<Index>(table.size());
    const auto fail = [&](ViolationCode code, Index h, Index found, Index limit) {
        const PlaceKind kind = h < 0 ? PlaceKind::surface : PlaceKind::halfedge;
        reading.violations.push_back(
            {.code = code, .kind = kind, .place = h, .found = found, .expected = limit});
    };
    if (count % 2 != 0) fail(ViolationCode::halfedge_count_odd, -1, count, count - 1);
    for (Index h = 0; h < count; ++h) {
        const auto [next, origin] = table[static_cast<std::size_t>(h)];
        if (next.id < 0 || next.id >= count) {
            fail(ViolationCode::next_out_of_range, h, next.id, count);
        }
        if (origin.id < 0 || origin.id >= vertex_count) {
            fail(ViolationCode::origin_out_of_range, h, origin.id, vertex_count);
        }
    }
    if (!reading.violations.empty()) return reading;

    std::vector<Index> side(table.size(), -1);  // of a halfedge
    reading.gluing.faces.reserve(table.size() / 3);
    for (Index h = 0; h < count; ++h) {
        if (side[static_cast<std::size_t>(h)] >= 0) continue;
        const Index n = at(table, Halfedge{h}).next.id;
        const Index p = at(table, Halfedge{n}).next.id;
        const Index back = at(table, Halfedge{p}).next.id;
        if (back != h || n == h || p == h) {
            fail(ViolationCode::next_cycle_not_triangle, h, back, h);
            continue;
        }
        const auto face = static_cast<Index>(reading.gluing.faces.size());
        GluedFace& glued = reading.gluing.faces.emplace_back();
        int i = 0;
        for (const Index x : {h, n, p}) {
            side[static_cast<std::size_t>(x)] = side_of(face, i);
            glued.corners[static_cast<std::size_t>(i++)] = at(table, Halfedge{x}).origin.id;
        }
    }
    if (!reading.violations.empty()) {
        reading.gluing.faces.clear();
        return reading;
    }
    for (Index h = 0; h < count; ++h) {
        const Index s = side[static_cast<std::size_t>(h)];
        reading.gluing.faces[static_cast<std::size_t>(s / 3)]
            .sides[static_cast<std::size_t>(s % 3)] =
            SideGluing::coherent(side[static_cast<std::size_t>(h ^ 1)]);
    }
    return reading;
}

/// The full audit of a halfedge table, for constant expressions; linear time.
[[nodiscard]] constexpr AuditReport climb_audit_ladder(HalfedgeTable table, Index vertex_count,
                                                       const AuditOptions& options = {}) {
    TableReading reading = read_table(table, vertex_count);
    if (reading.violations.empty()) return climb_audit_ladder(reading.gluing, options);
    AuditReport report;
    report.topology.vertices = vertex_count;
    report.topology.edges = static_cast<Index>(table.size() / 2);
    report.violation_count = static_cast<std::int64_t>(reading.violations.size());
    std::ranges::sort(reading.violations, precedes);
    ViolationCode code{};
    std::int64_t of_code = 0;
    for (Violation& violation : reading.violations) {
        of_code = violation.code == code ? of_code + 1 : 1;
        code = violation.code;
        if (of_code <= options.max_per_code) report.violations.push_back(std::move(violation));
    }
    return report;
}

/// The full audit of a halfedge table; linear time.
[[nodiscard]] AuditReport audit(HalfedgeTable table, Index vertex_count,
                                const AuditOptions& options = {});

/// The part of the audit that one flip can break and constant time can see: the two faces at `e`
/// are triangles with distinct corners, their six sides agree with the faces behind them about
/// which vertices they join, and both obey the three-neighbour rule. Empty where all holds.
/// Precondition: the table has an even number of halfedges and `e` is one of its edges.
[[nodiscard]] constexpr std::optional<ViolationCode> audit_at_edge(HalfedgeTable table,
                                                                   Index vertex_count,
                                                                   Edge e) noexcept {
    const auto count = static_cast<Index>(table.size());
    const auto in_range = [&](Halfedge h) { return h.id >= 0 && h.id < count; };
    for (const Halfedge start : {halfedge_of(e), twin(halfedge_of(e))}) {
        std::array<Halfedge, 3> sides{start, {}, {}};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [next, origin] = at(table, sides[i]);
            if (!in_range(next)) return ViolationCode::next_out_of_range;
            if (origin.id < 0 || origin.id >= vertex_count) {
                return ViolationCode::origin_out_of_range;
            }
            if (i < 2) sides[i + 1] = next;
        }
        const auto& [x, y, z] = sides;
        if (at(table, z).next != x || x == y || x == z) {
            return ViolationCode::next_cycle_not_triangle;
        }
        if (!corners_are_distinct(at(table, x).origin, at(table, y).origin, at(table, z).origin)) {
            return ViolationCode::corners_not_distinct;
        }
        for (const Halfedge s : sides) {
            const Halfedge behind = at(table, twin(s)).next;
            if (!in_range(behind)) return ViolationCode::next_out_of_range;
            if (at(table, twin(s)).origin != at(table, at(table, s).next).origin ||
                at(table, behind).origin != at(table, s).origin) {
                return ViolationCode::labels_disagree;
            }
        }
        // All three neighbours coincide exactly when the face behind x holds twin y and twin z.
        const Halfedge a = at(table, twin(x)).next;
        const Halfedge b = at(table, a).next;
        const bool all_coincide = (twin(y) == a || twin(y) == b) && (twin(z) == a || twin(z) == b);
        if (all_coincide && count != 6) return ViolationCode::three_neighbour_rule_broken;
    }
    return std::nullopt;
}

}  // namespace tightflip::kernel
