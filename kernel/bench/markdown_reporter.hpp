/// \file
/// Shows the medians as Markdown tables, one a group, each line as a ratio to the group's first.
#pragma once

#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace tightflip::kernel::bench {

/// A benchmark's name is `group/size/line`; its value is the counter `time` (seconds) or `bytes`.
class MarkdownReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

private:
    struct Line {
        std::string group;
        std::string label;
        std::size_t order;  // as registered
        double value;
        std::string unit;
        double done;
    };
    std::vector<Line> lines_;
};

}  // namespace tightflip::kernel::bench
