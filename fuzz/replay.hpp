/// \file
/// Runs a target on inputs from files and on its own seeds, without a fuzzer.
#pragma once

#include "target.hpp"

#include <filesystem>

namespace tightflip::fuzz {

/// What was replayed.
struct ReplaySummary {
    std::size_t inputs = 0;
    std::size_t broken = 0;   ///< inputs that break a claim
    std::size_t skipped = 0;  ///< what is no regular file, cannot be read, or is of another version
};

class Replayer {
public:
    /// Reports what breaks a claim, and with `verbose` every input, to `out`; what was skipped, and
    /// why, to `errors`.
    Replayer(const Target& target, std::ostream& out, std::ostream& errors, bool verbose = false)
        : target_(target), out_(out), errors_(errors), verbose_(verbose) {}

    void replay_seeds();
    /// A file, or the files of a directory and of those in it, in the order of their names. Links
    /// to directories are not followed.
    void replay_path(const std::filesystem::path& path);

    [[nodiscard]] const ReplaySummary& summary() const noexcept { return summary_; }

private:
    void replay(const std::string& name, Input input);
    void replay_file(const std::filesystem::path& path);
    void skip(const std::string& name, std::string_view reason);

    const Target& target_;
    std::ostream& out_;
    std::ostream& errors_;
    bool verbose_;
    ReplaySummary summary_;
};

/// One line: "12 inputs, every claim held" and the like.
[[nodiscard]] std::string describe(const ReplaySummary& summary);

/// What is said of an input that is not of this version.
[[nodiscard]] std::string other_version();

/// The bytes of a file. Throws kernel::FileError for one that cannot be read.
[[nodiscard]] InputBytes read_input(const std::filesystem::path& path);
/// Writes a file as a whole or not at all. Throws kernel::FileError.
void write_input(const std::filesystem::path& path, Input input);

}  // namespace tightflip::fuzz
