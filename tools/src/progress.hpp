/// \file
/// A progress bar on standard error, where that is a terminal.
#pragma once

#include <cstdint>
#include <string>

namespace tightflip::tools {

class ProgressBar {
public:
    explicit ProgressBar(std::string title);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    struct State {
        std::uint64_t done = 0;
        std::uint64_t total = 0;  ///< 0 where nobody knows
        double seconds = 0;
        std::uint64_t done_before = 0;  ///< of `done`, not done in these seconds
        std::string note{};             ///< shown at the end of the line
    };
    /// Redraws at most ten times a second: how much is done, how fast, how long it will take.
    void show(const State& state);

private:
    std::string title_;
    bool is_terminal_;
    double shown_at_ = -1;
};

}  // namespace tightflip::tools
