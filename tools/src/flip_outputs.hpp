/// \file
/// What a verb that flips leaves behind: the surface at the end, and the log of the way there.
#pragma once

#include <tightflip/kernel/flip_log.hpp>

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

namespace tightflip::tools {

/// Names that may be empty: then nothing is written there.
struct FlipOutputs {
    std::string surface;
    std::string log;
    bool binary = false;

    /// Throws CLI::ValidationError where both names lead to one file.
    void require_distinct() const;
    /// Writes both files or, where one cannot be written, neither.
    void write(const kernel::FlipLogView& flips,
               const std::function<void(const std::string& file)>& write_surface) const;
};

/// Whether two names lead to one file, existing or not.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

}  // namespace tightflip::tools
