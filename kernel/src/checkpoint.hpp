/// \file
/// A file that keeps the state of a long run: a name, then arrays of plain integers, then a
/// checksum over everything. Only this program on this kind of machine reads it back.
#pragma once

#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/random.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::kernel {

/// A running sum over bytes in the order in which they pass.
class Checksum {
public:
    void add(std::span<const std::byte> bytes) noexcept {
        while (!bytes.empty()) {
            std::uint64_t word = 0;
            const std::size_t taken = std::min(bytes.size(), sizeof word);
            std::memcpy(&word, bytes.data(), taken);
            sum_ = mix(sum_ ^ word) + taken;
            bytes = bytes.subspan(taken);
        }
    }
    [[nodiscard]] std::uint64_t value() const noexcept { return sum_; }

private:
    std::uint64_t sum_ = 0x9e3779b97f4a7c15ULL;
};

/// Writes arrays, each with its length before it.
class CheckpointWriter {
public:
    CheckpointWriter(std::ostream& out, std::string_view kind) : out_(out) {
        array(std::span<const char>(kind));
    }
    template <class T>
    void array(std::span<const T> items) {
        raw(std::uint64_t{items.size()});
        bytes(std::as_bytes(items));
    }
    template <class T>
    void array(const std::vector<T>& items) {
        array(std::span<const T>(items));
    }
    void finish() {
        const std::uint64_t sum = checksum_.value();
        raw(sum);
    }

private:
    void raw(std::uint64_t word) {
        bytes(std::as_bytes(std::span<const std::uint64_t, 1>(&word, 1)));
    }
    void bytes(std::span<const std::byte> items) {
        checksum_.add(items);
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are what streams take
        out_.write(reinterpret_cast<const char*>(items.data()),
                   static_cast<std::streamsize>(items.size()));
    }

    std::ostream& out_;
    Checksum checksum_;
};

/// Reads what a CheckpointWriter wrote. Throws FileError where the file is damaged or of another
/// kind; nothing read may be used before `finish` has returned.
class CheckpointReader {
public:
    CheckpointReader(const std::filesystem::path& path, std::string_view kind);

    template <class T>
    void array(std::vector<T>& items) {
        items.resize(checked_length(sizeof(T)));
        bytes(std::as_writable_bytes(std::span<T>(items)));
    }
    /// An array whose length is known beforehand, into memory that stands.
    template <class T>
    void array(std::span<T> items) {
        if (checked_length(sizeof(T)) != items.size()) refuse_damaged();
        bytes(std::as_writable_bytes(items));
    }
    void finish();

    [[noreturn]] void refuse(const std::string& reason) const;
    [[noreturn]] void refuse_damaged() const;

private:
    [[nodiscard]] std::size_t checked_length(std::size_t item_size);
    std::uint64_t raw();
    void bytes(std::span<std::byte> items);

    std::string name_;
    std::ifstream in_;
    std::uint64_t left_;
    Checksum checksum_;
};

}  // namespace tightflip::kernel
