/// \file
/// The names that files and pictures have for types and shapes.
#pragma once

#include <tightflip/geometry/curvature.hpp>
#include <tightflip/geometry/quadrilateral.hpp>

#include <array>
#include <string_view>

namespace tightflip::geometry {

/// In the order of the enumeration.
inline constexpr std::array<std::string_view, 4> vertex_type_names{"convex", "saddle", "mixed",
                                                                   "flat"};
inline constexpr std::array<std::string_view, 5> edge_shape_names{"convex", "concave", "flat",
                                                                  "folded", "degenerate"};
inline constexpr std::array<std::string_view, 5> quadrilateral_type_names{"CC", "CR", "RC", "RR",
                                                                          "none"};

[[nodiscard]] constexpr std::string_view name(VertexType type) {
    return vertex_type_names.at(static_cast<std::size_t>(type));
}
[[nodiscard]] constexpr std::string_view name(EdgeShape shape) {
    return edge_shape_names.at(static_cast<std::size_t>(shape));
}
[[nodiscard]] constexpr std::string_view name(QuadrilateralType type) {
    return quadrilateral_type_names.at(static_cast<std::size_t>(type));
}

}  // namespace tightflip::geometry
