/// \file
/// All labellings of V vertices as the bits of an array of words, and how relabellings move them.
///
/// A labelling gives each of V numbered places a label. Its low labels 0 .. k - 1 (k is 4, or V
/// where that is less) stand at some k places: which ones is the labelling's set; how the low
/// labels are arranged there is one of k! bits in a word, and how the others are arranged elsewhere
/// picks one of (V - k)! words. Moving places by one relabelling keeps sets and words together: it
/// sends a set to a set, all words of the one to words of the other, and the bits of all these
/// words by one permutation. So labellings are moved k! at a time.
#pragma once

#include <tightflip/kernel/handles.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tightflip::kernel {

/// k! labellings, one a bit.
using LabelWord = std::uint32_t;

/// A permutation of the bits of a word.
class BitPermutation {
public:
    /// Bit b of the result is bit source[b] of what it is applied to.
    explicit BitPermutation(std::span<const std::uint8_t> source) noexcept;
    [[nodiscard]] LabelWord operator()(LabelWord word) const noexcept {
        return part_[0][word & 0xff] | part_[1][word >> 8 & 0xff] | part_[2][word >> 16];
    }

private:
    std::array<std::array<LabelWord, 256>, 3> part_{};
};

class LabelWords {
public:
    /// Precondition: 1 <= vertices <= max_vertices. The tables take (V - k)!^2 * 2 bytes.
    explicit LabelWords(Index vertices);

    /// Beyond it the words of a single class would pass a gigabyte.
    static constexpr Index max_vertices = 11;

    [[nodiscard]] Index vertices() const noexcept { return vertices_; }
    /// Words for one class: all V! labellings.
    [[nodiscard]] std::size_t size() const noexcept { return sets_.size() * words_per_set_; }
    [[nodiscard]] std::size_t set_count() const noexcept { return sets_.size(); }
    [[nodiscard]] std::size_t words_per_set() const noexcept { return words_per_set_; }
    /// A word in which all k! bits are set.
    [[nodiscard]] LabelWord full() const noexcept { return full_; }

    struct Place {
        std::size_t word;
        LabelWord bit;
    };
    /// Where a labelling stands: labels[v] is the label of place v.
    [[nodiscard]] Place place(std::span<const std::uint8_t> labels) const;

    /// What a relabelling, which sends place v to place to[v], does to the labellings of one set.
    struct Move {
        std::size_t set;                      ///< the set they go to
        std::span<const std::uint16_t> word;  ///< word w of the old set goes to word[w] of the new
        const BitPermutation* pull;           ///< takes a word of the new set back to the old
    };
    [[nodiscard]] Move move(std::size_t set, std::span<const std::uint8_t> to) const noexcept;

private:
    /// What the arrangements of n things become when their places are permuted.
    class Arrangements {
    public:
        explicit Arrangements(std::size_t n);
        [[nodiscard]] std::size_t size() const noexcept { return size_; }
        /// The number of the arrangement of sequence[0 .. n - 1] by size; n >= 0.
        [[nodiscard]] std::size_t number(std::span<const std::uint8_t> sequence) const noexcept;
        /// Row of a permutation of places: entry a is what arrangement a becomes.
        [[nodiscard]] std::span<const std::uint16_t> moved(std::size_t permutation) const noexcept {
            return {moved_.data() + permutation * size_, size_};
        }

    private:
        std::size_t size_ = 1;
        std::vector<std::uint16_t> moved_;
    };

    Index vertices_;
    std::size_t low_;
    Arrangements low_arrangements_;
    Arrangements high_arrangements_;
    std::size_t words_per_set_;
    LabelWord full_;
    std::vector<std::uint32_t> sets_;           // as masks of places, ascending
    std::vector<std::uint16_t> number_of_set_;  // by mask
    std::vector<BitPermutation> pulls_;         // by permutation of the low places
};

}  // namespace tightflip::kernel
