/// \file
/// The tetrahedron of reading.hpp in every format, and the means to write binary files.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::geometry::samples {

/// The bytes of a number in one of the two orders.
template <class T>
std::string packed(T value, std::endian order = std::endian::little) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order != std::endian::native) std::ranges::reverse(raw);
    return {raw.begin(), raw.end()};
}

inline std::string obj() {
    return "# a tetrahedron\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 "
           "1 "
           "4\n";
}

inline std::string off() {
    return "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
}

inline std::string ply_header(std::string_view encoding) {
    return "ply\nformat " + std::string(encoding) +
           " 1.0\ncomment of no weight\nelement vertex 4\nproperty float x\nproperty float "
           "y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\n"
           "end_header\n";
}

inline std::string ply_ascii() {
    return ply_header("ascii") + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
}

inline std::string ply_binary(std::endian order) {
    std::string bytes =
        ply_header(order == std::endian::little ? "binary_little_endian" : "binary_big_endian");
    for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F})
        bytes += packed(x, order);
    for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
        bytes += '\3';
        for (const std::int32_t corner : face)
            bytes += packed(corner, order);
    }
    return bytes;
}

/// The same with the gluing of its sides.
inline std::string ply_glued(std::string_view encoding) {
    std::string header = ply_header(encoding);
    const std::string list = "property list uchar int glued_sides\n";
    header.insert(header.find("end_header"), list);
    constexpr std::array<std::array<std::int32_t, 6>, 4> rows{
        {{0, 2, 1, 9, 6, 3}, {0, 1, 3, 2, 8, 10}, {1, 2, 3, 1, 11, 4}, {2, 0, 3, 0, 5, 7}}};
    if (encoding == "ascii") {
        std::string text = header + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
        for (const auto& row : rows) {
            for (std::size_t i = 0; i < 6; ++i)
                text += (i % 3 == 0 ? "3 " : "") + std::to_string(row[i]) + (i < 5 ? " " : "\n");
        }
        return text;
    }
    std::string bytes = header;
    for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F})
        bytes += packed(x);
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < 6; ++i)
            bytes += (i % 3 == 0 ? "\3" : "") + packed(row[i]);
    }
    return bytes;
}

/// The points of each face's corners, listed so that the vertices first appear in the order of the
/// other samples (the tetrahedron is turned inside out for it).
inline const std::vector<std::array<std::array<float, 3>, 3>>& corner_points() {
    static const std::vector<std::array<std::array<float, 3>, 3>> faces{
        {{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}},
        {{{{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}}},
        {{{{1, 0, 0}}, {{0, 0, 1}}, {{0, 1, 0}}}},
        {{{{0, 1, 0}}, {{0, 0, 1}}, {{0, 0, 0}}}}};
    return faces;
}

inline std::string stl_ascii() {
    std::string text = "solid tetrahedron\n";
    for (const auto& face : corner_points()) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const auto& p : face) {
            text += "vertex";
            for (const float x : p)
                text += x == 0 ? " 0" : " 1e0";
            text += '\n';
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid tetrahedron\n";
}

inline std::string stl_binary(std::string_view begin = "") {
    std::string bytes(begin);
    bytes.resize(80, ' ');
    bytes += packed(static_cast<std::uint32_t>(corner_points().size()));
    for (const auto& face : corner_points()) {
        bytes.append(12, '\0');
        for (const auto& p : face) {
            for (const float x : p)
                bytes += packed(x);
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

struct Sample {
    std::string name;  ///< its extension is that of the format
    std::string bytes;
};

inline std::vector<Sample> all() {
    return {{"text.obj", obj()},
            {"text.off", off()},
            {"text.ply", ply_ascii()},
            {"little.ply", ply_binary(std::endian::little)},
            {"big.ply", ply_binary(std::endian::big)},
            {"text-glued.ply", ply_glued("ascii")},
            {"glued.ply", ply_glued("binary_little_endian")},
            {"text.stl", stl_ascii()},
            {"binary.stl", stl_binary()}};
}

}  // namespace tightflip::geometry::samples
