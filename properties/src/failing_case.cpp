#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/failing_case.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace tightflip::properties {
namespace {

/// As part of a file's name.
std::string tame(std::string_view name) {
    constexpr std::string_view allowed =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
    std::string tamed(name);
    std::ranges::replace_if(
        tamed, [&](char c) { return allowed.find(c) == std::string_view::npos; }, '-');
    return tamed;
}

/// The directory for failing cases.
std::filesystem::path failures_directory() {
    const char* const named = std::getenv(failures_directory_variable);
    return named != nullptr && *named != '\0' ? named : ".";
}

/// Makes the directory if there is none.
void make(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) throw kernel::FileError(directory.string(), "cannot be made: " + error.message());
}

}  // namespace

std::string in_words(const FailingCase& failing) {
    std::ostringstream words;
    words.precision(std::numeric_limits<double>::max_digits10);
    words << failing.finding << '\n';
    for (std::size_t v = 0; v < failing.points.size(); ++v) {
        const geometry::Point& point = failing.points[v];
        words << "vertex " << v << " at " << point.x() << ' ' << point.y() << ' ' << point.z()
              << '\n';
    }
    write_in_words(words, failing.log);
    return words.str();
}

std::filesystem::path write_failing_case(std::string_view name, const FailingCase& failing) {
    const std::filesystem::path directory = failures_directory();
    make(directory);
    const auto path = directory / tame(name);
    const auto with = [&](const char* ending) {
        return std::filesystem::path(path.string() + ending);
    };
    if (!failing.points.empty()) {
        const geometry::Surface start(failing.log.start, failing.points);
        kernel::write_file(with(".surface"),
                           [&](std::ostream& out) { write_text(out, start.view()); });
    }
    kernel::write_file(with(".flips"), [&](std::ostream& out) { write_text(out, failing.log); });
    return with(".flips");
}

std::string written_and_in_words(std::string_view name, const FailingCase& failing) {
    std::string text = in_words(failing);
    try {
        text += "written to " + write_failing_case(name, failing).string();
    } catch (const kernel::FileError& error) {
        text += std::string("not written: ") + error.what();
    }
    return text;
}

}  // namespace tightflip::properties
