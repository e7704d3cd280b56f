#include "palette.hpp"

#include <cmath>

namespace tightflip::geometry::palette {

std::string hexadecimal(const Colour& colour) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const double part : colour) {
        const auto value = static_cast<std::size_t>(std::lround(part * 255));
        text += digits[value / 16];
        text += digits[value % 16];
    }
    return text;
}

Colour face(bool is_front, double light) {
    static const Colour paper(0.965, 0.96, 0.94);
    static const Colour inner(0.80, 0.74, 0.68);
    constexpr double in_shadow = 0.72;
    return (is_front ? paper : inner) * (in_shadow + (1 - in_shadow) * light);
}

Colour diverging(double value) {
    static const Colour low(0.13, 0.40, 0.67);
    static const Colour middle(0.97, 0.97, 0.97);
    static const Colour high(0.70, 0.09, 0.17);
    // The root parts small values from zero: a few vertices often have most of the curvature.
    const double strength = std::sqrt(std::abs(value));
    return middle + strength * ((value < 0 ? low : high) - middle);
}

}  // namespace tightflip::geometry::palette
