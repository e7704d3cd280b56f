#include "ply_header.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace tightflip::geometry {
namespace {

struct TypeName {
    std::string_view name;
    PlyScalar type;
};
constexpr std::array<TypeName, 16> type_names{{{"char", PlyScalar::i8},
                                               {"int8", PlyScalar::i8},
                                               {"uchar", PlyScalar::u8},
                                               {"uint8", PlyScalar::u8},
                                               {"short", PlyScalar::i16},
                                               {"int16", PlyScalar::i16},
                                               {"ushort", PlyScalar::u16},
                                               {"uint16", PlyScalar::u16},
                                               {"int", PlyScalar::i32},
                                               {"int32", PlyScalar::i32},
                                               {"uint", PlyScalar::u32},
                                               {"uint32", PlyScalar::u32},
                                               {"float", PlyScalar::f32},
                                               {"float32", PlyScalar::f32},
                                               {"double", PlyScalar::f64},
                                               {"float64", PlyScalar::f64}}};

struct EncodingName {
    std::string_view name;
    PlyEncoding encoding;
};
constexpr std::array<EncodingName, 3> encoding_names{
    {{"ascii", PlyEncoding::ascii},
     {"binary_little_endian", PlyEncoding::little_endian},
     {"binary_big_endian", PlyEncoding::big_endian}}};

struct Wanted {
    std::string_view element;
    std::string_view property;
    bool is_list;
    PlyUse use;
    bool is_required = true;
};
constexpr std::array<Wanted, 6> wanted{{{"vertex", "x", false, PlyUse::x},
                                        {"vertex", "y", false, PlyUse::y},
                                        {"vertex", "z", false, PlyUse::z},
                                        {"face", "vertex_indices", true, PlyUse::corners},
                                        {"face", "vertex_index", true, PlyUse::corners},
                                        {"face", "glued_sides", true, PlyUse::glued_sides, false}}};

bool is_integer(PlyScalar type) noexcept {
    return type != PlyScalar::f32 && type != PlyScalar::f64;
}

PlyScalar read_type(TextCursor& cursor, std::string_view expected) {
    const std::string_view word = cursor.word(expected);
    const auto* const found = std::ranges::find(type_names, word, &TypeName::name);
    if (found == type_names.end()) {
        cursor.fail(std::string(expected) + " is " + quoted(word) +
                    ", which PLY does not know; it has char, uchar, short, ushort, int, uint, "
                    "float and double");
    }
    return found->type;
}

PlyEncoding read_encoding(TextCursor& cursor) {
    const std::string_view word = cursor.word("the encoding");
    const auto* const found = std::ranges::find(encoding_names, word, &EncodingName::name);
    if (found == encoding_names.end()) {
        cursor.fail("the encoding " + quoted(word) +
                    " is none of ascii, binary_little_endian and binary_big_endian");
    }
    if (const auto version = cursor.word("the version 1.0"); version != "1.0") {
        cursor.fail("version " + quoted(version) + " of PLY is not known; 1.0 is");
    }
    return found->encoding;
}

void read_property(TextCursor& cursor, PlyElement& element) {
    PlyProperty property;
    property.is_list = cursor.peek() == "list";
    if (property.is_list) {
        cursor.word();
        property.count_type = read_type(cursor, "the type of a list's length");
        if (!is_integer(property.count_type)) cursor.fail("a list's length must be an integer");
    }
    property.type = read_type(cursor, "the type of a property");
    const std::string_view name = cursor.word("the name of a property");
    const auto* const use = std::ranges::find_if(
        wanted, [&](const Wanted& w) { return w.element == element.name && w.property == name; });
    if (use != wanted.end()) {
        property.use = use->use;
        if (use->is_list != property.is_list) {
            cursor.fail("the property " + quoted(name) + " must be a " +
                        (use->is_list ? "list" : "single number, not a list"));
        }
        if (use->is_list && !is_integer(property.type)) {
            cursor.fail("the corners and glued sides of a face must be integers");
        }
        if (std::ranges::count(element.properties, use->use, &PlyProperty::use) > 0) {
            cursor.fail("the property " + quoted(name) + " is there twice, or under two names");
        }
    }
    element.properties.push_back(property);
}

/// The fewest bytes a row can take: in text, a digit and a separator for each number.
std::uint64_t least_row_size(const PlyElement& element, PlyEncoding encoding) noexcept {
    return std::accumulate(element.properties.begin(), element.properties.end(), std::uint64_t{0},
                           [&](std::uint64_t sum, const PlyProperty& p) {
                               const auto binary = size_of(p.is_list ? p.count_type : p.type);
                               return sum + (encoding == PlyEncoding::ascii ? 2 : binary);
                           });
}

void require_wanted(const TextCursor& cursor, const PlyHeader& header) {
    for (const Wanted& w : wanted) {
        if (!w.is_required) continue;
        const auto element = std::ranges::find(header.elements, w.element, &PlyElement::name);
        if (element != header.elements.end() &&
            std::ranges::count(element->properties, w.use, &PlyProperty::use) == 1) {
            continue;
        }
        cursor.fail("the header has no element " + quoted(w.element) + " with a property " +
                    quoted(w.property) + "; point clouds and triangle strips are not read");
    }
}

void refuse_impossible_counts(const TextCursor& cursor, const PlyHeader& header,
                              std::size_t bytes_left) {
    // The last line of a text needs no line feed.
    std::uint64_t left = bytes_left + (header.encoding == PlyEncoding::ascii ? 1 : 0);
    for (const PlyElement& element : header.elements) {
        if (element.rows == 0) continue;
        const std::uint64_t least = least_row_size(element, header.encoding);
        if (least == 0) {
            cursor.fail("the element " + quoted(element.name) + " has rows but no properties");
        }
        if (element.rows > left / least) {
            cursor.fail("the header promises " + std::to_string(element.rows) + " rows of " +
                        quoted(element.name) + ", which do not fit in the " +
                        std::to_string(bytes_left) +
                        " bytes that follow; the file is cut short or its header damaged");
        }
        left -= element.rows * least;
    }
}

}  // namespace

std::size_t size_of(PlyScalar type) noexcept {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::uint64_t PlyHeader::rows_of(std::string_view element) const noexcept {
    const auto found = std::ranges::find(elements, element, &PlyElement::name);
    return found == elements.end() ? 0 : found->rows;
}

PlyHeader read_ply_header(TextCursor& cursor, std::string_view bytes) {
    PlyHeader header;
    std::optional<PlyEncoding> encoding;
    cursor.require_line("'ply'");
    if (cursor.word() != "ply") cursor.fail("a PLY file begins with a line 'ply'");
    cursor.require_end_of_line("'ply'");
    while (true) {
        cursor.require_line("the rest of the header, up to end_header,");
        const std::string_view keyword = cursor.word();
        if (keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "end_header") break;
        if (keyword == "format") {
            if (encoding) cursor.fail("the format is given twice");
            encoding = read_encoding(cursor);
        } else if (keyword == "element") {
            const std::string_view name = cursor.word("the name of an element");
            if (std::ranges::count(header.elements, name, &PlyElement::name) > 0) {
                cursor.fail("the element " + quoted(name) + " is there twice");
            }
            header.elements.push_back({name, cursor.count("the number of rows")});
        } else if (keyword == "property") {
            if (header.elements.empty()) cursor.fail("a property comes before any element");
            read_property(cursor, header.elements.back());
        } else {
            cursor.fail("the header has a line " + quoted(keyword) +
                        "; it may have format, element, property, comment, obj_info, end_header");
        }
        cursor.require_end_of_line("'" + std::string(keyword) + "'");
    }
    cursor.require_end_of_line("end_header");
    if (!encoding) cursor.fail("the header has no line 'format'");
    header.encoding = *encoding;
    require_wanted(cursor, header);
    refuse_impossible_counts(cursor, header, bytes.size() - cursor.after_line());
    return header;
}

}  // namespace tightflip::geometry
