#include "checkpoint.hpp"

#include "reading.hpp"
#include "targets.hpp"
#include <tightflip/kernel/explore.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>
#include <system_error>
#include <unistd.h>

namespace tightflip::fuzz {
namespace {

using kernel::Exploration;
using kernel::ExploreRequest;
using kernel::States;

struct Kind {
    std::string_view file;
    ExploreRequest request;
};
constexpr std::array<Kind, checkpoint_kinds> kinds{
    Kind{"classes.checkpoint",
         {.vertices = 5, .states = States::classes, .distances = kernel::DistanceEffort::none}},
    Kind{"labelled.checkpoint",
         {.vertices = 4, .states = States::labelled, .distances = kernel::DistanceEffort::none}},
};

/// A directory of this process's own, gone at its end.
class Directory {
public:
    Directory() {
        // Memory where the system has a directory of it: a run is mostly files.
        const std::filesystem::path memory = "/dev/shm";
        const auto parent =
            ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
        path_ = parent / ("tightflip-checkpoint-" + std::to_string(::getpid()));
        std::filesystem::create_directories(path_);
    }
    Directory(const Directory&) = delete;
    Directory& operator=(const Directory&) = delete;
    ~Directory() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    void clear() const {
        for (const Kind& kind : kinds)
            std::filesystem::remove(path_ / kind.file);
    }

private:
    std::filesystem::path path_;
};

const Directory& directory() {
    static const Directory one;
    return one;
}

Exploration run(const Kind& kind, const std::filesystem::path& checkpoints,
                const std::function<bool()>& interrupted = {}) {
    return explore(kind.request, {.threads = 1,
                                  .checkpoint_directory = checkpoints,
                                  .checkpoint_seconds = 0,
                                  .progress = {},
                                  .interrupted = interrupted});
}

bool are_same(const Exploration& a, const Exploration& b) {
    return a.states == b.states && a.arcs == b.arcs && a.rooted == b.rooted &&
           a.components == b.components && a.classes.codes == b.classes.codes &&
           a.classes.arcs.offsets == b.classes.arcs.offsets &&
           a.classes.arcs.targets == b.classes.arcs.targets &&
           std::ranges::equal(a.levels, b.levels, [](const auto& x, const auto& y) {
               return x.source == y.source && x.states == y.states && x.farthest == y.farthest;
           });
}

const Exploration& without_checkpoint(std::size_t kind) {
    static const std::array<Exploration, checkpoint_kinds> results{run(kinds[0], {}),
                                                                   run(kinds[1], {})};
    return results.at(kind);
}

/// What a run keeps that is interrupted when it has been asked so often whether it is.
std::string kept_after(const Kind& kind, int questions) {
    directory().clear();
    try {
        static_cast<void>(run(kind, directory().path(), [&] { return questions-- <= 0; }));
    } catch (const kernel::ExplorationStopped&) {
    }
    const auto file = directory().path() / kind.file;
    return std::filesystem::exists(file) ? kernel::read_file(file) : std::string();
}

std::vector<Seed> seeds() {
    std::vector<Seed> seeds{{"nothing", {}}};
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const auto add = [&](const std::string& name, const std::string& file) {
            InputBytes bytes = as_bytes(file);
            bytes.insert(bytes.begin(), static_cast<std::uint8_t>(k));
            seeds.push_back({(k == 0 ? "classes_" : "labelled_") + name, bytes});
        };
        const std::string whole = kept_after(kinds.at(k), 1 << 20);
        add("empty", "");
        add("whole", whole);
        add("at_once", kept_after(kinds.at(k), 0));
        add("soon", kept_after(kinds.at(k), 1));
        add("later", kept_after(kinds.at(k), 2));
        add("cut", whole.substr(0, whole.size() / 2));
        add("longer", whole + '\0');
        add("other_kind", kept_after(kinds.at(1 - k), 1 << 20));
        std::string changed = whole;
        changed[changed.size() / 2] ^= '\1';
        add("changed", changed);
        std::string huge = whole;
        huge.replace(0, 8, std::string(8, '\x7f'));
        add("huge_length", huge);
    }
    directory().clear();
    return seeds;
}

}  // namespace

std::string checkpoint_objection(std::size_t kind, Input file) {
    const Exploration& expected = without_checkpoint(kind);
    directory().clear();
    const auto path = directory().path() / kinds.at(kind).file;
    kernel::write_file(path, [&](std::ostream& out) { out << as_text(file); });
    constexpr std::array<std::string_view, 4> whole_file_reasons{"is damaged", "is no checkpoint",
                                                                 "belongs to", "cannot be"};
    const auto result = attempt(
        as_text(file), [&] { return are_same(run(kinds.at(kind), directory().path()), expected); },
        whole_file_reasons);
    if (!result.value) {
        if (kernel::read_file(path) != as_text(file)) {
            return "refused_checkpoints_are_left_as_they_were: this one is not";
        }
        directory().clear();
        return result.objection;
    }
    directory().clear();
    return *result.value ? std::string() : "runs_go_on_to_the_same_result: this one does not";
}

const Target checkpoint_target{
    .name = "checkpoint",
    .description =
        "a byte for the kind, then a checkpoint: refused, or gone on from to the same "
        "result",
    .layout = {},
    .objection =
        [](Input input) {
            if (input.empty()) return std::string();
            return checkpoint_objection(input.front() % checkpoint_kinds, input.subspan(1));
        },
    .show =
        [](std::ostream& out, Input input) {
            if (input.empty()) return show_bytes(out, input);
            out << kinds.at(input.front() % checkpoint_kinds).file << ":\n";
            show_bytes(out, input.subspan(1));
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
