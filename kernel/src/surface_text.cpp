#include <tightflip/kernel/surface_text.hpp>

#include <charconv>
#include <ostream>

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
    Index side = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), side);
    if (error != std::errc{} || end != word.data() + word.size() || word.empty()) {
        cursor.fail("a glued side should stand here: a number, a number and '~', or '-'");
    }
    return reversed ? SideGluing::reversed(side) : SideGluing::coherent(side);
}

Gluing parse_gluing(TextCursor& cursor) {
    Gluing gluing;
    cursor.require_line("'vertices COUNT'");
    cursor.require_word("vertices");
    gluing.vertex_count = static_cast<Index>(cursor.integer("the number of vertices", 0));
    cursor.require_end_of_line();
    const Index faces = cursor.count("faces", 12);
    gluing.faces.reserve(static_cast<std::size_t>(faces));
    for (Index f = 0; f < faces; ++f) {
        cursor.require_line("face " + std::to_string(f));
        GluedFace& face = gluing.faces.emplace_back();
        for (Index& corner : face.corners) {
            corner = static_cast<Index>(cursor.integer("a corner"));
        }
        for (SideGluing& side : face.sides)
            side = parse_side(cursor);
        cursor.require_end_of_line();
    }
    return gluing;
}

void write_side(std::ostream& out, SideGluing side) {
    if (side.is_glued()) {
        out << ' ' << side.side() << (side.is_reversed() ? "~" : "");
    } else {
        out << " -";
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
    cursor.require_end_of_line();
    RawSurface surface =
        is_table ? RawSurface(parse_table(cursor)) : RawSurface(parse_gluing(cursor));
    cursor.require_line("'end'");
    cursor.require_word("end");
    cursor.require_end_of_line();
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
    out << triangulation_header << ' ' << version << '\n';
    write_table(out, surface.table(), surface.vertex_count());
    out << "end\n";
}

void write_text(std::ostream& out, const Gluing& gluing) {
    out << gluing_header << ' ' << version << "\nvertices " << gluing.vertex_count << "\nfaces "
        << gluing.faces.size() << "\n# three corners, then what sides 0, 1, 2 are glued to\n";
    for (const GluedFace& face : gluing.faces) {
        out << face.corners[0] << ' ' << face.corners[1] << ' ' << face.corners[2] << ' ';
        for (const SideGluing side : face.sides)
            write_side(out, side);
        out << '\n';
    }
    out << "end\n";
}

void write_table(std::ostream& out, HalfedgeTable table, Index vertex_count) {
    out << "vertices " << vertex_count << "\nhalfedges " << table.size()
        << "\n# next halfedge and origin of halfedge 0, 1, 2, ...\n";
    for (const auto& [next, origin] : table)
        out << next.id << ' ' << origin.id << '\n';
}

RawTable parse_table(TextCursor& cursor) {
    RawTable table;
    cursor.require_line("'vertices COUNT'");
    cursor.require_word("vertices");
    table.vertex_count = static_cast<Index>(cursor.integer("the number of vertices", 0));
    cursor.require_end_of_line();
    const Index halfedges = cursor.count("halfedges", 4);
    table.records.reserve(static_cast<std::size_t>(halfedges));
    for (Index h = 0; h < halfedges; ++h) {
        cursor.require_line("halfedge " + std::to_string(h));
        const auto next = static_cast<Index>(cursor.integer("the next halfedge"));
        const auto origin = static_cast<Index>(cursor.integer("the origin"));
        cursor.require_end_of_line();
        table.records.push_back({{next}, {origin}});
    }
    return table;
}

}  // namespace tightflip::kernel
