#include <tightflip/kernel/file_error.hpp>

#include <utility>

namespace tightflip::kernel {
namespace {

std::string compose(const std::string& source, FileError::Unit unit, std::uint64_t position,
                    const std::string& reason) {
    switch (unit) {
        case FileError::Unit::line:
            return source + ":" + std::to_string(position) + ": " + reason;
        case FileError::Unit::byte:
            return source + ": byte " + std::to_string(position) + ": " + reason;
        case FileError::Unit::none:
            break;
    }
    return source + ": " + reason;
}

}  // namespace

FileError::FileError(std::string source, Unit unit, std::uint64_t position, std::string reason)
    : std::runtime_error(compose(source, unit, position, reason)),
      source_(std::move(source)),
      unit_(unit),
      position_(position),
      reason_(std::move(reason)) {}

}  // namespace tightflip::kernel
