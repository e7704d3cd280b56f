/// \file
/// What a criterion measures, and by how much a flip changes it.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <limits>

namespace tightflip::geometry {

/// Compared level by level, the first first. Plain criteria use the first level alone.
struct Energy {
    static constexpr std::size_t max_levels = 3;

    std::array<double, max_levels> levels{};

    constexpr Energy() noexcept = default;
    constexpr Energy(double first) noexcept  // NOLINT(google-explicit-constructor)
        : levels{first} {}

    /// The change that a flip would make which the criterion does not allow.
    [[nodiscard]] static constexpr Energy forbidden() noexcept {
        return std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] constexpr bool is_forbidden() const noexcept { return *this == forbidden(); }
    /// The first level, which is all of a plain criterion's.
    [[nodiscard]] constexpr double first() const noexcept { return levels[0]; }

    constexpr Energy& operator+=(const Energy& other) noexcept {
        for (std::size_t i = 0; i < max_levels; ++i)
            levels[i] += other.levels[i];
        return *this;
    }
    constexpr Energy& operator*=(double factor) noexcept {
        for (double& level : levels)
            level *= factor;
        return *this;
    }
    friend constexpr Energy operator+(Energy a, const Energy& b) noexcept { return a += b; }
    friend constexpr Energy operator*(double factor, Energy a) noexcept { return a *= factor; }
    friend constexpr Energy operator-(const Energy& a, const Energy& b) noexcept {
        return a + -1.0 * b;
    }
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the ordering's 0 for a pointer
    friend constexpr auto operator<=>(const Energy&, const Energy&) noexcept = default;
    friend constexpr bool operator==(const Energy&, const Energy&) noexcept = default;
};

}  // namespace tightflip::geometry
