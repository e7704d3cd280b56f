/// \file
/// Reading whole files, and writing them so that nothing is ever half written.
#pragma once

#include <tightflip/kernel/file_error.hpp>

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace tightflip::kernel {

/// The bytes of a file. Throws FileError for a directory, a missing or unreadable file.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Lets `write` fill a temporary file beside `path`, then renames it to `path`. Where anything
/// fails (no permission, disk full, an exception from `write`) the temporary file is removed, what
/// stood at `path` stays as it was, and FileError or the exception is thrown. A symbolic link stays
/// one, and what it names is replaced; a device or pipe is written straight.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace tightflip::kernel
