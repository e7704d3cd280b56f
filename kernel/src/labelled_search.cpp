#include "checkpoint.hpp"
#include "parallel.hpp"
#include "vertex_numbers.hpp"
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/labelled_search.hpp>
#include <tightflip/kernel/rooted_decode.hpp>

#include <algorithm>
#include <bit>
#include <chrono>
#include <numeric>

namespace tightflip::kernel {
namespace {

using Clock = std::chrono::steady_clock;
using VertexMap = std::vector<std::uint8_t>;

constexpr std::string_view checkpoint_kind = "tightflip labelled 1";

/// What the automorphisms of a class do to its canonically numbered vertices.
std::vector<VertexMap> vertex_automorphisms(const ClassGraph& classes, std::size_t state) {
    std::vector<HalfedgeRecord> records;
    decode(classes.code(state), records);
    std::vector<std::uint8_t> code(classes.code_length());
    CanonicalSearch search;
    search(records, classes.vertex_count, {Labels::ignored, Mirror::distinct},
           std::span<std::uint8_t>(code));
    RootedWalk walk;
    std::vector<VertexMap> maps;
    VertexMap numbers;
    for (const Root root : search.best_roots()) {
        number_vertices(walk, records, root, classes.vertex_count, numbers);
        if (std::ranges::find(maps, numbers) == maps.end()) maps.push_back(numbers);
    }
    return maps;
}

}  // namespace

std::uint64_t LabelledLevels::total() const noexcept {
    return std::accumulate(states.begin(), states.end(), std::uint64_t{0});
}

std::uint64_t labelled_search_bytes(Index vertices, std::size_t classes) {
    const std::size_t arrays = 3;  // visited, and the exchange's two levels
    std::uint64_t words = 1;       // V! / k! words a class
    for (Index v = 5; v <= vertices; ++v)
        words *= static_cast<std::uint64_t>(v);
    return arrays * classes * words * sizeof(LabelWord);
}

LabelledSearch::LabelledSearch(const ClassGraph& classes)
    : classes_(classes), words_(classes.vertex_count), labellings_(1) {
    for (Index v = 2; v <= classes.vertex_count; ++v)
        labellings_ *= static_cast<std::uint64_t>(v);
    for (std::size_t state = 0; state < classes.size(); ++state) {
        automorphisms_.push_back(vertex_automorphisms(classes, state));
        effective_symmetries_.push_back(static_cast<std::uint32_t>(automorphisms_.back().size()));
    }
}

LabelledLevels LabelledSearch::run(std::uint32_t source, FrontierExchange& exchange,
                                   const ExplorationLimits& limits) {
    const Clock::time_point began = Clock::now();
    const auto seconds_since = [](Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    };
    const unsigned workers = thread_count(limits.threads);
    const bool keeps = !limits.checkpoint_directory.empty();
    const auto file = limits.checkpoint_directory / "labelled.checkpoint";

    LabelledLevels levels;
    levels.source = source;
    if (!keeps || !resume(exchange, levels, file)) start(source, exchange, levels);
    const std::uint64_t resumed = levels.total();
    const auto own = exchange.own_classes();
    std::vector<Scratch> scratch(workers);
    Clock::time_point kept = Clock::now();
    while (levels.states.back() > 0) {
        is_busy_.assign(classes_.size() * words_.set_count(), 0);
        for_each_task(workers, classes_.size(), [&](unsigned, std::size_t state) {
            const auto c = static_cast<std::uint32_t>(state);
            mark_busy_sets(c, exchange.block(c));
        });
        std::atomic<std::uint64_t> found = 0;
        const auto level = static_cast<std::uint8_t>(levels.states.size());
        for_each_task(workers, own.size(), [&](unsigned worker, std::size_t i) {
            const std::uint64_t states = expand(i, exchange, scratch[worker]);
            if (states > 0) levels.farthest[own[i]] = level;
            found += states;
            if (limits.interrupted && limits.interrupted()) {
                throw ExplorationStopped(ExplorationStopped::Reason::interrupted,
                                         "interrupted at distance " + std::to_string(level) +
                                             " with " + std::to_string(levels.total()) +
                                             " labelled surfaces reached");
            }
        });
        levels.states.push_back(exchange.advance(found));
        if (limits.progress) {
            limits.progress(
                {"labelled surfaces", levels.total(), 0, seconds_since(began), resumed});
        }
        const bool is_last = levels.states.back() == 0;
        if (keeps && (is_last || seconds_since(kept) >= limits.checkpoint_seconds)) {
            keep(exchange, levels, file);
            kept = Clock::now();
        }
    }
    levels.states.pop_back();
    return levels;
}

void LabelledSearch::start(std::uint32_t source, FrontierExchange& exchange,
                           LabelledLevels& levels) {
    levels.farthest.assign(classes_.size(), LabelledLevels::unreached);
    const auto own = exchange.own_classes();
    visited_.assign(own.size() * words_.size(), 0);
    is_full_.assign(own.size() * words_.set_count(), 0);
    std::uint64_t found = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const std::uint32_t state = own[i];
        const auto block = exchange.next_block(state);
        std::ranges::fill(block, LabelWord{0});
        if (state != source) continue;
        for (const VertexMap& labels : automorphisms_[state]) {
            const auto [word, bit] = words_.place(labels);
            block[word] |= bit;
            visited_[i * words_.size() + word] |= bit;
        }
        levels.farthest[state] = 0;
        found = 1;
    }
    levels.states = {exchange.advance(found)};
}

void LabelledSearch::mark_busy_sets(std::uint32_t state, std::span<const LabelWord> block) {
    const std::size_t width = words_.words_per_set();
    for (std::size_t set = 0; set < words_.set_count(); ++set) {
        const auto words = block.subspan(set * width, width);
        is_busy_[state * words_.set_count() + set] =
            std::ranges::any_of(words, [](LabelWord word) { return word != 0; }) ? 1 : 0;
    }
}

std::uint64_t LabelledSearch::expand(std::size_t own_place, FrontierExchange& exchange,
                                     Scratch& scratch) {
    const std::uint32_t state = exchange.own_classes()[own_place];
    const auto full =
        std::span(is_full_).subspan(own_place * words_.set_count(), words_.set_count());
    scratch.found.assign(words_.size(), 0);
    const std::uint64_t first_arc = classes_.arcs.offsets[state];
    for (std::uint64_t arc = first_arc; arc < classes_.arcs.offsets[state + 1]; ++arc) {
        gather(static_cast<std::size_t>(arc), full, exchange, scratch.found);
    }
    const auto next = exchange.next_block(state);
    const std::span<LabelWord> visited =
        std::span(visited_).subspan(own_place * words_.size(), words_.size());
    const std::size_t width = words_.words_per_set();
    std::uint64_t found = 0;
    for (std::size_t set = 0; set < words_.set_count(); ++set) {
        LabelWord all = words_.full();
        for (std::size_t w = set * width; w < (set + 1) * width; ++w) {
            next[w] = scratch.found[w] & ~visited[w];
            visited[w] |= next[w];
            all &= visited[w];
            found += static_cast<std::uint64_t>(std::popcount(next[w]));
        }
        full[set] = all == words_.full() ? 1 : 0;
    }
    return found / effective_symmetries_[state];
}

/// Every flip has an inverse, so what arcs lead to a class from the frontier can be read off the
/// arcs that leave it.
void LabelledSearch::gather(std::size_t arc, std::span<const std::uint8_t> full,
                            const FrontierExchange& exchange, std::span<LabelWord> found) const {
    const std::uint32_t target = classes_.arcs.targets[arc];
    const auto relabelling = classes_.relabelling(arc);
    const std::size_t sets = words_.set_count();
    const std::size_t width = words_.words_per_set();
    const auto busy = std::span(is_busy_).subspan(target * sets, sets);
    const auto block = exchange.block(target);
    for (std::size_t set = 0; set < sets; ++set) {
        if (full[set] != 0) continue;
        const LabelWords::Move move = words_.move(set, relabelling);
        if (busy[move.set] == 0) continue;
        const LabelWord* const from = block.data() + move.set * width;
        LabelWord* const to = found.data() + set * width;
        const BitPermutation& pull = *move.pull;
        for (std::size_t w = 0; w < width; ++w) {
            if (const LabelWord word = from[move.word[w]]; word != 0) to[w] |= pull(word);
        }
    }
}

void LabelledSearch::keep(const FrontierExchange& exchange, const LabelledLevels& levels,
                          const std::filesystem::path& file) const {
    write_file(file, [&](std::ostream& out) {
        CheckpointWriter writer(out, checkpoint_kind);
        writer.array(std::vector<std::uint64_t>{static_cast<std::uint64_t>(words_.vertices()),
                                                classes_.size(), levels.source});
        writer.array(classes_.codes);
        writer.array(levels.states);
        writer.array(levels.farthest);
        writer.array(visited_);
        writer.array(is_full_);
        for (const std::uint32_t state : exchange.own_classes()) {
            writer.array(exchange.block(state));
        }
        writer.finish();
    });
}

bool LabelledSearch::resume(FrontierExchange& exchange, LabelledLevels& levels,
                            const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return false;
    CheckpointReader reader(file, checkpoint_kind);
    std::vector<std::uint64_t> parameters;
    std::vector<std::uint8_t> codes;
    reader.array(parameters);
    reader.array(codes);
    if (parameters != std::vector<std::uint64_t>{static_cast<std::uint64_t>(words_.vertices()),
                                                 classes_.size(), levels.source} ||
        codes != classes_.codes) {
        reader.refuse("belongs to a run with other parameters");
    }
    reader.array(levels.states);
    reader.array(levels.farthest);
    visited_.resize(exchange.own_classes().size() * words_.size());
    reader.array(std::span(visited_));
    reader.array(is_full_);
    for (const std::uint32_t state : exchange.own_classes()) {
        reader.array(exchange.next_block(state));
    }
    reader.finish();
    exchange.advance(0);
    return true;
}

}  // namespace tightflip::kernel
