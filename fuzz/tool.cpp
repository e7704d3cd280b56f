#include "tool.hpp"

#include "minimise.hpp"
#include "replay.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <stdexcept>

namespace tightflip::fuzz {
namespace {

/// Thrown where the command line does not say what to do.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What a verb was given.
struct Request {
    std::span<const Target> targets;
    std::vector<std::string> words;  ///< what is no option
    std::vector<std::string> options;

    [[nodiscard]] bool has(std::string_view option) const {
        return std::ranges::find(options, option) != options.end();
    }
    /// The one that the first word names.
    [[nodiscard]] const Target& target() const {
        const auto found = std::ranges::find(targets, words[0], &Target::name);
        if (found != targets.end()) return *found;
        std::string message = "there is no target '" + words[0] + "'; there are:";
        for (const Target& target : targets)
            message += " " + std::string(target.name);
        throw UsageError(message);
    }
    /// The bytes of the file that the second word names.
    [[nodiscard]] InputBytes input() const {
        InputBytes input = read_input(words[1]);
        if (is_of_this_version(target().layout, input)) return input;
        throw UsageError(words[1] + ": " + other_version());
    }
};

int list(const Request& request) {
    for (const Target& target : request.targets)
        std::cout << target.name << "\t" << target.description << "\n";
    return 0;
}

int write_seeds(const Request& request) {
    const std::vector<Seed> seeds = request.target().seeds();
    const std::filesystem::path directory = request.words[1];
    std::filesystem::create_directories(directory);
    for (const auto& [name, bytes] : seeds)
        write_input(directory / name, bytes);
    std::cout << seeds.size() << " seeds in " << directory.string() << "\n";
    return 0;
}

int replay(const Request& request) {
    Replayer replayer(request.target(), std::cout, std::cerr, request.has("--verbose"));
    bool unusable = false;
    if (request.has("--seeds")) replayer.replay_seeds();
    for (const std::string& path : std::span(request.words).subspan(1)) {
        const std::size_t skipped = replayer.summary().skipped;
        replayer.replay_path(path);
        // In a corpus a bad file is passed over; one that was asked for is not.
        if (!std::filesystem::is_directory(path)) unusable |= replayer.summary().skipped > skipped;
    }
    std::cout << describe(replayer.summary()) << "\n";
    if (replayer.summary().broken > 0) return 1;
    return unusable || replayer.summary().inputs == 0 ? 2 : 0;
}

int show(const Request& request) {
    const InputBytes input = request.input();
    request.target().show(std::cout, input);
    return 0;
}

int write_minimised(const Request& request) {
    const InputBytes input = request.input();
    const InputBytes smallest = minimise(request.target(), input);
    const std::string objected = guarded_objection(request.target(), smallest);
    if (objected.empty()) {
        std::cout << "every claim holds of this input; there is nothing to make smaller\n";
        return 0;
    }
    write_input(request.words[2], smallest);
    std::cout << input.size() << " bytes made " << smallest.size() << "\n" << objected << "\n";
    return 1;
}

struct Verb {
    std::string_view name;
    std::string_view usage;  ///< its options are those in brackets that begin with "--"
    std::size_t least_words;
    std::size_t most_words;
    int (*run)(const Request&);

    [[nodiscard]] bool takes(const Request& request) const {
        return request.words.size() >= least_words && request.words.size() <= most_words &&
               std::ranges::all_of(request.options, [&](const std::string& option) {
                   return usage.find("[" + option + "]") != std::string_view::npos;
               });
    }
};

constexpr std::size_t any_number = ~std::size_t{0};

constexpr std::array verbs{
    Verb{"list", "", 0, 0, list},
    Verb{"seeds", "TARGET DIRECTORY", 2, 2, write_seeds},
    Verb{"replay", "TARGET [--verbose] [--seeds] [FILE|DIRECTORY]...", 1, any_number, replay},
    Verb{"show", "TARGET FILE", 2, 2, show},
    Verb{"minimise", "TARGET FILE OUT", 3, 3, write_minimised},
};

int run(std::span<const Target> targets, std::span<const std::string> arguments) {
    Request request{.targets = targets, .words = {}, .options = {}};
    for (const std::string& argument : arguments)
        (argument.starts_with("--") ? request.options : request.words).push_back(argument);
    if (!request.words.empty()) {
        const auto* const verb = std::ranges::find(verbs, request.words.front(), &Verb::name);
        request.words.erase(request.words.begin());
        if (verb != verbs.end() && verb->takes(request)) return verb->run(request);
    }
    std::string usage = "usage:";
    for (const Verb& one : verbs)
        usage += "\n  tightflip_fuzz " + std::string(one.name) + " " + std::string(one.usage);
    throw UsageError(usage);
}

}  // namespace

int run_tool(std::span<const Target> targets, int argc, char** argv) {
    try {
        const std::vector<std::string> arguments(argv + 1, argv + argc);
        return run(targets, arguments);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}

}  // namespace tightflip::fuzz
