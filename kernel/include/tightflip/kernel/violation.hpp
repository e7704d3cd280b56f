/// \file
/// The stable codes of everything that can be wrong with a surface, and a finding that carries one.
#pragma once

#include <tightflip/kernel/handles.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::kernel {

/// Hundreds name the rung of the ladder; 90x compare a surface with an earlier one, 91x judge
/// flips by their definition and laws. Numbers are never reused; docs/formats.md lists them.
enum class ViolationCode : std::uint16_t {
    no_faces = 101,
    corner_out_of_range = 102,
    gluing_out_of_range = 103,
    more_vertices_than_corners = 104,
    halfedge_count_odd = 111,
    next_out_of_range = 112,
    next_cycle_not_triangle = 113,
    origin_out_of_range = 114,

    side_glued_to_itself = 201,
    gluing_not_involution = 202,
    side_unglued = 203,
    edge_in_more_than_two_faces = 204,
    directed_edge_repeats = 205,

    labels_disagree = 301,
    coherence_bit_contradicts_labels = 302,

    corners_not_distinct = 401,

    three_neighbour_rule_broken = 501,

    vertex_unused = 601,
    vertex_with_several_fans = 602,

    vertices_not_connected = 701,
    faces_not_strongly_connected = 702,

    not_orientable = 801,

    vertex_count_changed = 901,
    edge_count_changed = 902,
    face_count_changed = 903,
    component_count_changed = 904,
    euler_characteristic_changed = 905,
    orientability_changed = 906,
    genus_changed = 907,

    refusal_unjustified = 911,
    flip_not_as_defined = 912,
    reference_model_disagrees = 913,
    flip_law_broken = 914,
    log_not_reproduced = 915,
    path_does_not_connect = 916,
};

/// What an index in a violation counts.
enum class PlaceKind : std::uint8_t { surface, face, side, vertex, halfedge, edge };

/// One finding: a code, the place, and a witness where the code has one.
struct Violation {
    ViolationCode code{};
    PlaceKind kind = PlaceKind::surface;
    Index place = -1;              ///< index of the face, side (3 * face + i), vertex,
                                   ///< halfedge or edge
    std::int64_t found = 0;        ///< what was found there; its meaning depends on the code
    std::int64_t expected = 0;     ///< what should have been there, where the code compares
    std::vector<Index> witness{};  ///< see `describe(ViolationCode)`

    friend constexpr bool operator==(const Violation&, const Violation&) = default;
};

/// The order in which reports list violations: by code, then by place.
[[nodiscard]] constexpr bool precedes(const Violation& a, const Violation& b) noexcept {
    return a.code != b.code ? a.code < b.code : a.place < b.place;
}

/// The stable name of a code, e.g. "vertex_with_several_fans".
[[nodiscard]] std::string_view name(ViolationCode code) noexcept;
/// What the code means, in one line that fits every instance.
[[nodiscard]] std::string_view describe(ViolationCode code) noexcept;
/// Every code there is, in ascending order.
[[nodiscard]] std::vector<ViolationCode> all_violation_codes();

/// The place in words, e.g. "face 12, side 1".
[[nodiscard]] std::string where(const Violation& violation);
/// One line in plain words about this instance, witness included (cut short where it is long).
[[nodiscard]] std::string message(const Violation& violation);

}  // namespace tightflip::kernel
