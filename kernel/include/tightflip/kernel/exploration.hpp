/// \file
/// What every exhaustive run has in common: its limits, its progress, and how it stops.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

namespace tightflip::kernel {

/// How far a run has come.
struct ExplorationProgress {
    const char* stage = "";         ///< what is being done
    std::uint64_t done = 0;         ///< states expanded, or searches made
    std::uint64_t expected = 0;     ///< about how many there will be; 0 where nobody knows
    double seconds = 0;             ///< since this stage began, in this process
    std::uint64_t done_before = 0;  ///< of `done`, taken over from a checkpoint
};

struct ExplorationLimits {
    unsigned threads = 0;  ///< 0: as many as the machine runs at once
    std::uint64_t memory_bytes = ~std::uint64_t{0};
    /// A directory in which the state of the run is kept from time to time, and from which a run
    /// with the same parameters goes on; none where empty.
    std::filesystem::path checkpoint_directory;
    double checkpoint_seconds = 5;  ///< at least so long between two checkpoints
    std::function<void(const ExplorationProgress&)> progress;
    std::function<bool()> interrupted;  ///< asked often, on several threads at once
};

/// A run that came to no end, for a reason in plain words. What a checkpoint holds stays there.
class ExplorationStopped : public std::runtime_error {
public:
    enum class Reason : std::uint8_t { memory, interrupted };

    ExplorationStopped(Reason reason, const std::string& words)
        : std::runtime_error(words), reason_(reason) {}
    [[nodiscard]] Reason reason() const noexcept { return reason_; }

private:
    Reason reason_;
};

}  // namespace tightflip::kernel
