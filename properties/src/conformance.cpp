#include "isolated_script.hpp"
#include "planted_damage.hpp"
#include "script_watch.hpp"
#include <tightflip/kernel/audit.hpp>
#include <tightflip/properties/conformance.hpp>
#include <tightflip/properties/generators.hpp>
#include <tightflip/properties/shrink.hpp>

#include <algorithm>
#include <array>
#include <functional>

namespace tightflip::properties {
namespace {

struct Start {
    std::string name;
    Triangulation surface;
};

/// Small before large, simple before not.
std::vector<Start> starts_for(const KernelDescription& kernel, std::uint64_t seed) {
    struct Wanted {
        std::string_view kind;
        StartRequest request;
    };
    const std::array wanted{
        Wanted{"tetrahedron", {.vertices = 4}},
        Wanted{"double-wheel", {.vertices = 5}},
        Wanted{"octasphere", {.vertices = 6}},
        Wanted{"stacked", {.vertices = 7, .seed = seed}},
        Wanted{"stacked", {.vertices = 12, .seed = seed + 1}},
        Wanted{"torus", {.vertices = 9}},
        Wanted{"book", {.vertices = 4}},
        Wanted{"book", {.vertices = 6}},
        Wanted{"random", {.vertices = 6, .genus = 1, .seed = seed}},
        Wanted{"random", {.vertices = 8, .genus = 2, .seed = seed}},
    };
    std::vector<Start> starts;
    for (const auto& [kind, request] : wanted) {
        Start start{std::string(kind) + " V=" + std::to_string(request.vertices),
                    make_nearest(*find_start_kind(kind), request)};
        if (request.genus > 0) start.name += " genus " + std::to_string(request.genus);
        if (!kernel.can_start(audit(start.surface).is_simple().value_or(false))) continue;
        starts.push_back(std::move(start));
    }
    return starts;
}

/// A script to run, and whether every flip is taken back and repeated.
struct Trial {
    FlipScript script;
    bool laws;
};

/// Random scripts; where every pair is wanted, all of two flips first.
std::vector<Trial> trials_from(const Start& start, bool every_pair,
                               const ConformanceOptions& options, kernel::RandomStream& random) {
    std::vector<Trial> trials;
    const Index edges = every_pair ? start.surface.edge_count() : 0;
    for (Index first = 0; first < edges; ++first) {
        for (Index second = 0; second < edges; ++second)
            trials.push_back({{Edge{first}, Edge{second}}, false});
    }
    for (std::size_t n = 0; n < 2 * options.scripts; ++n)
        trials.push_back({random_script(start.surface, options.flips, random), n % 2 != 0});
    return trials;
}

/// The finding with a script from which nothing can be left out, without the laws' repetitions
/// where it shows without them.
KernelFinding shrunk(const KernelDescription& kernel, const Start& start, KernelFinding finding,
                     bool laws, const ConformanceOptions& options) {
    const auto again = [&](std::span<const Edge> script) -> std::optional<KernelFinding> {
        for (KernelFinding& found :
             run_isolated(kernel, start.surface, script, laws, options).findings) {
            if (found.code == finding.code) return std::move(found);
        }
        return std::nullopt;
    };
    const auto fails = [&](std::span<const Edge> script) { return again(script).has_value(); };
    if (laws) {
        laws = false;
        if (fails(finding.log->flips)) {
            finding.script = finding.log->flips;
        } else {
            laws = true;
        }
    }
    const std::size_t calls = finding.code == KernelCode::crashed_or_hung ? 50 : 500;
    if (auto shortest = again(shrink(finding.script, fails, calls))) finding = std::move(*shortest);
    finding.start = start.name;
    return finding;
}

}  // namespace

ScriptRun run_script(const KernelDescription& kernel, const Triangulation& start,
                     std::span<const Edge> script, bool laws) {
    return watch_script(kernel, start, script, laws, {});
}

KernelReport test_kernel(const KernelDescription& kernel, const ConformanceOptions& options) {
    KernelReport report{.kernel = kernel.name, .allowed = kernel.allowed, .findings = {}};
    const std::vector<Start> starts = starts_for(kernel, options.seed);
    kernel::RandomStream random(options.seed);
    std::size_t hangs = 0;
    for (const Start& start : starts) {
        for (const auto& [script, laws] :
             trials_from(start, &start == &starts.front(), options, random)) {
            if (hangs >= options.most_hangs) break;
            const ScriptRun run = run_isolated(kernel, start.surface, script, laws, options);
            std::ranges::transform(report.asked, run.asked, report.asked.begin(), std::plus());
            hangs += run.timed_out ? 1 : 0;
            for (const KernelFinding& finding : run.findings) {
                if (report.find(finding.code) != nullptr) continue;
                report.findings.push_back(shrunk(kernel, start, finding, laws, options));
            }
        }
    }
    const bool is_readable = report.asked[static_cast<std::size_t>(KernelProperty::reading)] > 0;
    hangs = 0;
    for (const Damage& damage : damages()) {
        if (!is_readable || hangs >= options.most_hangs) break;
        bool hung = false;
        for (std::size_t i = 0; i < 3 && !hung; ++i) {  // the smallest starts
            const auto& [name, start] = starts[i];
            hung = plant_damage(kernel, damage, name, start, options, report);
        }
        hangs += hung ? 1 : 0;
    }
    std::ranges::sort(report.findings, {}, &KernelFinding::code);
    return report;
}

}  // namespace tightflip::properties
