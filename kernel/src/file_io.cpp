#include <tightflip/kernel/file_io.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace tightflip::kernel {
namespace {

std::string system_reason() {
    return std::generic_category().message(errno);
}

/// A name beside `path` that no other process uses; the file is removed unless it was renamed.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& path)
        : name_(path.string() + ".part" + std::to_string(::getpid())) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(name_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& name() const noexcept { return name_; }

private:
    std::filesystem::path name_;
};

}  // namespace

std::string read_file(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw FileError(path.string(), "is a directory; name a file");
    }
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) throw FileError(path.string(), "cannot be opened: " + system_reason());
    std::ostringstream bytes;
    bytes << in.rdbuf();
    if (in.bad()) throw FileError(path.string(), "cannot be read: " + system_reason());
    return std::move(bytes).str();
}

void write_file(const std::filesystem::path& path,
                const std::function<void(std::ostream&)>& write) {
    const TemporaryFile temporary(path);
    errno = 0;
    std::ofstream out(temporary.name(), std::ios::binary | std::ios::trunc);
    if (!out) throw FileError(path.string(), "cannot be written: " + system_reason());
    write(out);
    out.close();
    if (!out) throw FileError(path.string(), "writing failed: " + system_reason());
    std::error_code error;
    std::filesystem::rename(temporary.name(), path, error);
    if (error) throw FileError(path.string(), "cannot be replaced: " + error.message());
}

}  // namespace tightflip::kernel
