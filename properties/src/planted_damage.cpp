#include "planted_damage.hpp"

#include "nth.hpp"
#include <tightflip/properties/child_process.hpp>

#include <array>

namespace tightflip::properties {
namespace {

constexpr std::array all_damages{
    Damage{PlantedFault::wrong_origin, KernelCode::wrong_origin_accepted, "origin",
           [](const SideTables& tables, Index side) {
               return (nth(tables.origin, side) + 1) % tables.vertex_count;
           }},
    Damage{PlantedFault::wrong_next, KernelCode::wrong_next_accepted, "next side",
           [](const SideTables& tables, Index side) {
               return nth(tables.across, nth(tables.next, side));
           }},
    Damage{PlantedFault::wrong_across, KernelCode::wrong_across_accepted, "side across",
           [](const SideTables& tables, Index side) {
               return nth(tables.across, nth(tables.next, side));
           }},
};

/// "" where nothing could be planted or the audit sees no harm; "rejected"; or what was accepted.
std::string plant_one(const KernelDescription& kernel, const Triangulation& start,
                      const Damage& damage, Index side) {
    const auto mesh = kernel.make(read_as_gluing(side_tables(start)).gluing);
    const Index wrong = damage.wrong(mesh->tables(), side);
    if (!mesh->plant(damage.fault, side, wrong)) return {};
    const Judgement judgement = judge(mesh->tables(), kernel.allowed);
    if (judgement.is_valid()) return {};
    if (!mesh->is_valid()) return "rejected";
    std::string words = "its validator passes side " + std::to_string(side) + " with a wrong " +
                        std::string(damage.words) + " (" + std::to_string(wrong) + "): ";
    return words + judgement.fault;
}

ChildResult plant_apart(const std::function<std::string()>& work,
                        const ConformanceOptions& options) {
    if (options.isolate) {
        return run_in_child([&](const ChildOutput& write) { write(work()); }, options.seconds);
    }
    try {
        return {.output = work(), .failure = {}, .timed_out = false};
    } catch (const std::exception& error) {
        return {.output = {}, .failure = std::string("threw: ") + error.what(), .timed_out = false};
    }
}

}  // namespace

std::span<const Damage> damages() noexcept {
    return all_damages;
}

bool plant_damage(const KernelDescription& kernel, const Damage& damage, const std::string& name,
                  const Triangulation& start, const ConformanceOptions& options,
                  KernelReport& report) {
    for (Index side = 0; side < start.halfedge_count(); ++side) {
        const ChildResult child =
            plant_apart([&] { return plant_one(kernel, start, damage, side); }, options);
        const bool failed = !child.failure.empty();
        if (!failed && child.output.empty()) continue;
        ++report.planted;
        if (!failed && child.output == "rejected") continue;
        KernelFinding finding{.code = failed ? KernelCode::crashed_or_hung_on_damage : damage.code,
                              .start = name,
                              .step = 0,
                              .words = child.output,
                              .script = {},
                              .log = kernel::FlipLog{start, {}}};
        if (failed) {
            finding.words = "with a planted wrong " + std::string(damage.words) + " at side " +
                            std::to_string(side) + " its validator " + child.failure;
        }
        if (report.find(finding.code) == nullptr) report.findings.push_back(std::move(finding));
        return child.timed_out;
    }
    return false;
}

}  // namespace tightflip::properties
