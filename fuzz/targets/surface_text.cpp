#include "surface_text.hpp"

#include "reading.hpp"
#include "seed_surfaces.hpp"
#include "targets.hpp"
#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <array>
#include <bit>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using kernel::RawTable;

const std::string source = "the text";

std::string table_text(const RawTable& table) {
    return "tightflip-triangulation 1\n" + written([&](std::ostream& out) {
               write_table(out, table.records, table.vertex_count);
           }) +
           "end\n";
}

std::string text_of(const kernel::RawSurface& surface) {
    if (const auto* const table = std::get_if<RawTable>(&surface)) return table_text(*table);
    return written([&](std::ostream& out) { write_text(out, std::get<kernel::Gluing>(surface)); });
}

/// A surface without points: read, written, read again, judged, built.
std::string plain_objection(std::string_view text) {
    const auto read = attempt(text, [&] { return kernel::parse_surface(text, source); });
    if (!read.objection.empty()) return read.objection;
    if (!read.value) return {};
    if (text_of(*read.value) != text_of(kernel::parse_surface(text_of(*read.value), source)) ||
        kernel::parse_surface(text_of(*read.value), source) != *read.value) {
        return "text_written_reads_the_same: it does not";
    }
    const kernel::AuditReport report = audit(*read.value);
    const kernel::BuildResult built = build(*read.value);
    if (static_cast<bool>(built) != report.is_valid()) return "builder_agrees_with_audit: no";
    if (!built) return {};
    const std::string again = written([&](std::ostream& out) { write_text(out, built.value()); });
    return build(kernel::parse_surface(again, source)).value() == built.value()
               ? std::string()
               : "surfaces_written_read_the_same: they do not";
}

bool are_same_bits(const geometry::Point& a, const geometry::Point& b) {
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
    }
    return true;
}

/// A surface with points.
std::string pointed_objection(std::string_view text) {
    const auto read = attempt(text, [&] { return geometry::parse_surface(text, source); });
    if (!read.objection.empty()) return read.objection;
    if (!read.value) return {};
    const RawTable& table = read.value->table;
    const std::vector<geometry::Point>& points = read.value->points;
    if (points.size() != static_cast<std::size_t>(table.vertex_count)) {
        return "there_are_as_many_points_as_vertices: no";
    }
    for (const geometry::Point& point : points) {
        if (!point.allFinite()) return "points_are_finite: they are not";
    }
    const std::string again = written([&](std::ostream& out) {
        geometry::write_text(out, {.table = table.records, .points = points});
    });
    const geometry::RawSurface reread = geometry::parse_surface(again, source);
    if (reread.table != table) return "text_written_reads_the_same: not the table";
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (!are_same_bits(points[v], reread.points[v])) {
            return "text_written_reads_the_same: not point " + std::to_string(v);
        }
    }
    if (audit(table.records, table.vertex_count).is_valid()) {
        static_cast<void>(
            geometry::Surface(build(table.records, table.vertex_count).value(), points));
    }
    return {};
}

// ---- seeds ----

/// A tetrahedron with points that are hard to write.
std::string surface_seed() {
    const kernel::Triangulation surface = kernel::families::tetrahedron();
    const std::vector<geometry::Point> points{
        {0, -0.0, 1e-320},
        {1, 0.1, 1e300},
        {-1.7976931348623157e308, 5e-324, 0.30000000000000004},
        {123456789012345680.0, -1, 3}};
    return written([&](std::ostream& out) {
        geometry::write_text(out, {.table = surface.table(), .points = points});
    });
}

struct Edit {
    const char* name;
    std::string_view what;
    std::string_view by;
};

/// One edit each of a well-formed text.
constexpr std::array edits{
    Edit{"comment", "end", "# a comment\n\nend"},
    Edit{"line_ends_of_windows", "\nend\n", "\r\nend\r\n"},
    Edit{"blanks", "vertices 4", "  vertices\t4 "},
    Edit{"no_end", "end\n", ""},
    Edit{"more_after_the_end", "end\n", "end\nend\n"},
    Edit{"version_of_the_future", " 1\n", " 2\n"},
    Edit{"version_missing", " 1\n", "\n"},
    Edit{"vertices_too_large", "vertices 4", "vertices 99999999999999999999"},
    Edit{"vertices_negative", "vertices 4", "vertices -4"},
    Edit{"vertices_huge", "vertices 4", "vertices 2147483647"},
    Edit{"more_vertices_than_corners", "vertices 4", "vertices 40"},
    Edit{"halfedges_huge", "halfedges 12", "halfedges 2147483647"},
    Edit{"halfedges_too_few", "halfedges 12", "halfedges 10"},
    Edit{"word_for_a_number", "vertices 4", "vertices four"},
    Edit{"more_words_on_a_line", "vertices 4", "vertices 4 4"},
    Edit{"count_missing", "halfedges 12", "halfedges"},
    Edit{"other_word", "halfedges", "halfedgez"},
    Edit{"too_many_points", "points 4", "points 5"},
    Edit{"points_huge", "points 4", "points 2147483647"},
    Edit{"point_not_finite", "\n0 -0 ", "\nnan inf "},
    Edit{"number_beyond_doubles", "1e-320", "1e-99999"},
};

std::vector<Seed> seeds() {
    std::vector<Seed> seeds{{"empty", {}}, {"unprintable", {0x00, 0xff, 0x0a, 0x80}}};
    const auto add = [&](const std::string& name, const std::string& text) {
        seeds.push_back({name, as_bytes(text)});
    };
    const std::string triangulation =
        written([](std::ostream& out) { write_text(out, kernel::families::tetrahedron()); });
    const std::string surface = surface_seed();
    for (const auto& [name, what, by] : edits) {
        for (const auto& [kind, text] :
             {std::pair("triangulation", triangulation), std::pair("surface", surface)}) {
            const std::size_t place = text.find(what);
            if (place == std::string::npos) continue;
            add(std::string(kind) + "_" + name, std::string(text).replace(place, what.size(), by));
        }
    }
    add("surface", surface);
    add("gluing_of_everything",
        "tightflip-gluing 1\nvertices 3\nfaces 2\n0 1 2 - 7~ 3\n"
        "-1 99 0 0~ -5 2147483647~\nend\n");
    add("gluing_with_a_word_for_a_side",
        "tightflip-gluing 1\nvertices 3\nfaces 1\n0 1 2 ~ - -\nend\n");
    add("gluing_with_a_huge_side",
        "tightflip-gluing 1\nvertices 3\nfaces 1\n0 1 2 99999999999 - -\nend\n");
    add("gluing_negative_vertices", "tightflip-gluing 1\nvertices -3\nfaces 0\nend\n");
    add("table_negative_next", "tightflip-triangulation 1\nvertices 3\nhalfedges 1\n-1 -1\nend\n");
    for (const SeedSurface& seed : seed_surfaces()) {
        add("triangulation_" + seed.name,
            written([&](std::ostream& out) { write_text(out, seed.surface); }));
        add("gluing_" + seed.name, written([&](std::ostream& out) {
                write_text(out,
                           read_table(seed.surface.table(), seed.surface.vertex_count()).gluing);
            }));
    }
    return seeds;
}

}  // namespace

std::string surface_text_objection(std::string_view text) {
    if (kernel::is_surface_text(text) && geometry::is_surface_text(text)) {
        return "formats_are_told_apart: they are not";
    }
    std::string plain = plain_objection(text);
    return plain.empty() ? pointed_objection(text) : plain;
}

const Target surface_text_target{
    .name = "surface_text",
    .description =
        "text as a surface or gluing: read or refused with its line, written, read "
        "again the same",
    .layout = {},
    .objection = [](Input input) { return surface_text_objection(as_text(input)); },
    .show = show_bytes,
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
