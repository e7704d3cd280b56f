#include "isolated_script.hpp"

#include "script_watch.hpp"
#include <tightflip/properties/child_process.hpp>

#include <algorithm>
#include <sstream>

namespace tightflip::properties {
namespace {

std::string packed(const KernelFinding& finding) {
    std::string text = std::to_string(static_cast<int>(finding.code)) + " " +
                       std::to_string(finding.step) + " " +
                       std::to_string(finding.log->flips.size());
    for (const Edge e : finding.log->flips)
        text += " " + std::to_string(e.id);
    text += " " + finding.words;
    std::ranges::replace(text, '\n', ' ');
    return text + "\n";
}

std::vector<KernelFinding> unpacked(const std::string& text, const Triangulation& start,
                                    std::span<const Edge> script) {
    std::istringstream in(text);
    std::vector<KernelFinding> findings;
    int code = 0;
    std::size_t flips = 0;
    KernelFinding finding;
    while (in >> code >> finding.step >> flips) {
        finding.code = static_cast<KernelCode>(code);
        finding.log = kernel::FlipLog{start, FlipScript(flips)};
        for (Edge& e : finding.log->flips)
            in >> e.id;
        in.get();
        std::getline(in, finding.words);
        const auto used = static_cast<std::ptrdiff_t>(std::min(finding.step, script.size()));
        finding.script.assign(script.begin(), script.begin() + used);
        findings.push_back(finding);
    }
    return findings;
}

KernelFinding crash(std::string words, const Triangulation& start, std::span<const Edge> script) {
    return {.code = KernelCode::crashed_or_hung,
            .start = {},
            .step = script.size(),
            .words = std::move(words),
            .script = FlipScript(script.begin(), script.end()),
            .log = kernel::FlipLog{start, FlipScript(script.begin(), script.end())}};
}

}  // namespace

ScriptRun run_isolated(const KernelDescription& kernel, const Triangulation& start,
                       std::span<const Edge> script, bool laws, const ConformanceOptions& options) {
    if (!options.isolate) return run_script(kernel, start, script, laws);
    const ChildResult child = run_in_child(
        [&](const ChildOutput& write) {
            static_cast<void>(
                watch_script(kernel, start, script, laws,
                             [&](const KernelFinding& finding) { write(packed(finding)); }));
        },
        options.seconds);
    ScriptRun run{.findings = unpacked(child.output, start, script), .timed_out = child.timed_out};
    if (!child.failure.empty()) {
        run.findings.push_back(crash("the kernel " + child.failure, start, script));
    }
    return run;
}

}  // namespace tightflip::properties
