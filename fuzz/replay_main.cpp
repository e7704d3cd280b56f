// TARGET_replay [--verbose] FILE|DIRECTORY...: runs a target on inputs from files, without
// libFuzzer. Exit code 0: every claim held of every input; 1: one did not; 2: an argument could not
// be read, or there was no input.

#include "target.hpp"
#include <tightflip/kernel/file_io.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <vector>

namespace {

using namespace tightflip;

/// The file, or every file of the directory in the order of their names.
std::vector<std::filesystem::path> files_at(const std::filesystem::path& path) {
    if (!std::filesystem::is_directory(path)) return {path};
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

/// Whether every claim held.
bool replay(const std::filesystem::path& path, bool verbose) {
    const std::string text = kernel::read_file(path);
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    const std::string objected = fuzz::objection(bytes);
    if (verbose || !objected.empty()) {
        std::cout << path.string() << ": ";
        fuzz::show(std::cout, bytes);
    }
    if (!objected.empty()) std::cout << path.string() << ": " << objected << "\n";
    return objected.empty();
}

}  // namespace

int main(int argc, char** argv) {
    bool verbose = false;
    bool all_hold = true;
    std::size_t inputs = 0;
    try {
        for (const std::string_view argument :
             std::vector<std::string_view>(argv + 1, argv + argc)) {
            if (argument == "--verbose") {
                verbose = true;
                continue;
            }
            for (const auto& file : files_at(argument)) {
                ++inputs;
                all_hold = replay(file, verbose) && all_hold;
            }
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
    if (inputs == 0) {
        std::cerr << "usage: " << argv[0] << " [--verbose] FILE|DIRECTORY...\n";
        return 2;
    }
    std::cout << inputs << " inputs, " << (all_hold ? "every claim held" : "claims do not hold")
              << "\n";
    return all_hold ? 0 : 1;
}
