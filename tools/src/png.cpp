#include "png.hpp"

#include <tightflip/kernel/file_io.hpp>

#include <array>
#include <cerrno>
#include <filesystem>
#include <ostream>
#include <spawn.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX
#include <sys/wait.h>
#include <system_error>

// NOLINTNEXTLINE(readability-redundant-declaration): POSIX leaves declaring it to the program
extern char** environ;

namespace tightflip::tools {
namespace {

constexpr const char* converter = "rsvg-convert";

/// A directory of its own that goes with what is in it.
class TemporaryDirectory {
public:
    TemporaryDirectory() {
        std::string name = (std::filesystem::temp_directory_path() / "tightflip-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) {
            throw std::system_error(errno, std::generic_category(),
                                    "no directory for a picture can be made in " + name);
        }
        path_ = name;
    }
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
    ~TemporaryDirectory() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

/// Runs a program found on the path and waits for it; its exit status, or -1 where a signal ended
/// it. Throws where it cannot be started.
template <std::size_t n>
int run(std::array<std::string, n> arguments) {
    std::array<char*, n + 1> words{};
    for (std::size_t i = 0; i < n; ++i)
        words[i] = arguments[i].data();
    ::pid_t child = 0;
    const int error = ::posix_spawnp(&child, words[0], nullptr, nullptr, words.data(), ::environ);
    if (error != 0) {
        throw kernel::FileError(arguments[0],
                                "this program makes PNG and is not installed (Debian: "
                                "librsvg2-bin); install it, or write .svg");
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) throw std::system_error(errno, std::generic_category(), arguments[0]);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

std::string png_of(const std::string& svg) {
    const TemporaryDirectory directory;
    const std::string drawing = directory.file("picture.svg");
    const std::string picture = directory.file("picture.png");
    kernel::write_file(drawing, [&](std::ostream& out) { out << svg; });
    const int status =
        run(std::array<std::string, 5>{converter, "--format=png", "--output", picture, drawing});
    if (status != 0) {
        throw kernel::FileError(converter, "it made no PNG of the drawing; write .svg");
    }
    return kernel::read_file(picture);
}

}  // namespace tightflip::tools
