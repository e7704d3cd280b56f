#include "replay.hpp"

#include <tightflip/kernel/file_io.hpp>

#include <algorithm>
#include <ostream>

namespace tightflip::fuzz {

namespace fs = std::filesystem;

void Replayer::replay_seeds() {
    for (const auto& [name, bytes] : target_.seeds())
        replay("seed " + name, bytes);
}

void Replayer::replay_path(const fs::path& path) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
        replay_file(path);
        return;
    }
    std::vector<fs::path> files;
    for (fs::recursive_directory_iterator at(path, error), end; at != end && !error;
         at.increment(error)) {
        if (!fs::is_directory(at->symlink_status())) files.push_back(at->path());
    }
    if (error) skip(path.string(), error.message());
    std::ranges::sort(files);
    for (const fs::path& file : files)
        replay_file(file);
}

void Replayer::replay(const std::string& name, Input input) {
    ++summary_.inputs;
    const std::string objected = objection(target_, input);
    if (verbose_ || !objected.empty()) {
        out_ << name << ": ";
        target_.show(out_, input);
    }
    if (objected.empty()) return;
    ++summary_.broken;
    out_ << name << ": " << objected << "\n";
}

void Replayer::replay_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) {  // a pipe would be waited for
        skip(path.string(), "is no regular file");
        return;
    }
    try {
        const InputBytes input = read_input(path);
        if (is_of_this_version(target_.layout, input)) {
            replay(path.string(), input);
        } else {
            skip(path.string(), other_version());
        }
    } catch (const kernel::FileError& unreadable) {
        skip(path.string(), unreadable.reason());
    }
}

void Replayer::skip(const std::string& name, std::string_view reason) {
    ++summary_.skipped;
    errors_ << "skipped " << name << ": " << reason << "\n";
}

std::string describe(const ReplaySummary& summary) {
    std::string text = std::to_string(summary.inputs) + " inputs, ";
    text += summary.broken == 0 ? "every claim held"
                                : std::to_string(summary.broken) + " break a claim";
    if (summary.skipped > 0) text += ", " + std::to_string(summary.skipped) + " files skipped";
    return text;
}

std::string other_version() {
    return "of another version than " + std::to_string(format_version);
}

InputBytes read_input(const fs::path& path) {
    const std::string text = kernel::read_file(path);
    return {text.begin(), text.end()};
}

void write_input(const fs::path& path, Input input) {
    const std::string text(input.begin(), input.end());
    kernel::write_file(path, [&](std::ostream& out) {
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
    });
}

}  // namespace tightflip::fuzz
