/// \file
/// What the limits of one optimisation leave for its stages.
#pragma once

#include <tightflip/geometry/optimise.hpp>

#include <algorithm>

namespace tightflip::geometry {

class Effort {
public:
    Effort(const OptimiseOptions& options, const Energy& energy)
        : options_(options), least_(energy) {}

    /// Why no more may be done; empty while it may.
    [[nodiscard]] std::optional<OptimiseEnd> end() const noexcept { return end_; }
    void stop(OptimiseEnd end) noexcept { end_ = end; }

    /// The wanted criterion has been brought down to this, if it is the least so far.
    void reached(const Energy& energy) { least_ = std::min(least_, energy); }
    /// To be called for each flip made; false stops.
    bool made_flip() {
        ++flips_;
        return may_go_on();
    }
    /// Asks who watches; false stops.
    bool may_go_on() {
        if (options_.keep_going && !options_.keep_going(flips_, least_)) stop(OptimiseEnd::stopped);
        return !end_;
    }
    /// Whether so many flips more are allowed; notes the limit where they are not.
    bool has_flips(std::int64_t count) {
        if (!end_ && count > options_.max_flips - flips_) end_ = OptimiseEnd::flip_limit;
        return !end_;
    }
    /// Looks at the clock now and then only.
    bool has_time() {
        if (!end_ && ++looks_ % looks_per_clock == 0 && time_left().count() < 0) {
            end_ = OptimiseEnd::time_limit;
        }
        return !end_;
    }

    /// The options with what is left of the limits.
    [[nodiscard]] OptimiseOptions rest() const {
        OptimiseOptions rest = options_;
        rest.max_flips = options_.max_flips - flips_;
        rest.max_time = time_left();
        return rest;
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::int64_t looks_per_clock = 16;

    [[nodiscard]] std::chrono::duration<double> time_left() const {
        return options_.max_time - std::chrono::duration<double>(Clock::now() - begin_);
    }

    const OptimiseOptions& options_;
    Energy least_;
    std::int64_t flips_ = 0;
    std::int64_t looks_ = 0;
    std::optional<OptimiseEnd> end_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace tightflip::geometry
