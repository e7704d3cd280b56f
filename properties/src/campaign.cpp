#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/campaign.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/generators.hpp>
#include <tightflip/properties/invariants.hpp>
#include <tightflip/properties/shrink.hpp>

#include <algorithm>

namespace tightflip::properties {
namespace {

using kernel::FlipLog;
using kernel::RandomStream;

struct Failing {
    Triangulation start;
    FlipScript script;
    Finding finding;
};

/// The script cut to what still fails. Scripts are judged without audits in between: a broken
/// surface stays broken, and what only an audit sees is seen at the end.
Failing shrunk(Triangulation start, FlipScript script) {
    constexpr std::size_t most_calls = 3000;
    script = shrink(
        std::move(script),
        [&](std::span<const Edge> s) { return topology_is_preserved(start, s, 0).has_value(); },
        most_calls);
    Finding finding = topology_is_preserved(start, script, 0).value();
    return {std::move(start), std::move(script), std::move(finding)};
}

/// The same fault on the smallest surface of the genus on which short random scripts show it.
std::optional<Failing> small_failure(Index genus) {
    constexpr Index sizes = 6;
    constexpr int tries = 40;
    constexpr std::size_t length = 64;
    const Index least = genus == 0 ? 4 : 3;
    for (Index vertices = least; vertices < least + sizes; ++vertices) {
        const Triangulation start = kernel::families::surface_of_genus(genus, vertices, 0);
        RandomStream random(static_cast<std::uint64_t>(vertices));
        for (int k = 0; k < tries; ++k) {
            FlipScript script = random_script(start, length, random);
            const auto finding = topology_is_preserved(start, script);
            if (!finding) continue;
            script.resize(finding->step);
            return shrunk(start, std::move(script));
        }
    }
    return std::nullopt;
}

/// One campaign under way. What came after the last good audit is not kept but made again from the
/// random stream when it is needed.
class Campaign {
public:
    Campaign(const Triangulation& start, const CampaignOptions& options)
        : options_(options),
          audit_every_(options.audit_every != 0
                           ? options.audit_every
                           : 32 * static_cast<std::uint64_t>(start.edge_count())),
          edges_(static_cast<std::uint32_t>(start.edge_count())),
          topology_(audit(start).topology),
          surface_(start),
          random_(options.seed),
          good_surface_(start),
          good_random_(random_) {}

    CampaignReport run() {
        audit_now();
        while (!report_.failure && report_.attempted < options_.flips && !is_stopped()) {
            run_block(std::min({options_.flips - report_.attempted, audit_every_ - since_good_,
                                std::uint64_t{block}}));
            if (!report_.failure && since_good_ == audit_every_) audit_now();
        }
        if (!report_.failure && since_good_ != 0) audit_now();
        report_.seconds = seconds();
        return std::move(report_);
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::uint64_t block = 1U << 16;  // attempts between looks at the clock

    Edge draw(RandomStream& random) const { return {static_cast<Index>(random.below(edges_))}; }

    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(Clock::now() - began_).count();
    }

    bool is_stopped() {
        const double elapsed = seconds();
        if (options_.progress) options_.progress({report_.attempted, options_.flips, elapsed});
        report_.stopped_early = (options_.time_limit && elapsed >= options_.time_limit->count()) ||
                                (options_.interrupted && options_.interrupted());
        return report_.stopped_early;
    }

    void run_block(std::uint64_t attempts) {
        for (std::uint64_t k = 0; k < attempts; ++k) {
            const Edge e = draw(random_);
            const CheckedFlip step = checked_flip(surface_, e);
            ++report_.attempted;
            ++since_good_;
            ++(step.done ? report_.done : report_.refused);
            if (step.code) return fail(explain(surface_, e, *step.code));
        }
    }

    void audit_now() {
        ++report_.audits;
        if (auto violation = first_violation(surface_, topology_)) {
            return fail(*std::move(violation));
        }
        good_surface_ = surface_;
        good_random_ = random_;
        since_good_ = 0;
    }

    void fail(Violation violation) {
        FlipScript script(since_good_);
        RandomStream random = good_random_;
        for (Edge& e : script)
            e = draw(random);
        Failing failing{good_surface_, std::move(script), {since_good_, violation}};
        if (topology_is_preserved(failing.start, failing.script, 0)) {
            failing = shrunk(std::move(failing.start), std::move(failing.script));
        }
        if (auto small = small_failure(surface_.genus());
            small && small->start.edge_count() <= failing.start.edge_count()) {
            failing = *std::move(small);
        }
        report_.failure =
            CampaignFailure{std::move(violation), report_.attempted,
                            FlipLog{std::move(failing.start), std::move(failing.script)},
                            std::move(failing.finding)};
    }

    const CampaignOptions& options_;
    std::uint64_t audit_every_;
    std::uint32_t edges_;
    Topology topology_;
    Triangulation surface_;
    RandomStream random_;
    Triangulation good_surface_;  // the last that passed a full audit, and the stream from there
    RandomStream good_random_;
    std::uint64_t since_good_ = 0;
    Clock::time_point began_ = Clock::now();
    CampaignReport report_;
};

}  // namespace

CampaignReport run_campaign(const Triangulation& start, const CampaignOptions& options) {
    return Campaign(start, options).run();
}

}  // namespace tightflip::properties
