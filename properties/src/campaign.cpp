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
Failing shrunk(Triangulation start, FlipScript script, const std::function<bool()>& interrupted) {
    constexpr std::size_t most_calls = 3000;
    script = shrink(
        std::move(script),
        [&](std::span<const Edge> s) {
            const bool give_up = interrupted && interrupted();
            return !give_up && topology_is_preserved(start, s, 0).has_value();
        },
        most_calls);
    Finding finding = topology_is_preserved(start, script, 0).value();
    return {std::move(start), std::move(script), std::move(finding)};
}

/// The same fault on the smallest surface of the genus on which short random scripts show it.
std::optional<Failing> small_failure(Index genus, const std::function<bool()>& interrupted) {
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
            return shrunk(start, std::move(script), interrupted);
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
          audit_every_(std::min(options.audit_every != 0
                                    ? options.audit_every
                                    : 32 * static_cast<std::uint64_t>(start.edge_count()),
                                most_between_audits)),
          edges_(static_cast<std::uint32_t>(start.edge_count())),
          topology_(audit(start).topology),
          surface_(start),
          random_(options.seed),
          good_surface_(start),
          good_random_(random_) {}

    CampaignReport run() {
        audit_now(first_violation);
        while (!report_.failure && report_.attempted < options_.flips && !is_stopped()) {
            run_block(std::min({options_.flips - report_.attempted, audit_every_ - since_good_,
                                std::uint64_t{block}}));
            if (!report_.failure && since_good_ == audit_every_ &&
                report_.attempted < options_.flips) {
                audit_now(first_violation_quickly);
            }
        }
        if (!report_.failure && !end_is_audited_) audit_now(first_violation);
        report_.seconds = seconds();
        return std::move(report_);
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::uint64_t block = 1U << 16;  // attempts between looks at the clock
    // What came since the last good audit must fit into memory as a script.
    static constexpr std::uint64_t most_between_audits = std::uint64_t{1} << 26;

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
        end_is_audited_ = false;
        for (std::uint64_t k = 0; k < attempts; ++k) {
            const Edge e = draw(random_);
            const CheckedFlip step = checked_flip(surface_, e);
            ++report_.attempted;
            ++since_good_;
            ++(step.done ? report_.done : report_.refused);
            if (step.code) return fail(explain(surface_, e, *step.code));
        }
    }

    void audit_now(decltype(first_violation)& judge) {
        ++report_.audits;
        end_is_audited_ = &judge == &first_violation;
        if (auto violation = judge(surface_, topology_)) {
            return fail(*std::move(violation));
        }
        good_surface_ = surface_;
        good_random_ = random_;
        since_good_ = 0;
    }

    void fail(Violation violation) {
        report_.stopped_early = false;
        Failing failing = made_small(violation);
        report_.failure =
            CampaignFailure{std::move(violation), report_.attempted,
                            FlipLog{std::move(failing.start), std::move(failing.script)},
                            std::move(failing.finding)};
    }

    /// The fault on a small surface where it shows there, else what came since the last good audit,
    /// shrunk where that fails again.
    [[nodiscard]] Failing made_small(const Violation& violation) const {
        if (auto small = small_failure(surface_.genus(), options_.interrupted);
            small && small->start.edge_count() <= surface_.edge_count()) {
            return *std::move(small);
        }
        FlipScript script(since_good_);
        RandomStream random = good_random_;
        for (Edge& e : script)
            e = draw(random);
        if (!topology_is_preserved(good_surface_, script, 0)) {
            return {good_surface_, std::move(script), {since_good_, violation}};
        }
        return shrunk(good_surface_, std::move(script), options_.interrupted);
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
    bool end_is_audited_ = false;  // the whole ladder was climbed after the last attempt
    Clock::time_point began_ = Clock::now();
    CampaignReport report_;
};

}  // namespace

CampaignReport run_campaign(const Triangulation& start, const CampaignOptions& options) {
    return Campaign(start, options).run();
}

}  // namespace tightflip::properties
