#include <tightflip/kernel/counting.hpp>

#include <array>
#include <numeric>
#include <span>

namespace tightflip::kernel {
namespace {

using Count = std::optional<std::uint64_t>;

/// value * product(factors) / product(divisors), where the quotient is whole; empty beyond 64 bits.
/// Divisors are cancelled before anything is multiplied, so only the result has to fit.
template <std::size_t N, std::size_t M>
Count scaled(std::uint64_t value, std::array<std::uint64_t, N> factors,
             std::array<std::uint64_t, M> divisors) {
    for (std::uint64_t& divisor : divisors) {
        const auto cancel = [&divisor](std::uint64_t& factor) {
            const std::uint64_t common = std::gcd(factor, divisor);
            factor /= common;
            divisor /= common;
        };
        cancel(value);
        for (std::uint64_t& factor : factors)
            cancel(factor);
    }
    for (const std::uint64_t factor : factors) {
        if (__builtin_mul_overflow(value, factor, &value)) return std::nullopt;
    }
    return value;
}

}  // namespace

std::optional<std::uint64_t> rooted_spheres(Index vertices) noexcept {
    Count count = 1;
    for (std::uint64_t k = 2; count && k + 2 <= static_cast<std::uint64_t>(vertices); ++k) {
        count = scaled(*count, std::array{std::uint64_t{3}, 3 * k - 1, 3 * k - 2},
                       std::array{k + 1, 2 * k + 1});
    }
    return count;
}

std::optional<std::uint64_t> rooted_simple_spheres(Index vertices) noexcept {
    Count count = 1;
    for (std::uint64_t n = 1; count && n + 3 <= static_cast<std::uint64_t>(vertices); ++n) {
        count = scaled(*count, std::array{4 * n + 1, 4 * n, 4 * n - 1, 4 * n - 2},
                       std::array{n + 1, 3 * n + 2, 3 * n + 1, 3 * n});
    }
    return count;
}

std::optional<std::uint64_t> factorial(Index vertices) noexcept {
    Count product = 1;
    for (std::uint64_t v = 2; product && v <= static_cast<std::uint64_t>(vertices); ++v) {
        product = scaled(*product, std::array{v}, std::array<std::uint64_t, 0>{});
    }
    return product;
}

std::optional<std::uint64_t> labelled_from_rooted(std::uint64_t rooted, Index vertices,
                                                  Index halfedges) noexcept {
    const Count relabellings = factorial(vertices);
    if (!relabellings) return std::nullopt;
    return scaled(rooted, std::array{*relabellings},
                  std::array{static_cast<std::uint64_t>(halfedges)});
}

}  // namespace tightflip::kernel
