#include "byte_order.hpp"
#include "formats.hpp"
#include "mesh_text.hpp"
#include "ply_header.hpp"
#include "soup_builder.hpp"

#include <array>
#include <bit>
#include <utility>
#include <vector>

namespace tightflip::geometry {
namespace {

std::string row_name(const PlyElement& element, std::uint64_t row) {
    return "row " + std::to_string(row) + " of the " + std::to_string(element.rows) + " of " +
           quoted(element.name);
}

/// Rows as lines of text. Types matter no more than that corners and lengths are integers.
class TextRows {
public:
    static constexpr FileError::Unit unit = FileError::Unit::line;

    explicit TextRows(TextCursor& header_end) : cursor_(header_end) {}

    std::uint64_t begin_row(const PlyElement& element, std::uint64_t row) {
        if (!cursor_.next_line()) cursor_.fail("the file ends before " + row_name(element, row));
        return cursor_.line();
    }
    double real(PlyScalar) { return cursor_.number("a property"); }
    std::int64_t integer(PlyScalar, std::string_view what) { return cursor_.integer(what); }
    std::uint64_t length(const PlyProperty&) { return cursor_.count("the length of a list"); }
    void skip(PlyScalar, std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i)
            cursor_.number("an entry of a list");
    }
    void end_row(const PlyElement& element) {
        if (!cursor_.peek().empty()) {
            cursor_.require_end_of_line("all properties of " + quoted(element.name));
        }
    }
    void end() {
        if (cursor_.next_line()) cursor_.fail("more lines follow than the header promises");
    }

private:
    TextCursor& cursor_;
};

/// Rows as packed numbers.
class BinaryRows {
public:
    static constexpr FileError::Unit unit = FileError::Unit::byte;

    BinaryRows(const MeshInput& input, std::size_t offset, std::endian order)
        : bytes_(input.bytes), source_(input.source), order_(order), offset_(offset) {}

    std::uint64_t begin_row(const PlyElement& element, std::uint64_t row) {
        element_ = &element;
        row_ = row;
        return offset_;
    }
    double real(PlyScalar type) { return take<double>(type); }
    std::int64_t integer(PlyScalar type, std::string_view) { return take<std::int64_t>(type); }
    std::uint64_t length(const PlyProperty& list) {
        const std::size_t at = offset_;
        const auto length = take<std::int64_t>(list.count_type);
        if (length < 0) fail(at, "a list has the negative length " + std::to_string(length));
        if (std::cmp_greater(length, (bytes_.size() - offset_) / size_of(list.type))) {
            fail(at, "a list of " + std::to_string(length) + " entries does not fit in the " +
                         std::to_string(bytes_.size() - offset_) + " bytes left");
        }
        return static_cast<std::uint64_t>(length);
    }
    void skip(PlyScalar type, std::uint64_t count) { offset_ += size_of(type) * count; }
    void end_row(const PlyElement&) {}
    void end() {
        if (offset_ < bytes_.size()) {
            fail(offset_, std::to_string(bytes_.size() - offset_) +
                              " bytes follow the rows that the header promises");
        }
    }

private:
    template <class To>
    To take(PlyScalar type) {
        if (size_of(type) > bytes_.size() - offset_) {
            fail(offset_, "the file ends inside " + row_name(*element_, row_));
        }
        const std::size_t at = std::exchange(offset_, offset_ + size_of(type));
        switch (type) {
            case PlyScalar::i8:
                return static_cast<To>(load<std::int8_t>(bytes_, at, order_));
            case PlyScalar::u8:
                return static_cast<To>(load<std::uint8_t>(bytes_, at, order_));
            case PlyScalar::i16:
                return static_cast<To>(load<std::int16_t>(bytes_, at, order_));
            case PlyScalar::u16:
                return static_cast<To>(load<std::uint16_t>(bytes_, at, order_));
            case PlyScalar::i32:
                return static_cast<To>(load<std::int32_t>(bytes_, at, order_));
            case PlyScalar::u32:
                return static_cast<To>(load<std::uint32_t>(bytes_, at, order_));
            case PlyScalar::f32:
                return static_cast<To>(load<float>(bytes_, at, order_));
            case PlyScalar::f64:
                break;
        }
        return static_cast<To>(load<double>(bytes_, at, order_));
    }

    [[noreturn]] void fail(std::size_t at, std::string reason) const {
        throw FileError(std::string(source_), unit, at, std::move(reason));
    }

    std::string_view bytes_;
    std::string_view source_;
    std::endian order_;
    std::size_t offset_;
    const PlyElement* element_ = nullptr;
    std::uint64_t row_ = 0;
};

/// What a row says of a vertex or a face.
struct RowContent {
    Eigen::Vector3d point;
    std::vector<std::int64_t> corners;
    std::vector<std::int64_t> glued_sides;
    bool has_glued_sides = false;
};

template <class Rows>
void read_list(Rows& rows, const PlyProperty& list, std::string_view what,
               std::vector<std::int64_t>& entries) {
    entries.clear();
    for (auto n = rows.length(list); n > 0; --n)
        entries.push_back(rows.integer(list.type, what));
}

template <class Rows>
void read_property(Rows& rows, const PlyProperty& property, RowContent& row) {
    if (property.use == PlyUse::corners) {
        read_list(rows, property, "a corner", row.corners);
    } else if (property.use == PlyUse::glued_sides) {
        read_list(rows, property, "a glued side", row.glued_sides);
        row.has_glued_sides = true;
    } else if (property.is_list) {
        rows.skip(property.type, rows.length(property));
    } else {
        const double value = rows.real(property.type);
        if (property.use == PlyUse::nothing) return;
        row.point[static_cast<int>(property.use) - static_cast<int>(PlyUse::x)] = value;
    }
}

template <class Rows>
TriangleSoup read_rows(Rows rows, const PlyHeader& header, const MeshInput& input) {
    SoupBuilder builder(input, Rows::unit, 0);
    builder.reserve(header.rows_of("vertex"), header.rows_of("face"));
    RowContent content;
    for (const PlyElement& element : header.elements) {
        for (std::uint64_t row = 0; row < element.rows; ++row) {
            const std::uint64_t position = rows.begin_row(element, row);
            for (const PlyProperty& property : element.properties)
                read_property(rows, property, content);
            rows.end_row(element);
            if (element.is_vertex()) builder.add_point(content.point, position);
            if (!element.is_face()) continue;
            builder.add_polygon(content.corners, position);
            if (content.has_glued_sides) builder.add_glued_sides(content.glued_sides, position);
        }
    }
    rows.end();
    return std::move(builder).finish();
}

}  // namespace

bool looks_like_ply(std::string_view bytes) {
    return bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n");
}

TriangleSoup read_ply(const MeshInput& input) {
    TextCursor cursor(input.bytes, std::string(input.source), bare_lines);
    const PlyHeader header = read_ply_header(cursor, input.bytes);
    if (header.encoding == PlyEncoding::ascii) return read_rows(TextRows(cursor), header, input);
    const auto order =
        header.encoding == PlyEncoding::little_endian ? std::endian::little : std::endian::big;
    return read_rows(BinaryRows(input, cursor.after_line(), order), header, input);
}

}  // namespace tightflip::geometry
