#include "isolated_script.hpp"

#include "script_watch.hpp"
#include <tightflip/properties/child_process.hpp>

#include <algorithm>
#include <sstream>

namespace tightflip::properties {
namespace {

/// Lines "at STEP FLIPS LAST-FLIP QUESTIONS..." say how far a run has come, and "found CODE WORDS"
/// what showed there.
class RunWriter {
public:
    explicit RunWriter(const ChildOutput& write) : write_(write) {}

    void operator()(const ScriptRun& run) {
        std::ostringstream lines;
        lines << "at " << run.step << ' ' << run.flips.size() << ' '
              << (run.flips.empty() ? -1 : run.flips.back().id);
        for (const std::size_t times : run.asked)
            lines << ' ' << times;
        lines << '\n';
        for (; written_ < run.findings.size(); ++written_) {
            const KernelFinding& finding = run.findings[written_];
            std::string words = finding.words;
            std::ranges::replace(words, '\n', ' ');
            lines << "found " << static_cast<int>(finding.code) << ' ' << words << '\n';
        }
        write_(lines.str());
    }

private:
    const ChildOutput& write_;
    std::size_t written_ = 0;  // findings
};

void read_progress(std::istream& in, ScriptRun& run) {
    std::size_t flips = 0;
    Edge last{};
    in >> run.step >> flips >> last.id;
    for (std::size_t& times : run.asked)
        in >> times;
    // Every flip was told of when it was the last.
    run.flips.resize(flips);
    if (flips > 0) run.flips.back() = last;
}

}  // namespace

ScriptRun run_isolated(const KernelDescription& kernel, const Triangulation& start,
                       std::span<const Edge> script, bool laws, const ConformanceOptions& options) {
    const auto watch = [&](const ChildOutput& write) {
        static_cast<void>(watch_script(kernel, start, script, laws, RunWriter(write)));
    };
    const ChildResult child =
        options.isolate ? run_in_child(watch, options.seconds) : run_here(watch);
    ScriptRun run;
    const auto add = [&](KernelCode code, std::string words) {
        run.findings.push_back(finding_at(code, std::move(words), run, start, script, laws));
    };
    std::istringstream in(child.output);
    for (std::string kind; in >> kind;) {
        if (kind == "at") {
            read_progress(in, run);
            continue;
        }
        int code = 0;
        std::string words;
        in >> code;
        in.get();
        std::getline(in, words);
        add(static_cast<KernelCode>(code), std::move(words));
    }
    run.timed_out = child.timed_out;
    if (!child.failure.empty()) add(KernelCode::crashed_or_hung, "the kernel " + child.failure);
    return run;
}

}  // namespace tightflip::properties
