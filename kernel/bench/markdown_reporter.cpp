#include "markdown_reporter.hpp"

#include <algorithm>
#include <iomanip>
#include <tuple>

namespace tightflip::kernel::bench {

bool MarkdownReporter::ReportContext(const Context& context) {
    PrintBasicContext(&GetErrorStream(), context);
    return true;
}

void MarkdownReporter::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        const bool is_result = run.run_type == Run::RT_Aggregate ? run.aggregate_name == "median"
                                                                 : run.repetitions == 1;
        if (!is_result || run.error_occurred) continue;
        const std::string& name = run.run_name.function_name;
        const auto cut = name.find('/', name.find(" vertices"));
        const auto counter = [&](const char* key, double otherwise) {
            const auto found = run.counters.find(key);
            return found == run.counters.end() ? otherwise : found->second.value;
        };
        const bool is_memory = run.counters.contains("bytes");
        lines_.push_back({.group = name.substr(0, cut),
                          .label = name.substr(cut + 1),
                          .order = static_cast<std::size_t>(run.family_index),
                          .value = is_memory ? counter("bytes", 0) : 1e9 * counter("time", 0),
                          .unit = is_memory ? "bytes" : "ns",
                          .done = counter("done", 1)});
    }
}

void MarkdownReporter::Finalize() {
    std::ranges::sort(lines_, {}, &Line::order);
    std::ranges::stable_sort(lines_, {}, &Line::group);
    std::ostream& out = GetOutputStream();
    const Line* first = nullptr;
    for (const Line& line : lines_) {
        if (first == nullptr || first->group != line.group) {
            first = &line;
            out << "\n| " << line.group << " | " << line.unit
                << " | ratio | done |\n|---|---:|---:|---:|\n";
        }
        out << "| " << line.label << " | " << std::fixed << std::setprecision(1) << line.value
            << " | " << std::setprecision(2) << line.value / first->value << " | "
            << std::setprecision(0) << 100 * line.done << " % |\n";
    }
}

}  // namespace tightflip::kernel::bench
