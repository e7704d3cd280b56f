/// \file
/// The header of a PLY file: what its rows hold, and which of it matters to a surface.
#pragma once

#include "formats.hpp"
#include "mesh_text.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::geometry {

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };
enum class PlyScalar : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

/// What a property is read for.
enum class PlyUse : std::uint8_t { nothing, x, y, z, corners, glued_sides };

struct PlyProperty {
    PlyScalar type{};  ///< of the value, or of a list's entries
    PlyScalar count_type{};
    bool is_list = false;
    PlyUse use = PlyUse::nothing;
};

struct PlyElement {
    std::string_view name;
    std::uint64_t rows = 0;
    std::vector<PlyProperty> properties{};

    [[nodiscard]] bool is_vertex() const noexcept { return name == "vertex"; }
    [[nodiscard]] bool is_face() const noexcept { return name == "face"; }
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;

    [[nodiscard]] std::uint64_t rows_of(std::string_view element) const noexcept;
};

[[nodiscard]] std::size_t size_of(PlyScalar type) noexcept;

/// Reads the header; leaves the cursor on the line end_header. Afterwards there is one element
/// vertex with the scalars x, y and z, one element face with one list of corners and perhaps one of
/// glued sides, and the rows that are promised can stand in the bytes that follow.
[[nodiscard]] PlyHeader read_ply_header(TextCursor& cursor, std::string_view bytes);

}  // namespace tightflip::geometry
