#include "nth.hpp"
#include <tightflip/kernel/audit.hpp>
#include <tightflip/properties/side_tables.hpp>

#include <algorithm>

namespace tightflip::properties {
namespace {

bool names_a_side(const SideTables& tables, Index side) {
    return side >= 0 && side < tables.size();
}

/// What is wrong in one class and allowed in another.
bool is_allowed(ViolationCode code, KernelClass allowed) {
    return allowed == KernelClass::delta_complex &&
           (code == ViolationCode::corners_not_distinct ||
            code == ViolationCode::three_neighbour_rule_broken);
}

}  // namespace

std::string_view name(KernelClass kernel_class) noexcept {
    constexpr std::array<std::string_view, 3> names{"simple", "loopless", "delta-complex"};
    return names[static_cast<std::size_t>(kernel_class)];
}

SideTables side_tables(const Triangulation& surface) {
    SideTables tables{
        .vertex_count = surface.vertex_count(), .next = {}, .across = {}, .origin = {}};
    for (Index h = 0; h < surface.halfedge_count(); ++h) {
        tables.next.push_back(surface.next({h}).id);
        tables.across.push_back(h ^ 1);
        tables.origin.push_back(surface.origin({h}).id);
    }
    return tables;
}

SideReading read_as_gluing(const SideTables& tables) {
    SideReading reading{
        .gluing = {.vertex_count = tables.vertex_count, .faces = {}}, .sides = {}, .fault = {}};
    std::vector<Index> place(tables.next.size(), -1);  // where each side stands in the gluing
    for (Index first = 0; first < tables.size(); ++first) {
        if (nth(place, first) >= 0) continue;
        Index side = first;
        kernel::GluedFace& face = reading.gluing.faces.emplace_back();
        for (Index& corner : face.corners) {
            if (!names_a_side(tables, side) || nth(place, side) >= 0) {
                reading.fault = "the face of side " + std::to_string(first) + " is not a triangle";
                return reading;
            }
            corner = nth(tables.origin, side);
            nth(place, side) = static_cast<Index>(reading.sides.size());
            reading.sides.push_back(side);
            side = nth(tables.next, side);
        }
        if (side != first) {
            reading.fault = "the face of side " + std::to_string(first) + " is not a triangle";
            return reading;
        }
    }
    for (std::size_t g = 0; g < reading.sides.size(); ++g) {
        const Index across = nth(tables.across, reading.sides[g]);
        if (!names_a_side(tables, across)) continue;  // stays unglued, and the audit says so
        reading.gluing.faces[g / 3].sides[g % 3] = kernel::SideGluing::coherent(nth(place, across));
    }
    return reading;
}

Judgement judge(const SideTables& tables, KernelClass allowed) {
    const SideReading reading = read_as_gluing(tables);
    Judgement judgement;
    judgement.fault = reading.fault;
    if (!judgement.is_valid()) return judgement;
    const AuditReport report = kernel::audit(reading.gluing);
    judgement.topology = report.topology;
    const auto wrong = std::ranges::find_if(report.violations, [&](const Violation& violation) {
        return !is_allowed(violation.code, allowed);
    });
    if (wrong != report.violations.end()) {
        judgement.fault = where(*wrong) + ": " + message(*wrong);
    } else if (!report.coherently_stored) {
        judgement.fault = "the faces are not listed in one orientation";
    } else if (allowed == KernelClass::simple && !report.is_simple().value_or(true)) {
        judgement.fault = "there are parallel edges";
    }
    // The audit gives no genus where there are loops.
    if (judgement.is_valid()) {
        judgement.topology.genus = (2 - judgement.topology.euler_characteristic) / 2;
    }
    return judgement;
}

std::optional<std::array<Index, 6>> sides_around(const SideTables& tables, Index side) {
    const auto next = [&](Index s) { return nth(tables.next, s); };
    const Index other = nth(tables.across, side);
    const std::array<Index, 6> around{side,  next(side),  next(next(side)),
                                      other, next(other), next(next(other))};
    if (other == around[0] || other == around[1] || other == around[2]) return std::nullopt;
    return around;
}

bool flip_by_definition(SideTables& tables, Index side) {
    const auto around = sides_around(tables, side);
    if (!around) return false;
    const auto [s, s1, s2, t, t1, t2] = *around;
    nth(tables.origin, s) = nth(tables.origin, t2);
    nth(tables.origin, t) = nth(tables.origin, s2);
    nth(tables.next, s) = s2;
    nth(tables.next, s2) = t1;
    nth(tables.next, t1) = s;
    nth(tables.next, t) = t2;
    nth(tables.next, t2) = s1;
    nth(tables.next, s1) = t;
    return true;
}

std::optional<std::vector<Index>> isomorphism(const SideTables& a, Index from, const SideTables& b,
                                              Index to) {
    if (a.size() != b.size()) return std::nullopt;
    std::vector<Index> image(a.next.size(), -1);
    std::vector<bool> taken(a.next.size(), false);
    std::vector<Index> queue;
    const auto pair = [&](Index x, Index y) {
        if (!names_a_side(a, x) || !names_a_side(b, y)) return false;
        if (nth(image, x) >= 0) return nth(image, x) == y;
        if (taken[static_cast<std::size_t>(y)] || nth(a.origin, x) != nth(b.origin, y)) {
            return false;
        }
        nth(image, x) = y;
        taken[static_cast<std::size_t>(y)] = true;
        queue.push_back(x);
        return true;
    };
    if (!pair(from, to)) return std::nullopt;
    std::size_t done = 0;
    while (done < queue.size()) {
        const Index x = queue[done++];
        const Index y = nth(image, x);
        if (!pair(nth(a.next, x), nth(b.next, y))) return std::nullopt;
        if (!pair(nth(a.across, x), nth(b.across, y))) return std::nullopt;
    }
    if (queue.size() != image.size()) return std::nullopt;
    return image;
}

}  // namespace tightflip::properties
