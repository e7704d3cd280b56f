#include <tightflip/kernel/label_words.hpp>

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>

namespace tightflip::kernel {
namespace {

using Sequence = std::array<std::uint8_t, LabelWords::max_vertices>;

/// Two sequences, of what belongs to low labels and of the rest.
class Parted {
public:
    void add(std::uint8_t item, bool is_low) noexcept {
        (is_low ? low_[lows_++] : high_[highs_++]) = item;
    }
    [[nodiscard]] std::span<const std::uint8_t> low() const noexcept {
        return {low_.data(), lows_};
    }
    [[nodiscard]] std::span<const std::uint8_t> high() const noexcept {
        return {high_.data(), highs_};
    }

private:
    Sequence low_{};
    Sequence high_{};
    std::size_t lows_ = 0;
    std::size_t highs_ = 0;
};

/// The number itself, where tables for so many vertices can be made.
Index checked(Index vertices) {
    if (vertices <= LabelWords::max_vertices) return vertices;
    throw std::invalid_argument("labellings of more than " +
                                std::to_string(LabelWords::max_vertices) +
                                " vertices are not kept");
}

std::size_t factorial_of(std::size_t n) {
    return n < 2 ? 1 : n * factorial_of(n - 1);
}

}  // namespace

BitPermutation::BitPermutation(std::span<const std::uint8_t> source) noexcept {
    std::array<LabelWord, 24> image{};  // of each single bit
    for (std::size_t b = 0; b < source.size(); ++b)
        image[source[b]] |= LabelWord{1} << b;
    for (std::size_t part = 0; part < part_.size(); ++part) {
        for (std::size_t value = 1; value < 256; ++value) {
            const auto lowest = static_cast<std::size_t>(std::countr_zero(value));
            part_[part][value] = part_[part][value & (value - 1)] | image[8 * part + lowest];
        }
    }
}

LabelWords::Arrangements::Arrangements(std::size_t n)
    : size_(factorial_of(n)), moved_(size_ * size_) {
    Sequence sequence{};
    const auto end = sequence.begin() + static_cast<std::ptrdiff_t>(n);
    std::iota(sequence.begin(), end, std::uint8_t{0});
    std::vector<Sequence> all;
    do {
        all.push_back(sequence);
    } while (std::next_permutation(sequence.begin(), end));
    for (std::size_t p = 0; p < size_; ++p) {
        for (std::size_t a = 0; a < size_; ++a) {
            Sequence image{};
            for (std::size_t i = 0; i < n; ++i)
                image[all[p][i]] = all[a][i];
            moved_[p * size_ + a] = static_cast<std::uint16_t>(number({image.data(), n}));
        }
    }
}

std::size_t LabelWords::Arrangements::number(
    std::span<const std::uint8_t> sequence) const noexcept {
    std::size_t number = 0;  // lexicographic, in factorial digits
    for (std::size_t i = 0; i < sequence.size(); ++i) {
        std::size_t smaller = 0;
        for (std::size_t j = i + 1; j < sequence.size(); ++j) {
            smaller += sequence[j] < sequence[i] ? 1 : 0;
        }
        number = number * (sequence.size() - i) + smaller;
    }
    return number;
}

LabelWords::LabelWords(Index vertices)
    : vertices_(checked(vertices)),
      low_(static_cast<std::size_t>(std::min<Index>(vertices, 4))),
      low_arrangements_(low_),
      high_arrangements_(static_cast<std::size_t>(vertices) - low_),
      words_per_set_(high_arrangements_.size()),
      full_(static_cast<LabelWord>((std::uint64_t{1} << low_arrangements_.size()) - 1)),
      number_of_set_(std::size_t{1} << vertices) {
    for (std::uint32_t mask = 0; mask < number_of_set_.size(); ++mask) {
        if (static_cast<std::size_t>(std::popcount(mask)) != low_) continue;
        number_of_set_[mask] = static_cast<std::uint16_t>(sets_.size());
        sets_.push_back(mask);
    }
    for (std::size_t p = 0; p < low_arrangements_.size(); ++p) {
        const auto moved = low_arrangements_.moved(p);
        const std::vector<std::uint8_t> source(moved.begin(), moved.end());
        pulls_.emplace_back(source);
    }
}

LabelWords::Place LabelWords::place(std::span<const std::uint8_t> labels) const {
    Parted parted;
    std::uint32_t mask = 0;
    for (std::size_t v = 0; v < labels.size(); ++v) {
        const bool is_low = labels[v] < low_;
        parted.add(labels[v], is_low);
        if (is_low) mask |= 1U << v;
    }
    return {number_of_set_[mask] * words_per_set_ + high_arrangements_.number(parted.high()),
            LabelWord{1} << low_arrangements_.number(parted.low())};
}

LabelWords::Move LabelWords::move(std::size_t set,
                                  std::span<const std::uint8_t> to) const noexcept {
    // The places of either kind, in ascending order, go to places whose order is the permutation.
    Parted parted;
    std::uint32_t mask = 0;
    for (std::size_t v = 0; v < to.size(); ++v) {
        const bool is_low = (sets_[set] >> v & 1U) != 0;
        parted.add(to[v], is_low);
        if (is_low) mask |= 1U << to[v];
    }
    return {number_of_set_[mask],
            high_arrangements_.moved(high_arrangements_.number(parted.high())),
            &pulls_[low_arrangements_.number(parted.low())]};
}

}  // namespace tightflip::kernel
