// tightflip_fuzz: the fuzz targets for people and for tests, without a fuzzer. Exit code 0: every
// claim held; 1: one did not; 2: wrong usage, or an argument that could not be read or written.

#include "minimise.hpp"
#include "replay.hpp"
#include "targets.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <stdexcept>

namespace {

using namespace tightflip::fuzz;
using Arguments = std::span<const std::string>;

/// Thrown where the command line does not say what to do.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

const Target& target_called(const std::string& name) {
    if (const Target* target = find_target(name)) return *target;
    std::string message = "there is no target '" + name + "'; there are:";
    for (const Target& target : targets())
        message += " " + std::string(target.name);
    throw UsageError(message);
}

int list(Arguments) {
    for (const Target& target : targets())
        std::cout << target.name << "\t" << target.description << "\n";
    return 0;
}

int write_seeds(Arguments arguments) {
    const Target& target = target_called(arguments[0]);
    const std::filesystem::path directory = arguments[1];
    std::filesystem::create_directories(directory);
    const std::vector<Seed> seeds = target.seeds();
    for (const auto& [name, bytes] : seeds)
        write_input(directory / name, bytes);
    std::cout << seeds.size() << " seeds in " << directory.string() << "\n";
    return 0;
}

int replay(Arguments arguments) {
    const Target& target = target_called(arguments[0]);
    const Arguments rest = arguments.subspan(1);
    const auto is_given = [&](std::string_view option) {
        return std::ranges::find(rest, option) != rest.end();
    };
    Replayer replayer(target, std::cout, std::cerr, is_given("--verbose"));
    bool unusable = false;
    if (is_given("--seeds")) replayer.replay_seeds();
    for (const std::string& path : rest) {
        if (path.starts_with("--")) continue;
        const std::size_t skipped = replayer.summary().skipped;
        replayer.replay_path(path);
        // In a corpus a bad file is passed over; one that was asked for is not.
        if (!std::filesystem::is_directory(path)) unusable |= replayer.summary().skipped > skipped;
    }
    std::cout << describe(replayer.summary()) << "\n";
    if (replayer.summary().broken > 0) return 1;
    return unusable || replayer.summary().inputs == 0 ? 2 : 0;
}

int show(Arguments arguments) {
    const Target& target = target_called(arguments[0]);
    const InputBytes input = read_input(arguments[1]);
    if (!is_of_this_version(target.layout, input)) {
        throw UsageError(arguments[1] + ": of another version than " +
                         std::to_string(format_version));
    }
    target.show(std::cout, input);
    return 0;
}

int write_minimised(Arguments arguments) {
    const Target& target = target_called(arguments[0]);
    const InputBytes input = read_input(arguments[1]);
    const InputBytes smallest = minimise(target, input);
    const std::string objected = guarded_objection(target, smallest);
    if (objected.empty()) {
        std::cout << "every claim holds of this input; there is nothing to make smaller\n";
        return 0;
    }
    write_input(arguments[2], smallest);
    std::cout << input.size() << " bytes made " << smallest.size() << "\n" << objected << "\n";
    return 1;
}

struct Verb {
    std::string_view name;
    std::string_view usage;
    std::size_t least_arguments;
    std::size_t most_arguments;
    int (*run)(Arguments);
};

constexpr std::size_t any_number = ~std::size_t{0};

constexpr std::array verbs{
    Verb{"list", "", 0, 0, list},
    Verb{"seeds", "TARGET DIRECTORY", 2, 2, write_seeds},
    Verb{"replay", "TARGET [--verbose] [--seeds] [FILE|DIRECTORY]...", 2, any_number, replay},
    Verb{"show", "TARGET FILE", 2, 2, show},
    Verb{"minimise", "TARGET FILE OUT", 3, 3, write_minimised},
};

int run(Arguments arguments) {
    const auto* const verb =
        arguments.empty() ? verbs.end() : std::ranges::find(verbs, arguments[0], &Verb::name);
    if (verb != verbs.end()) {
        const Arguments rest = arguments.subspan(1);
        if (rest.size() >= verb->least_arguments && rest.size() <= verb->most_arguments) {
            return verb->run(rest);
        }
    }
    std::string usage = "usage:";
    for (const Verb& one : verbs)
        usage += "\n  tightflip_fuzz " + std::string(one.name) + " " + std::string(one.usage);
    throw UsageError(usage);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::vector<std::string> arguments(argv + 1, argv + argc);
        return run(arguments);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
