/// \file
/// The inputs that are kept for a target.
#pragma once

#include <tightflip/kernel/file_io.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tightflip::fuzz {

inline std::vector<std::vector<std::uint8_t>> corpus(const std::string& target) {
    std::vector<std::vector<std::uint8_t>> inputs;
    const auto folder = std::filesystem::path(TIGHTFLIP_FUZZ_CORPUS) / target;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string text = kernel::read_file(entry.path());
        inputs.emplace_back(text.begin(), text.end());
    }
    return inputs;
}

}  // namespace tightflip::fuzz
