// Exits 0 where the campaign catches the broken flip that this program was compiled with.

#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/campaign.hpp>
#include <tightflip/properties/claims.hpp>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace {

using namespace tightflip;

/// Whether a finding about the surface as it is, not about the flip, is one that the audit has too.
bool is_confirmed(const properties::Finding& finding, const kernel::FlipLog& log) {
    if (finding.violation.code >= kernel::ViolationCode::vertex_count_changed) return true;
    kernel::Triangulation surface = log.start;
    for (const kernel::Edge e : log.flips)
        static_cast<void>(surface.flip(e));
    const auto violations = audit(surface).violations;
    return std::ranges::find(violations, finding.violation) != violations.end();
}

/// Why the campaign on this start is not what it should be; empty where it is.
std::string shortcoming(const kernel::Triangulation& start) {
    constexpr std::size_t most_flips = 4;
    const auto report = properties::run_campaign(start, {.flips = 100'000, .seed = 1});
    if (!report.failure) return "the fault was not found";
    const auto& failure = *report.failure;
    std::cout << "attempt " << failure.attempt << ", a log of " << failure.log.flips.size()
              << " flips on " << failure.log.start.vertex_count() << " vertices; "
              << describe(failure.shrunk) << "\n";
    if (report.attempted != failure.attempt) return "the campaign went on after the fault";
    if (failure.log.flips.size() > most_flips) return "the log is too long";
    if (failure.log.start.genus() != start.genus()) return "the log starts elsewhere";

    std::ostringstream written;
    write_text(written, failure.log);
    const kernel::FlipLog log = kernel::parse_flip_log(written.str(), "log");
    const auto again = properties::topology_is_preserved(log.start, log.flips);
    if (!again) return "replaying the log does not show the fault";
    if (again->step != log.flips.size()) return "the log goes on after the fault";
    if (!is_confirmed(*again, log)) return "the audit does not say what the finding says";
    return {};
}

}  // namespace

int main() {
    bool all_caught = true;
    for (const kernel::Index genus : {0, 1, 2}) {
        const auto start = kernel::families::surface_of_genus(genus, 60, 3);
        const std::string reason = shortcoming(start);
        if (reason.empty()) continue;
        std::cout << "genus " << genus << ": " << reason << "\n";
        all_caught = false;
    }
    return all_caught ? 0 : 1;
}
