#include "svg_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tightflip::geometry {
namespace {

/// A kind of UTF-8 sequence: how it begins, how long it is, and the least number it may stand for.
struct Sequence {
    unsigned mask;
    unsigned lead;
    std::size_t length;
    std::uint32_t least;
};
constexpr std::array<Sequence, 4> sequences{{{0x80, 0x00, 1, 0x0},
                                             {0xE0, 0xC0, 2, 0x80},
                                             {0xF0, 0xE0, 3, 0x800},
                                             {0xF8, 0xF0, 4, 0x10000}}};

bool is_allowed(std::uint32_t character) {
    if (character < 0x20) return character == '\t' || character == '\n' || character == '\r';
    const bool is_surrogate = character >= 0xD800 && character < 0xE000;
    return !is_surrogate && character != 0xFFFE && character != 0xFFFF && character < 0x110000;
}

/// The bytes of the character that a text begins with; 0 where it begins with none allowed.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (const auto& [mask, lead, length, least] : sequences) {
        if ((byte(0) & mask) != lead) continue;
        if (text.size() < length) return 0;
        std::uint32_t character = byte(0) & (0xFFU & ~mask);
        for (std::size_t i = 1; i < length; ++i) {
            if ((byte(i) & 0xC0U) != 0x80) return 0;
            character = character << 6U | (byte(i) & 0x3FU);
        }
        return character >= least && is_allowed(character) ? length : 0;
    }
    return 0;
}

}  // namespace

void append_pixels(std::string& text, double value) {
    constexpr double most = 1e6;
    constexpr long parts = 100;
    if (std::isnan(value)) value = 0;
    const long hundredths = std::lround(std::clamp(value, -most, most) * parts);
    if (hundredths < 0) text += '-';
    const long size = std::labs(hundredths);
    text += std::to_string(size / parts);
    if (size % parts == 0) return;
    text += '.';
    text += std::to_string(size % parts / 10);
    if (size % 10 != 0) text += std::to_string(size % 10);
}

void append_place(std::string& text, double x, double y) {
    if (!text.empty() && text.back() >= '0' && text.back() <= '9') text += ' ';
    append_pixels(text, x);
    text += ' ';
    append_pixels(text, y);
}

void append_attribute(std::string& text, std::string_view name, double pixels) {
    text += ' ';
    text += name;
    text += "=\"";
    append_pixels(text, pixels);
    text += '"';
}

std::string xml_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const std::string_view character = text.substr(0, length);
        if (length == 0) {
            result += '?';
        } else if (character == "&") {
            result += "&amp;";
        } else if (character == "<") {
            result += "&lt;";
        } else if (character == ">") {
            result += "&gt;";
        } else {
            result += character;
        }
        text.remove_prefix(std::max<std::size_t>(1, length));
    }
    return result;
}

}  // namespace tightflip::geometry
