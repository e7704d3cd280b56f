/// \file
/// Distances in the flip graph of labelled surfaces, from the graph of their classes.
///
/// A labelled surface is a class with labels on the vertices of its canonical numbering, up to the
/// class's automorphisms. A flip leads from class to class and carries the labels along by one
/// relabelling, the same for all V! labellings. So only classes are flipped; labelled surfaces are
/// bits, and a level of the search moves them a word at a time. Of two labellings that an
/// automorphism joins both are marked, always together.
#pragma once

#include <tightflip/kernel/class_graph.hpp>
#include <tightflip/kernel/frontier_exchange.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tightflip::kernel {

/// What one search found.
struct LabelledLevels {
    std::uint32_t source = 0;           ///< the class that was started from
    std::vector<std::uint64_t> states;  ///< labelled surfaces at each distance
    /// By class its greatest distance, or `unreached`; of this process's own classes.
    std::vector<std::uint8_t> farthest;

    static constexpr std::uint8_t unreached = 255;

    [[nodiscard]] std::uint64_t total() const noexcept;
    /// The greatest distance from the source.
    [[nodiscard]] std::size_t eccentricity() const noexcept { return states.size() - 1; }
};

/// Bytes that a search over `classes` classes holds.
[[nodiscard]] std::uint64_t labelled_search_bytes(Index vertices, std::size_t classes);

class LabelledSearch {
public:
    /// Precondition: the graph keeps relabellings, tells mirror images apart, and outlives the
    /// search. The exchange has blocks of `label_words().size()` words for each class.
    explicit LabelledSearch(const ClassGraph& classes);

    [[nodiscard]] const LabelWords& label_words() const noexcept { return words_; }
    /// Labelled surfaces of a class: V! over the order of the group that its automorphisms induce
    /// on vertices.
    [[nodiscard]] std::uint64_t states_of(std::uint32_t state) const noexcept {
        return labellings_ / effective_symmetries_[state];
    }

    /// The distances from a labelled surface of the class `source` (from which does not matter).
    /// Cost: one word operation for k! labellings of each arc, at every level at which both its
    /// ends have something to do. Throws ExplorationStopped when interrupted.
    [[nodiscard]] LabelledLevels run(std::uint32_t source, FrontierExchange& exchange,
                                     const ExplorationLimits& limits);

private:
    struct Scratch {
        std::vector<LabelWord> found;
    };

    void start(std::uint32_t source, FrontierExchange& exchange, LabelledLevels& levels);
    std::uint64_t expand(std::size_t own_place, FrontierExchange& exchange, Scratch& scratch);
    void gather(std::size_t arc, std::span<const std::uint8_t> full,
                const FrontierExchange& exchange, std::span<LabelWord> found) const;
    void mark_busy_sets(std::uint32_t state, std::span<const LabelWord> block);
    void keep(const FrontierExchange& exchange, const LabelledLevels& levels,
              const std::filesystem::path& file) const;
    bool resume(FrontierExchange& exchange, LabelledLevels& levels,
                const std::filesystem::path& file);

    const ClassGraph& classes_;
    LabelWords words_;
    std::uint64_t labellings_;
    std::vector<std::vector<std::vector<std::uint8_t>>> automorphisms_;  // on vertices, by class
    std::vector<std::uint32_t> effective_symmetries_;
    std::vector<LabelWord> visited_;     // by own class and word
    std::vector<std::uint8_t> is_busy_;  // by class and set: the level has labellings there
    std::vector<std::uint8_t> is_full_;  // by own class and set: all labellings are visited
};

}  // namespace tightflip::kernel
