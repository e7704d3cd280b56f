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

    /// Redraws at most ten times a second.
    void show(std::uint64_t done, std::uint64_t total, double seconds);

private:
    std::string title_;
    bool is_terminal_;
    double shown_at_ = -1;
};

}  // namespace tightflip::tools
