/// \file
/// What the conformance suite asks of a mesh kernel, and the codes of what it may find.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tightflip::properties {

/// What is asked of a kernel. Fixed order.
enum class KernelProperty : std::uint8_t {
    reading,     ///< it holds the surface it was given, and counts it right
    topology,    ///< flips keep the counts, Euler characteristic, connectedness, orientability
    locality,    ///< nothing outside the two faces at the edge changes
    definition,  ///< a flip is the diagonal flip
    inverse,     ///< flipping the new edge gives the old surface; four times, the old sides
    handles,     ///< sides of other edges keep their meaning
    legality,    ///< yes only where the result is valid in the class; no only where it is not
    validator,   ///< is_valid() tells valid from invalid, as the audit does
    agreement,   ///< step by step like this library's kernel
    survival,    ///< no exception, crash or endless loop
};

/// How often each property was put to the test, in their order.
using Questions = std::array<std::size_t, 10>;

/// Stable codes; hundreds name the property.
enum class KernelCode : std::uint16_t {
    start_differs = 101,
    sides_unreadable = 102,
    counts_differ = 103,

    topology_changed = 201,
    changed_elsewhere = 301,
    not_the_flip = 401,

    flip_back_refused = 501,
    flip_back_differs = 502,
    four_flips_differ = 503,

    side_moved = 601,

    invalid_flip_allowed = 701,
    valid_flip_refused = 702,

    invalid_accepted = 801,
    valid_rejected = 802,
    wrong_origin_accepted = 811,
    wrong_next_accepted = 812,
    wrong_across_accepted = 813,
    forbidden_edge_accepted = 814,  ///< a double edge, or a loop, that the class forbids

    answers_differ_from_ours = 901,
    surface_differs_from_ours = 902,

    threw = 1001,
    crashed_or_hung = 1002,
    crashed_or_hung_on_damage = 1003,  ///< the validator, on a planted fault
};

[[nodiscard]] std::string_view name(KernelProperty property) noexcept;
[[nodiscard]] std::string_view name(KernelCode code) noexcept;
[[nodiscard]] KernelProperty property_of(KernelCode code) noexcept;
/// What the property asks, in a line.
[[nodiscard]] std::string_view describe(KernelProperty property) noexcept;
/// Why the property may not have been put to the test: "no flip was done".
[[nodiscard]] std::string_view why_not_asked(KernelProperty property) noexcept;
[[nodiscard]] std::span<const KernelProperty> all_kernel_properties() noexcept;

}  // namespace tightflip::properties
