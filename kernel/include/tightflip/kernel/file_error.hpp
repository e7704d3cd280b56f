/// \file
/// What is wrong with a file, and where in it.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace tightflip::kernel {

/// Thrown where a file cannot be read, understood or written. `what()` reads
/// "source:12: reason", "source: byte 12: reason" or "source: reason".
class FileError : public std::runtime_error {
public:
    /// What a position counts: lines from 1, bytes from 0.
    enum class Unit { none, line, byte };

    FileError(std::string source, Unit unit, std::uint64_t position, std::string reason);
    FileError(std::string source, std::string reason)
        : FileError(std::move(source), Unit::none, 0, std::move(reason)) {}

    [[nodiscard]] const std::string& source() const noexcept { return source_; }
    [[nodiscard]] Unit unit() const noexcept { return unit_; }
    [[nodiscard]] std::uint64_t position() const noexcept { return position_; }
    [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

private:
    std::string source_;
    Unit unit_;
    std::uint64_t position_;
    std::string reason_;
};

}  // namespace tightflip::kernel
