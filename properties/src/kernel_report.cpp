#include <tightflip/properties/kernel_report.hpp>

#include <algorithm>
#include <ostream>

namespace tightflip::properties {
namespace {

bool is_in_question(std::span<const KernelFinding> findings, KernelProperty property) {
    return std::ranges::any_of(findings, [&](const KernelFinding& finding) {
        return property_of(finding.code) == property;
    });
}

}  // namespace

std::string describe(const KernelFinding& finding) {
    std::string text = std::to_string(static_cast<int>(finding.code)) + " " +
                       std::string(name(finding.code)) +
                       (finding.start.empty() ? "" : ", " + finding.start) + ", step " +
                       std::to_string(finding.step) + ": " + finding.words;
    if (finding.script.empty()) return text;
    text += "; script";
    for (const Edge e : finding.script)
        text += " " + std::to_string(e.id);
    if (finding.laws) text += ", each flip taken back and repeated";
    return text;
}

std::size_t KernelReport::flips() const noexcept {
    return asked[static_cast<std::size_t>(KernelProperty::survival)];
}

bool KernelReport::was_asked(KernelProperty property) const noexcept {
    return asked[static_cast<std::size_t>(property)] > 0 || is_in_question(findings, property);
}

bool KernelReport::holds(KernelProperty property) const noexcept {
    return was_asked(property) && !is_in_question(findings, property);
}

const KernelFinding* KernelReport::find(KernelCode code) const noexcept {
    const auto found = std::ranges::find(findings, code, &KernelFinding::code);
    return found == findings.end() ? nullptr : &*found;
}

void write_markdown(std::ostream& out, std::span<const KernelReport> reports) {
    out << "| kernel | judged as |";
    for (const KernelProperty property : all_kernel_properties())
        out << ' ' << name(property) << " |";
    out << "\n|---|---|";
    for (std::size_t i = 0; i < all_kernel_properties().size(); ++i)
        out << "---|";
    out << '\n';
    for (const KernelReport& report : reports) {
        out << "| " << report.kernel << " | " << name(report.allowed) << " |";
        for (const KernelProperty property : all_kernel_properties()) {
            std::string cell;
            for (const KernelFinding& finding : report.findings) {
                if (property_of(finding.code) != property) continue;
                cell += (cell.empty() ? "" : ", ") + std::to_string(static_cast<int>(finding.code));
            }
            if (cell.empty()) cell = report.was_asked(property) ? "holds" : "not asked";
            out << ' ' << cell << " |";
        }
        out << '\n';
    }
}

}  // namespace tightflip::properties
