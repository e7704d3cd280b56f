#include "checkpoint.hpp"

namespace tightflip::kernel {

CheckpointReader::CheckpointReader(const std::filesystem::path& path, std::string_view kind)
    : name_(path.string()), in_(path, std::ios::binary), left_(std::filesystem::file_size(path)) {
    if (!in_) refuse("cannot be opened");
    std::vector<char> found;
    array(found);
    if (std::string_view(found.data(), found.size()) != kind) {
        refuse("is no checkpoint of the kind \"" + std::string(kind) + "\"");
    }
}

void CheckpointReader::finish() {
    const std::uint64_t sum = checksum_.value();
    if (raw() != sum || left_ != 0) refuse_damaged();
}

void CheckpointReader::refuse(const std::string& reason) const {
    throw FileError(name_, reason + "; name another directory, or remove the file to start anew");
}

void CheckpointReader::refuse_damaged() const {
    refuse("is damaged: lengths or the checksum do not fit");
}

std::size_t CheckpointReader::checked_length(std::size_t item_size) {
    const std::uint64_t length = raw();
    if (length > left_ / item_size) refuse_damaged();
    return static_cast<std::size_t>(length);
}

std::uint64_t CheckpointReader::raw() {
    std::uint64_t word = 0;
    bytes(std::as_writable_bytes(std::span<std::uint64_t, 1>(&word, 1)));
    return word;
}

void CheckpointReader::bytes(std::span<std::byte> items) {
    if (items.size() > left_) refuse_damaged();
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are what streams give
    in_.read(reinterpret_cast<char*>(items.data()), static_cast<std::streamsize>(items.size()));
    if (!in_) refuse("cannot be read");
    left_ -= items.size();
    checksum_.add(items);
}

}  // namespace tightflip::kernel
