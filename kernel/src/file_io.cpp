#include <tightflip/kernel/file_io.hpp>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
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
    std::string bytes;
    std::array<char, 1 << 16> block{};
    while (in.read(block.data(), block.size()) || in.gcount() > 0) {
        bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad()) throw FileError(path.string(), "cannot be read: " + system_reason());
    return bytes;
}

void write_file(const std::filesystem::path& path,
                const std::function<void(std::ostream&)>& write) {
    const auto fill = [&](const std::filesystem::path& name) {
        errno = 0;
        std::ofstream out(name, std::ios::binary | std::ios::trunc);
        if (!out) throw FileError(path.string(), "cannot be written: " + system_reason());
        write(out);
        out.close();
        if (!out) throw FileError(path.string(), "writing failed: " + system_reason());
    };
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (is_directory(status)) throw FileError(path.string(), "is a directory; name a file");
    if (std::filesystem::is_other(status)) return fill(path);  // renaming would replace the device
    const bool is_link = std::filesystem::is_symlink(path, ignored);
    std::error_code error;
    const auto target = is_link ? std::filesystem::weakly_canonical(path, error) : path;
    if (error) throw FileError(path.string(), "cannot be followed: " + error.message());

    const TemporaryFile temporary(target);
    fill(temporary.name());
    std::filesystem::rename(temporary.name(), target, error);
    if (error) throw FileError(path.string(), "cannot be replaced: " + error.message());
}

}  // namespace tightflip::kernel
