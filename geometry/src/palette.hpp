/// \file
/// The colours of drawings, told apart by colour-blind readers (after Okabe and Ito) and on paper.
#pragma once

#include <tightflip/geometry/curvature.hpp>

#include <array>
#include <string>
#include <string_view>

namespace tightflip::geometry::palette {

/// Red, green and blue in 0 .. 1.
using Colour = Eigen::Array3d;

[[nodiscard]] std::string hexadecimal(const Colour& colour);
/// The fill of a face on which light falls with this strength, 0 .. 1.
[[nodiscard]] Colour face(bool is_front, double light);
/// For a value in -1 .. 1: from blue over nearly white to red.
[[nodiscard]] Colour diverging(double value);

enum class Mark : std::uint8_t { circle, diamond, square };

struct VertexLook {
    std::string_view fill;
    std::string_view outline;
    Mark mark;
    double size;  ///< relative to others
};
/// In the order of VertexType.
inline constexpr std::array<VertexLook, 4> vertices{{{"#0072b2", "#fff", Mark::circle, 1},
                                                     {"#e69f00", "#222", Mark::diamond, 1.35},
                                                     {"#009e73", "#fff", Mark::square, 0.95},
                                                     {"#fff", "#555", Mark::circle, 0.8}}};

struct EdgeLook {
    std::string_view colour;
    double width;           ///< relative to others
    std::string_view dash;  ///< in widths of others; empty for a full line
};
/// In the order of EdgeShape.
inline constexpr std::array<EdgeLook, 5> edges{{{"#333", 1, ""},
                                                {"#d55e00", 2.4, ""},
                                                {"#7d7d7d", 0.8, ""},
                                                {"#6a2c91", 2.4, ""},
                                                {"#000", 1.6, "1 3"}}};

}  // namespace tightflip::geometry::palette
