#include "planted_damage.hpp"

#include "nth.hpp"
#include <tightflip/properties/child_process.hpp>

#include <algorithm>
#include <array>

namespace tightflip::properties {
namespace {

/// The flip by its definition, done as meshes of faces do it: each face keeps its sides and their
/// order, and what changes is the origins and the sides across.
void flip_in_place(SideTables& tables, Index side) {
    const auto around = sides_around(tables, side);
    SideTables flipped = tables;
    if (!around || !flip_by_definition(flipped, side)) return;
    const auto [s, s1, s2, t, t1, t2] = *around;
    const std::array<std::array<Index, 2>, 4> moves{{{s2, s1}, {t1, s2}, {t2, t1}, {s1, t2}}};
    const auto place = [&moves](Index moved) {
        const auto* const found =
            std::ranges::find(moves, moved, [](auto& move) { return move[0]; });
        return found == moves.end() ? moved : (*found)[1];
    };
    for (Index moved = 0; moved < tables.size(); ++moved) {
        nth(tables.origin, place(moved)) = nth(flipped.origin, moved);
        nth(tables.across, place(moved)) = place(nth(flipped.across, moved));
    }
}

/// An edge that the class forbids, when two flips make one: on a tetrahedron the first makes a
/// double edge and the second a loop.
template <auto flip>
SideTables with_forbidden_edge(const SideTables& start, Index side, KernelClass allowed) {
    SideTables tables = start;
    flip(tables, side);
    if (judge(tables, allowed).is_valid()) flip(tables, nth(tables.next, side));
    return judge(tables, allowed).is_valid() ? start : tables;
}

constexpr std::array all_damages{
    Damage{KernelCode::wrong_origin_accepted, "wrong origin",
           [](const SideTables& right, Index side, KernelClass) {
               SideTables tables = right;
               nth(tables.origin, side) = (nth(tables.origin, side) + 1) % tables.vertex_count;
               return tables;
           }},
    Damage{KernelCode::wrong_next_accepted, "wrong next side",
           [](const SideTables& right, Index side, KernelClass) {
               SideTables tables = right;
               nth(tables.next, side) = nth(tables.across, nth(tables.next, side));
               return tables;
           }},
    Damage{KernelCode::wrong_across_accepted, "wrong side across",
           [](const SideTables& right, Index side, KernelClass) {
               SideTables tables = right;
               nth(tables.across, side) = nth(tables.across, nth(tables.next, side));
               return tables;
           }},
    Damage{KernelCode::forbidden_edge_accepted, "forbidden edge",
           with_forbidden_edge<flip_by_definition>},
    Damage{KernelCode::forbidden_edge_accepted, "forbidden edge",
           with_forbidden_edge<flip_in_place>},
    Damage{KernelCode::forbidden_edge_accepted, "forbidden edge",
           with_forbidden_edge<flip_by_definition>, true},
};

/// Changes what differs; false where the kernel does not let itself be changed so.
bool change(KernelUnderTest& mesh, const SideTables& from, const SideTables& to) {
    for (Index side = 0; side < from.size(); ++side) {
        const auto becomes = [&](PlantedFault fault, std::vector<Index> SideTables::*entries) {
            const Index wrong = nth(to.*entries, side);
            return nth(from.*entries, side) == wrong || mesh.plant(fault, side, wrong);
        };
        if (!becomes(PlantedFault::wrong_origin, &SideTables::origin) ||
            !becomes(PlantedFault::wrong_next, &SideTables::next) ||
            !becomes(PlantedFault::wrong_across, &SideTables::across)) {
            return false;
        }
    }
    return true;
}

/// The kernel with the damage done; null where that cannot be.
std::unique_ptr<KernelUnderTest> damaged(const KernelDescription& kernel, const Damage& damage,
                                         const Triangulation& start, Index side) {
    const SideTables given = side_tables(start);
    const auto made = [&](const SideTables& tables) {
        return kernel.make(read_as_gluing(tables).gluing);
    };
    auto mesh = made(given);
    const SideTables before = mesh->tables();
    const bool is_sound = before.size() == given.size() && judge(before, kernel.allowed).is_valid();
    if (!is_sound) return nullptr;
    const SideTables planned = damage.planned(before, side, kernel.allowed);
    if (damage.from_gluing) return kernel.takes_gluings ? made(planned) : nullptr;
    if (!change(*mesh, before, planned)) return nullptr;
    return mesh;
}

/// What is wrong with a kernel, in a line; empty where the audit sees no harm.
std::string fault_of(const KernelUnderTest& mesh, KernelClass allowed) {
    std::string fault;
    const auto thrown = thrown_by([&] { fault = judge(mesh.tables(), allowed).fault; });
    return thrown ? "its sides cannot be read any more: " + *thrown : fault;
}

constexpr std::string_view passed = "passed";

/// Writes nothing where there is no harm; else what it is, a line, and then the validator's answer.
void ask_validator(const KernelDescription& kernel, const Damage& damage,
                   const Triangulation& start, Index side, const ChildOutput& write) {
    const auto mesh = damaged(kernel, damage, start, side);
    if (!mesh) return;
    const std::string fault = fault_of(*mesh, kernel.allowed);
    if (fault.empty()) return;
    write(fault + "\n");
    write(mesh->is_valid() ? passed : "rejected");
}

}  // namespace

std::span<const Damage> damages() noexcept {
    return all_damages;
}

bool plant_damage(const KernelDescription& kernel, const Damage& damage, const std::string& name,
                  const Triangulation& start, const ConformanceOptions& options,
                  KernelReport& report) {
    for (Index side = 0; side < start.halfedge_count(); ++side) {
        const auto work = [&](const ChildOutput& write) {
            ask_validator(kernel, damage, start, side, write);
        };
        const ChildResult child =
            options.isolate ? run_in_child(work, options.seconds) : run_here(work);
        const auto line_end = child.output.rfind('\n');
        if (line_end == std::string::npos) {  // no harm was done, and the validator not asked
            if (child.timed_out) return true;
            continue;
        }
        ++report.planted;
        ++report.asked[static_cast<std::size_t>(KernelProperty::validator)];
        const bool failed = !child.failure.empty();
        if (!failed && child.output.substr(line_end + 1) != passed) continue;
        const std::string planted = "a " + std::string(damage.words) + " planted at side " +
                                    std::to_string(side) + " (" + child.output.substr(0, line_end) +
                                    ")";
        KernelFinding finding{.code = failed ? KernelCode::crashed_or_hung_on_damage : damage.code,
                              .start = name,
                              .step = 0,
                              .words = failed ? "on " + planted + " its validator " + child.failure
                                              : "its validator passes " + planted,
                              .script = {},
                              .laws = false,
                              .log = kernel::FlipLog{start, {}}};
        if (report.find(finding.code) == nullptr) report.findings.push_back(std::move(finding));
        return child.timed_out;
    }
    return false;
}

}  // namespace tightflip::properties
