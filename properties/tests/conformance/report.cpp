// Prints the table of docs/conformance.md and the findings behind it.
#include "kernels.hpp"
#include <tightflip/properties/conformance.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <iostream>

int main() {
    using namespace tightflip::properties;
    std::vector<KernelReport> reports;
    for (const KernelDescription& kernel : all_kernels()) {
        std::cerr << kernel.name << ", judged as " << name(kernel.allowed) << '\n';
        reports.push_back(test_kernel(kernel));
    }
    write_markdown(std::cout, reports);
    for (const KernelReport& report : reports) {
        std::cout << "\n### " << report.kernel << ", judged as " << name(report.allowed) << "\n\n"
                  << report.flips() << " flips done, " << report.planted << " faults planted.\n";
        for (const KernelFinding& finding : report.findings) {
            std::cout << "\n- " << describe(finding) << "\n";
            if (finding.script.empty()) continue;
            std::cout << "\n  ```text\n";
            write_in_words(std::cout, *finding.log);
            std::cout << "  ```\n";
        }
    }
}
