/// \file
/// A stream of random numbers that is the same on every machine and compiler.
///
/// The standard library's engines are portable but its distributions are not; here both the
/// generator (SplitMix64: Steele, Lea and Flood, OOPSLA 2014) and the choice below a bound (Lemire,
/// ACM TOMACS 29 (2019)) are fixed, so a seed names one run for ever.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

namespace tightflip::kernel {

/// A bijection of 64-bit words that spreads every input bit over all output bits.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t z) noexcept {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

/// A seeded stream; copies continue independently from the same place.
class RandomStream {
public:
    constexpr explicit RandomStream(std::uint64_t seed) noexcept : state_(seed) {}

    /// 64 random bits.
    constexpr std::uint64_t bits() noexcept { return mix(state_ += 0x9e3779b97f4a7c15ULL); }

    /// Uniform in 0 .. bound - 1, without bias. Precondition: bound > 0.
    constexpr std::uint32_t below(std::uint32_t bound) noexcept {
        std::uint64_t product = (bits() >> 32) * bound;
        if (static_cast<std::uint32_t>(product) < bound) {
            const std::uint32_t threshold = (0U - bound) % bound;
            while (static_cast<std::uint32_t>(product) < threshold) {
                product = (bits() >> 32) * bound;
            }
        }
        return static_cast<std::uint32_t>(product >> 32);
    }

    /// A uniformly random order (Fisher and Yates).
    template <class T>
    constexpr void shuffle(std::span<T> items) noexcept {
        for (std::size_t n = items.size(); n > 1; --n) {
            std::swap(items[n - 1], items[below(static_cast<std::uint32_t>(n))]);
        }
    }

private:
    std::uint64_t state_;
};

}  // namespace tightflip::kernel
