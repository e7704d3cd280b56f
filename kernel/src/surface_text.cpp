#include <tightflip/kernel/plain_writer.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <optional>
#include <utility>

namespace tightflip::kernel {
namespace {

constexpr std::string_view triangulation_header = "tightflip-triangulation";
constexpr std::string_view gluing_header = "tightflip-gluing";
constexpr int version = 1;

/// A side as the format writes it: "-" unglued, "7" glued coherently, "7~" reversed.
SideGluing parse_side(TextCursor& cursor) {
    std::string_view word = cursor.word();
    if (word == "-") return {};
    const bool reversed = word.ends_with('~');
    if (reversed) word.remove_suffix(1);
    const std::optional<std::int64_t> number = cursor.parse_integer(word);
    if (!number || !std::in_range<Index>(*number)) {
        cursor.fail("a glued side should stand here: a number, a number and '~', or '-'");
    }
    const auto side = static_cast<Index>(*number);
    return reversed ? SideGluing::reversed(side) : SideGluing::coherent(side);
}

Gluing parse_gluing(TextCursor& cursor) {
    Gluing gluing;
    cursor.require_line("'vertices COUNT'");
    cursor.require_word("vertices");
    gluing.vertex_count = cursor.index("the number of vertices");
    cursor.require_end_of_line("the number of vertices");
    const Index faces = cursor.announced_lines("faces", 12);
    gluing.faces.reserve(static_cast<std::size_t>(faces));
    for (Index f = 0; f < faces; ++f) {
        cursor.require_line("face " + std::to_string(f));
        GluedFace& face = gluing.faces.emplace_back();
        for (Index& corner : face.corners)
            corner = cursor.index("a corner");
        for (SideGluing& side : face.sides)
            side = parse_side(cursor);
        cursor.require_end_of_line("a face's corners and sides");
    }
    return gluing;
}

void write_side(PlainWriter& text, SideGluing side) {
    if (side.is_glued()) {
        text << ' ' << side.side() << (side.is_reversed() ? "~" : "");
    } else {
        text << " -";
    }
}

}  // namespace

bool is_surface_text(std::string_view text) noexcept {
    return text.starts_with(triangulation_header) || text.starts_with(gluing_header);
}

RawSurface parse_surface(std::string_view text, const std::string& source) {
    TextCursor cursor(text, source);
    cursor.require_line("the format's name and version");
    const std::string_view header = cursor.word();
    const bool is_table = header == triangulation_header;
    if (!is_table && header != gluing_header) {
        cursor.fail("the file is in neither of the formats " + std::string(triangulation_header) +
                    " and " + std::string(gluing_header));
    }
    cursor.integer("the format's version, which must be one this program knows,", version, version);
    cursor.require_end_of_line("the format's version");
    RawSurface surface =
        is_table ? RawSurface(parse_table(cursor)) : RawSurface(parse_gluing(cursor));
    cursor.require_line("'end'");
    cursor.require_word("end");
    cursor.require_end_of_line("'end'");
    if (cursor.next_line()) cursor.fail("nothing should follow 'end'");
    return surface;
}

AuditReport audit(const RawSurface& surface, const AuditOptions& options) {
    if (const auto* table = std::get_if<RawTable>(&surface)) {
        return audit(HalfedgeTable(table->records), table->vertex_count, options);
    }
    return audit(std::get<Gluing>(surface), options);
}

BuildResult build(const RawSurface& surface) {
    if (const auto* table = std::get_if<RawTable>(&surface)) {
        return build(table->records, table->vertex_count);
    }
    return build(std::get<Gluing>(surface));
}

void write_text(std::ostream& out, const Triangulation& surface) {
    PlainWriter text(out);
    text << triangulation_header << ' ' << version << '\n';
    write_table(out, surface.table(), surface.vertex_count());
    text << "end\n";
}

void write_text(std::ostream& out, const Gluing& gluing) {
    PlainWriter text(out);
    text << gluing_header << ' ' << version << "\nvertices " << gluing.vertex_count << "\nfaces "
         << gluing.faces.size() << "\n# three corners, then what sides 0, 1, 2 are glued to\n";
    for (const GluedFace& face : gluing.faces) {
        text << face.corners[0] << ' ' << face.corners[1] << ' ' << face.corners[2] << ' ';
        for (const SideGluing side : face.sides)
            write_side(text, side);
        text << '\n';
    }
    text << "end\n";
}

void write_table(std::ostream& out, HalfedgeTable table, Index vertex_count) {
    PlainWriter text(out);
    text << "vertices " << vertex_count << "\nhalfedges " << table.size()
         << "\n# next halfedge and origin of halfedge 0, 1, 2, ...\n";
    for (const auto& [next, origin] : table)
        text << next.id << ' ' << origin.id << '\n';
}

RawTable parse_table(TextCursor& cursor) {
    RawTable table;
    cursor.require_line("'vertices COUNT'");
    cursor.require_word("vertices");
    table.vertex_count = cursor.index("the number of vertices", 0);
    cursor.require_end_of_line("the number of vertices");
    const Index halfedges = cursor.announced_lines("halfedges", 4);
    table.records.reserve(static_cast<std::size_t>(halfedges));
    for (Index h = 0; h < halfedges; ++h) {
        cursor.require_line("halfedge " + std::to_string(h));
        const Index next = cursor.index("the next halfedge");
        const Index origin = cursor.index("the origin");
        cursor.require_end_of_line("the next halfedge and the origin");
        table.records.push_back({{next}, {origin}});
    }
    return table;
}

}  // namespace tightflip::kernel
