#include "targets/checkpoint.hpp"

#include "reading.hpp"
#include "targets.hpp"
#include <tightflip/kernel/explore.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <filesystem>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

const InputBytes& seed_named(const std::vector<Seed>& seeds, std::string_view name) {
    return std::ranges::find(seeds, name, &Seed::name)->bytes;
}

/// Whether a run that finds the file goes on from it, or stops with a FileError.
bool is_accepted(const InputBytes& input) {
    const auto directory = std::filesystem::path(::testing::TempDir()) / "checkpoint_test";
    std::filesystem::create_directories(directory);
    const auto file = directory / "classes.checkpoint";
    kernel::write_file(file, [&](std::ostream& out) { out << as_text(input).substr(1); });
    bool accepted = true;
    try {
        static_cast<void>(kernel::explore(
            {.vertices = 5, .distances = kernel::DistanceEffort::none},
            {.threads = 1, .checkpoint_directory = directory, .progress = {}, .interrupted = {}}));
    } catch (const kernel::FileError&) {
        accepted = false;
    }
    std::filesystem::remove_all(directory);
    return accepted;
}

TEST(CheckpointSeeds, AreGoneOnFromOrRefused) {
    const std::vector<Seed> seeds = checkpoint_target.seeds();
    for (const char* const good : {"classes_whole", "classes_at_once", "classes_soon"})
        EXPECT_TRUE(is_accepted(seed_named(seeds, good))) << good;
    for (const char* const bad : {"classes_empty", "classes_cut", "classes_longer",
                                  "classes_other_kind", "classes_changed", "classes_huge_length"})
        EXPECT_FALSE(is_accepted(seed_named(seeds, bad))) << bad;
    EXPECT_NE(seed_named(seeds, "classes_whole"), seed_named(seeds, "classes_at_once"));
    EXPECT_NE(seed_named(seeds, "labelled_whole"), seed_named(seeds, "labelled_soon"));
}

TEST(Checkpoint, HoldsForFilesCutAnywhere) {
    const std::vector<Seed> seeds = checkpoint_target.seeds();
    for (const char* const name : {"classes_whole", "labelled_whole"}) {
        const InputBytes& bytes = seed_named(seeds, name);
        for (std::size_t size = 1; size < bytes.size(); size += 101)
            EXPECT_EQ(objection(checkpoint_target, Input(bytes).first(size)), "");
    }
}

}  // namespace
}  // namespace tightflip::fuzz
