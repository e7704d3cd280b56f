/// \file
/// Long random flip sequences under audit: the check of Theorem 4.2 that runs for a week.
#pragma once

#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/finding.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

namespace tightflip::properties {

struct CampaignProgress {
    std::uint64_t attempted = 0;
    std::uint64_t total = 0;
    double seconds = 0;
};

struct CampaignOptions {
    std::uint64_t flips = 1'000'000;  ///< attempts; a refused flip is one
    std::uint64_t seed = 0;
    /// A full audit after that many attempts, besides one at each end; 0: 32 times the number of
    /// edges, so that audits cost a few per cent of the run. At most 2^26.
    std::uint64_t audit_every = 0;
    std::optional<std::chrono::duration<double>> time_limit{};
    /// Asked now and then; true stops the campaign, undecided.
    std::function<bool()> interrupted{};
    /// Called now and then.
    std::function<void(const CampaignProgress&)> progress{};
};

/// A violation, made small.
struct CampaignFailure {
    Violation violation;        ///< as the campaign met it
    std::uint64_t attempt = 0;  ///< after which it was seen, counted from 1
    kernel::FlipLog log;        ///< replaying it under checks shows `shrunk`
    Finding shrunk;             ///< what the shrunk script shows
};

struct CampaignReport {
    std::uint64_t attempted = 0;
    std::uint64_t done = 0;
    std::uint64_t refused = 0;
    std::uint64_t audits = 0;    ///< full ones; every attempt is also checked in constant time
    bool stopped_early = false;  ///< by the time limit or an interrupt, with no violation
    double seconds = 0;
    std::optional<CampaignFailure> failure;
};

/// Flips random edges of `start` under `checked_flip`, with full audits in between, until all
/// attempts are made, a violation is found or it is stopped. The audits at the ends climb the whole
/// ladder, those in between ask the quick judge first. Constant time an attempt and linear time an
/// audit; memory: two copies of the surface and the audit's scratch, whatever the number of flips;
/// on a violation also the script since the last good audit, 4 bytes an attempt.
///
/// A violation is made small: where the same kernel fails on a small surface of the same genus too,
/// the log starts from that one, else from the last surface that passed an audit; its script is
/// then shrunk, until `interrupted` says to stop.
[[nodiscard]] CampaignReport run_campaign(const Triangulation& start,
                                          const CampaignOptions& options);

}  // namespace tightflip::properties
