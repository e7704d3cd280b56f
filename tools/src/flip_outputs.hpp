/// \file
/// What a verb that flips leaves behind: the surface at the end, and the log of the way there.
#pragma once

#include <tightflip/kernel/flip_log.hpp>

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace tightflip::tools {

/// Names that may be empty: then nothing is written there.
struct FlipOutputs {
    std::string surface;
    std::string log;
    bool binary = false;

    /// Writes both files or, where one cannot be written, neither.
    void write(const kernel::FlipLogView& flips,
               const std::function<void(const std::string& file)>& write_surface) const;
};

/// A name given to an option.
struct NamedFile {
    std::string option;
    std::string file;
};

/// Throws CLI::ValidationError, naming both options, where two lead to one file, existing or not.
/// Empty names stand for options that were not given.
void require_distinct(const std::vector<NamedFile>& files);

}  // namespace tightflip::tools
