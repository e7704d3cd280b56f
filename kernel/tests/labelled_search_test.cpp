#include "temporary_directory.hpp"
#include <tightflip/kernel/counting.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/labelled_search.hpp>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::ElementsAre;

ClassGraph classes_of(const Triangulation& start) {
    return explore_classes(
        std::span(&start, 1),
        {.mirror = Mirror::distinct, .simple_only = false, .keep_relabellings = true});
}

LabelledLevels search_from(const ClassGraph& classes, const Triangulation& start,
                           const ExplorationLimits& limits = {}) {
    LabelledSearch search(classes);
    LocalExchange exchange(classes.size(), search.label_words().size());
    return search.run(static_cast<std::uint32_t>(classes.find(start)), exchange, limits);
}

/// Labelled surfaces at each distance, by flipping them one by one.
std::vector<std::uint64_t> levels_by_hand(const Triangulation& start) {
    CanonicalSearch search;
    std::string code(code_length(static_cast<std::size_t>(start.halfedge_count()), Labels::kept),
                     '\0');
    std::set<std::string> seen;
    const auto is_new = [&](const Triangulation& surface) {
        search(surface.table(), surface.vertex_count(), {Labels::kept, Mirror::distinct},
               std::span<char>(code));
        return seen.insert(code).second;
    };
    std::vector<Triangulation> level{start};
    is_new(start);
    std::vector<std::uint64_t> counts;
    while (!level.empty()) {
        counts.push_back(level.size());
        std::vector<Triangulation> next;
        for (const Triangulation& surface : level) {
            for (Index e = 0; e < surface.edge_count(); ++e) {
                Triangulation flipped = surface;
                if (flipped.flip({e}) && is_new(flipped)) next.push_back(flipped);
            }
        }
        level = std::move(next);
    }
    return counts;
}

TEST(LabelledSearch, AgreesWithFlippingOneByOne) {
    for (const Triangulation& start :
         {families::tetrahedron(), families::book(4), families::book(5), families::double_wheel(6),
          families::book(6), families::surface_of_genus(1, 4, 0),
          families::surface_of_genus(1, 5, 1), families::surface_of_genus(2, 4, 0)}) {
        EXPECT_EQ(search_from(classes_of(start), start).states, levels_by_hand(start));
    }
}

TEST(LabelledSearch, ReachesAllLabelledSpheres) {
    for (Index vertices = 3; vertices <= 8; ++vertices) {
        const Triangulation start = families::book(vertices);
        EXPECT_EQ(search_from(classes_of(start), start).total(),
                  labelled_from_rooted(rooted_spheres(vertices).value(), vertices,
                                       start.halfedge_count()));
    }
}

TEST(LabelledSearch, TheBookIsAsFarOutAsTheTheoryPageSays) {
    Index vertices = 4;
    for (const std::size_t eccentricity : {2U, 6U, 10U, 15U, 19U}) {
        const Triangulation start = families::book(vertices++);
        EXPECT_EQ(search_from(classes_of(start), start).eccentricity(), eccentricity);
    }
}

TEST(LabelledSearch, SymmetriesTakeAwayLabellings) {
    const ClassGraph classes = classes_of(families::book(4));
    const LabelledSearch search(classes);
    const auto tetrahedron = static_cast<std::uint32_t>(classes.find(families::tetrahedron()));
    EXPECT_EQ(search.states_of(tetrahedron), 24U / 12);
    // The torus of three vertices has automorphisms that fix them all.
    const ClassGraph torus = classes_of(families::surface_of_genus(1, 3, 0));
    EXPECT_GT(torus.symmetries[0], 6U);
    EXPECT_EQ(LabelledSearch(torus).states_of(0), 1U);
}

TEST(LabelledSearch, FarthestIsThePlaceInTheLevels) {
    const Triangulation start = families::book(6);
    const ClassGraph classes = classes_of(start);
    const LabelledLevels levels = search_from(classes, start);
    EXPECT_EQ(*std::ranges::max_element(levels.farthest), levels.eccentricity());
    EXPECT_EQ(levels.eccentricity(), 10U);
    EXPECT_THAT(levels.states, ElementsAre(1, 4, 22, 64, 229, 608, 1254, 1460, 1226, 392, 20));
}

TEST(LabelledSearch, ThreadsDoNotMatter) {
    const Triangulation start = families::double_wheel(7);
    const ClassGraph classes = classes_of(start);
    ExplorationLimits one;
    one.threads = 1;
    ExplorationLimits four;
    four.threads = 4;
    const LabelledLevels a = search_from(classes, start, one);
    const LabelledLevels b = search_from(classes, start, four);
    EXPECT_EQ(a.states, b.states);
    EXPECT_EQ(a.farthest, b.farthest);
}

/// Two processes, played by two threads, each with half of the classes: all that a distributed
/// engine has to do.
class SharedBlocks {
public:
    SharedBlocks(std::size_t classes, std::size_t words)
        : words_(words), level_(classes * words), next_(classes * words) {}

    [[nodiscard]] std::span<const LabelWord> block(std::uint32_t state) const {
        return std::span(level_).subspan(state * words_, words_);
    }
    [[nodiscard]] std::span<LabelWord> next_block(std::uint32_t state) {
        return std::span(next_).subspan(state * words_, words_);
    }
    std::uint64_t advance(std::uint64_t found) {
        std::unique_lock lock(guard_);
        sum_ += found;
        if (++arrived_ == 2) {
            arrived_ = 0;
            level_.swap(next_);
            total_ = std::exchange(sum_, 0);
            ++round_;
            turned_.notify_all();
        } else {
            turned_.wait(lock, [this, round = round_] { return round_ != round; });
        }
        return total_;
    }

private:
    std::size_t words_;
    std::vector<LabelWord> level_;
    std::vector<LabelWord> next_;
    std::mutex guard_;
    std::condition_variable turned_;
    std::uint64_t sum_ = 0;
    std::uint64_t total_ = 0;
    int arrived_ = 0;
    int round_ = 0;
};

class HalfExchange final : public FrontierExchange {
public:
    HalfExchange(SharedBlocks& blocks, std::size_t classes, std::uint32_t half) : blocks_(blocks) {
        for (std::uint32_t c = half; c < classes; c += 2)
            own_.push_back(c);
    }
    [[nodiscard]] std::span<const std::uint32_t> own_classes() const override { return own_; }
    [[nodiscard]] std::span<const LabelWord> block(std::uint32_t state) const override {
        return blocks_.block(state);
    }
    [[nodiscard]] std::span<LabelWord> next_block(std::uint32_t state) override {
        return blocks_.next_block(state);
    }
    std::uint64_t advance(std::uint64_t found) override { return blocks_.advance(found); }

private:
    SharedBlocks& blocks_;
    std::vector<std::uint32_t> own_;
};

TEST(LabelledSearch, TwoProcessesFindWhatOneFinds) {
    const Triangulation start = families::book(7);
    const ClassGraph classes = classes_of(start);
    const auto source = static_cast<std::uint32_t>(classes.find(start));
    SharedBlocks blocks(classes.size(), LabelWords(7).size());
    std::vector<LabelledLevels> levels(2);
    const auto process = [&](std::uint32_t half) {
        HalfExchange exchange(blocks, classes.size(), half);
        levels[half] = LabelledSearch(classes).run(source, exchange, {});
    };
    {
        const std::jthread other(process, 1U);
        process(0);
    }
    const LabelledLevels alone = search_from(classes, start);
    EXPECT_EQ(levels[0].states, alone.states);
    EXPECT_EQ(levels[1].states, alone.states);
    for (std::size_t c = 0; c < classes.size(); ++c) {
        EXPECT_EQ(levels[c % 2].farthest[c], alone.farthest[c]);
        EXPECT_EQ(levels[1 - c % 2].farthest[c], LabelledLevels::unreached);
    }
}

class LabelledSearchCheckpoint : public ::testing::Test {
protected:
    LabelledSearchCheckpoint() {
        limits.checkpoint_directory = directory.path();
        limits.checkpoint_seconds = 0;
    }
    void interrupt_after(std::size_t classes_done) {
        std::atomic<std::size_t> done = 0;
        limits.interrupted = [&] { return ++done >= classes_done; };
        EXPECT_THROW(static_cast<void>(search_from(classes, start, limits)), ExplorationStopped);
        limits.interrupted = nullptr;
    }

    testing::TemporaryDirectory directory;
    std::filesystem::path file = directory / "labelled.checkpoint";
    ExplorationLimits limits;
    Triangulation start = families::book(7);
    ClassGraph classes = classes_of(start);
};

TEST_F(LabelledSearchCheckpoint, AnInterruptedSearchGoesOnToTheSameEnd) {
    interrupt_after(6 * classes.size() + 5);
    std::uint64_t taken_over = 0;
    limits.progress = [&](const ExplorationProgress& p) { taken_over = p.done_before; };
    const LabelledLevels resumed = search_from(classes, start, limits);
    EXPECT_GT(taken_over, 1000U);
    const LabelledLevels whole = search_from(classes, start);
    EXPECT_EQ(resumed.states, whole.states);
    EXPECT_EQ(resumed.farthest, whole.farthest);
    EXPECT_EQ(search_from(classes, start, limits).states, whole.states);  // from the end, at once
}

TEST_F(LabelledSearchCheckpoint, DamageAndOtherParametersAreRefused) {
    interrupt_after(3 * classes.size());
    const std::string kept = read_file(file);
    EXPECT_THROW(static_cast<void>(search_from(classes, families::double_wheel(7), limits)),
                 FileError);
    std::string damaged = kept;
    damaged[damaged.size() / 3] ^= 1;
    write_file(file, [&](std::ostream& out) { out << damaged; });
    EXPECT_THROW(static_cast<void>(search_from(classes, start, limits)), FileError);
    EXPECT_EQ(read_file(file), damaged);
}

TEST_F(LabelledSearchCheckpoint, AnotherGraphOfTheSameSizeIsRefused) {
    interrupt_after(3 * classes.size());
    LabelledSearch search(classes);
    LocalExchange exchange(classes.size(), search.label_words().size());
    const auto source = static_cast<std::uint32_t>(classes.find(start));
    ++classes.codes.back();
    EXPECT_THROW(static_cast<void>(search.run(source, exchange, limits)), FileError);
}

TEST(LabelledSearchBytes, AreThoseOfTheArrays) {
    const LabelWords words(9);
    EXPECT_EQ(labelled_search_bytes(9, 10), 3 * 10 * words.size() * sizeof(LabelWord));
    EXPECT_EQ(labelled_search_bytes(4, 2), 3 * 2 * LabelWords(4).size() * sizeof(LabelWord));
}

}  // namespace
}  // namespace tightflip::kernel
