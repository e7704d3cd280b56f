#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/kernel_report.hpp>

#include <algorithm>
#include <cctype>
#include <ostream>

namespace tightflip::properties {

std::string describe(const KernelFinding& finding) {
    std::string text = std::to_string(static_cast<int>(finding.code)) + " " +
                       std::string(name(finding.code)) + ", " + finding.start + ", step " +
                       std::to_string(finding.step) + ": " + finding.words;
    if (finding.script.empty()) return text;
    text += "; script";
    for (const Edge e : finding.script)
        text += " " + std::to_string(e.id);
    return text;
}

bool KernelReport::was_asked(KernelProperty property) const noexcept {
    return std::ranges::find(asked, property) != asked.end();
}

bool KernelReport::holds(KernelProperty property) const noexcept {
    return std::ranges::none_of(findings, [&](const KernelFinding& finding) {
        return property_of(finding.code) == property;
    });
}

const KernelFinding* KernelReport::find(KernelCode code) const noexcept {
    const auto found = std::ranges::find(findings, code, &KernelFinding::code);
    return found == findings.end() ? nullptr : &*found;
}

std::filesystem::path write_log(const std::filesystem::path& directory, const std::string& kernel,
                                const KernelFinding& finding) {
    std::string stem;
    for (const char c : kernel + "_" + std::string(name(finding.code)))
        stem += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    auto path = directory / (stem + ".flips");
    kernel::write_file(path, [&](std::ostream& out) { write_text(out, *finding.log); });
    return path;
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
