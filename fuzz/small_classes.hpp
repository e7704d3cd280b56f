/// \file
/// All triangulations of a few sizes up to isomorphism, as starts and flips that lead to them: for
/// seeds.
#pragma once

#include "script_input.hpp"

#include <string>
#include <vector>

namespace tightflip::fuzz {

/// A class: the flips lead from the start to one surface of it, and none of them is refused.
struct SmallClass {
    std::string name;  ///< say "class_genus_1_vertices_4_number_3"
    StartBytes start;
    std::vector<std::uint32_t> flips;
};

/// Every class (mirror images apart) of the sphere with 3 to 6 vertices and of the torus with 3 and
/// 4, in an order that is always the same. 29 classes.
[[nodiscard]] std::vector<SmallClass> small_classes();

}  // namespace tightflip::fuzz
