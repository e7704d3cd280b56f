#include <tightflip/properties/invariants.hpp>

#include <algorithm>
#include <array>

namespace tightflip::properties {
namespace {

using kernel::HalfedgeTable;
using kernel::PlaceKind;
using kernel::Quadrilateral;
using kernel::Vertex;

/// The corners of the two faces at an edge: those of the even halfedge's face, then the odd one's.
using SixCorners = std::array<Vertex, 6>;

SixCorners corners_at(HalfedgeTable table, Edge e) {
    const auto q = Quadrilateral::around(table, e);
    return {at(table, q.h).origin, at(table, q.h1).origin, at(table, q.h2).origin,
            at(table, q.t).origin, at(table, q.t1).origin, at(table, q.t2).origin};
}

}  // namespace

std::vector<Violation> changes(const Topology& start, const Topology& now) {
    struct Row {
        ViolationCode code;
        std::int64_t now;
        std::int64_t start;
    };
    using enum ViolationCode;
    const std::array rows{
        Row{vertex_count_changed, now.vertices, start.vertices},
        Row{edge_count_changed, now.edges, start.edges},
        Row{face_count_changed, now.faces, start.faces},
        Row{component_count_changed, now.components, start.components},
        Row{euler_characteristic_changed, now.euler_characteristic, start.euler_characteristic},
        Row{orientability_changed, now.orientable ? 1 : 0, start.orientable ? 1 : 0},
        Row{genus_changed, now.genus.value_or(-1), start.genus.value_or(-1)},
    };
    std::vector<Violation> found;
    for (const Row& row : rows) {
        if (row.now != row.start) {
            found.push_back({.code = row.code, .found = row.now, .expected = row.start});
        }
    }
    return found;
}

namespace {

constexpr kernel::AuditOptions first_only{.max_per_code = 1, .statistics = false};

std::optional<Violation> first_of(AuditReport report, const Topology& start) {
    if (!report.is_valid()) return std::move(report.violations.front());
    std::vector<Violation> changed = changes(start, report.topology);
    if (!changed.empty()) return std::move(changed.front());
    return std::nullopt;
}

}  // namespace

std::optional<Violation> first_violation(const Triangulation& surface, const Topology& start) {
    return first_of(climb_audit_ladder(surface.table(), surface.vertex_count(), first_only), start);
}

std::optional<Violation> first_violation_quickly(const Triangulation& surface,
                                                 const Topology& start) {
    return first_of(audit(surface, first_only), start);
}

CheckedFlip checked_flip(Triangulation& surface, Edge e) {
    const auto [a, b, c, b_again, a_again, d] = corners_at(surface.table(), e);
    const bool done = static_cast<bool>(surface.flip(e));
    if (!done) {
        if (c != d) return {false, ViolationCode::refusal_unjustified};
        return {false, std::nullopt};
    }
    if (const auto code = audit_at_edge(surface.table(), surface.vertex_count(), e)) {
        return {true, code};
    }
    if (corners_at(surface.table(), e) != SixCorners{d, c, a, c, d, b}) {
        return {true, ViolationCode::flip_not_as_defined};
    }
    return {true, std::nullopt};
}

Violation explain(const Triangulation& surface, Edge e, ViolationCode code) {
    Violation violation{.code = code, .kind = kernel::PlaceKind::edge, .place = e.id};
    const bool is_about_flips =
        code == ViolationCode::refusal_unjustified || code == ViolationCode::flip_not_as_defined;
    if (!is_about_flips) {  // the audit knows the code too, and the details
        AuditReport report = audit(surface, {.max_per_code = 1, .statistics = false});
        const auto same = std::ranges::find(report.violations, code, &Violation::code);
        return same != report.violations.end() ? std::move(*same) : violation;
    }
    const SixCorners corners = corners_at(surface.table(), e);
    for (const Vertex v : corners)
        violation.witness.push_back(v.id);
    violation.found = corners[2].id;
    violation.expected = corners[5].id;
    return violation;
}

}  // namespace tightflip::properties
