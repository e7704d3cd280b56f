/// \file
/// The allowed class of surfaces (Definition 4.1 of Alboul et al.), in one place.
///
/// A surface is allowed when it is connected, every side of every face has a neighbour, the faces
/// about every vertex form one cycle, and each face obeys the two rules below. The flip asks this
/// file whether its result would be allowed; the audit asks it whether what it sees is allowed.
#pragma once

#include <tightflip/kernel/handles.hpp>

namespace tightflip::kernel {

/// A face has three distinct corners, so no edge is a loop.
template <class Label>
[[nodiscard]] constexpr bool corners_are_distinct(Label a, Label b, Label c) noexcept {
    return a != b && b != c && c != a;
}

/// The three-neighbour rule of Definition 4.1: a face has three neighbours other than itself, of
/// which two may coincide but not all three. For four or more vertices it follows from the other
/// rules (three coinciding neighbours make a component of two faces); the sphere with 3 vertices
/// and 2 faces is its one exception and passes by name.
[[nodiscard]] constexpr bool three_neighbour_rule(Index face, Index n0, Index n1, Index n2,
                                                  bool is_two_face_sphere) noexcept {
    const bool has_itself = n0 == face || n1 == face || n2 == face;
    const bool all_coincide = n0 == n1 && n1 == n2;
    return !has_itself && (!all_coincide || is_two_face_sphere);
}

/// Whether flipping edge ab between the faces (a, b, c) and (b, a, d) stays inside the class. The
/// new faces are (d, c, a) and (c, d, b); given that the old ones had distinct corners, theirs are
/// distinct exactly when c and d differ. Nothing else can go wrong: parallel edges and vertices of
/// degree 2 are allowed.
template <class Label>
[[nodiscard]] constexpr bool flip_keeps_corners_distinct(Label c, Label d) noexcept {
    return c != d;
}

}  // namespace tightflip::kernel
