/// \file
/// Raw gluing data, trusted by nobody: what a file, a fuzzer or another kernel says about faces.
///
/// Side i of a face runs from corner i to corner i + 1 (mod 3); side s of a gluing is side s % 3 of
/// face s / 3. A gluing can describe anything: non-orientable, disconnected or bounded surfaces,
/// loops, pinched vertices, contradictory tables. `audit` says which of these it is.
#pragma once

#include <tightflip/kernel/handles.hpp>

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace tightflip::kernel {

/// What one side says about the side it is glued to, packed in one integer. The coherence bit is
/// what the data claims; where the ends of an edge differ the corner labels decide, not the bit.
class SideGluing {
public:
    constexpr SideGluing() noexcept = default;  ///< unglued: a boundary side

    /// Glued to `side` in the opposite direction (both faces may keep their orientation).
    [[nodiscard]] static constexpr SideGluing coherent(Index side) noexcept {
        return SideGluing(2 * std::int64_t{side});
    }
    /// Glued to `side` in the same direction (one of the two faces is turned over).
    [[nodiscard]] static constexpr SideGluing reversed(Index side) noexcept {
        return SideGluing(2 * std::int64_t{side} + 1);
    }

    [[nodiscard]] constexpr bool is_glued() const noexcept { return code_ != unglued_code; }
    [[nodiscard]] constexpr bool is_reversed() const noexcept { return (code_ & 1) != 0; }
    /// The side named, which need not exist. Meaningful where `is_glued()`.
    [[nodiscard]] constexpr Index side() const noexcept { return static_cast<Index>(code_ >> 1); }

    friend constexpr bool operator==(SideGluing, SideGluing) noexcept = default;

private:
    static constexpr Index unglued_code = std::numeric_limits<Index>::min();
    constexpr explicit SideGluing(std::int64_t code) noexcept
        : code_(static_cast<Index>(code > max_code ? max_code | (code & 1)
                                                   : (code < 0 ? -2 + (code & 1) : code))) {}

    // Sides that cannot be packed stand as ones that cannot exist: beyond the largest, or side -1.
    static constexpr std::int64_t max_code = std::numeric_limits<Index>::max() - 1;

    Index code_ = unglued_code;
};

/// One face: three vertex labels and what its three sides are glued to.
struct GluedFace {
    std::array<Index, 3> corners{-1, -1, -1};
    std::array<SideGluing, 3> sides{};

    friend constexpr bool operator==(const GluedFace&, const GluedFace&) noexcept = default;
};

/// The most faces a gluing can address; every maker and reader keeps to it.
inline constexpr Index max_faces = (Index{1} << 30) / 3 - 1;

/// A set of glued faces over the vertices 0 .. vertex_count - 1.
struct Gluing {
    Index vertex_count = 0;
    std::vector<GluedFace> faces;

    friend constexpr bool operator==(const Gluing&, const Gluing&) noexcept = default;
};

/// A gluing in anybody's memory, for those who only read: a vector's, an array's, a mapped file's.
struct GluingView {
    Index vertex_count = 0;
    std::span<const GluedFace> faces;

    constexpr GluingView(Index vertices, std::span<const GluedFace> table) noexcept
        : vertex_count(vertices), faces(table) {}
    constexpr GluingView(const Gluing& gluing) noexcept  // NOLINT(google-explicit-constructor)
        : vertex_count(gluing.vertex_count), faces(gluing.faces) {}
};

[[nodiscard]] constexpr Index side_of(Index face, int i) noexcept {
    return 3 * face + i;
}
[[nodiscard]] constexpr Index face_of_side(Index side) noexcept {
    return side / 3;
}
[[nodiscard]] constexpr int corner_of_side(Index side) noexcept {
    return side % 3;
}

}  // namespace tightflip::kernel
