#include "halfedge_table.hpp"

#include "bytes.hpp"
#include "gluing.hpp"
#include "reading.hpp"
#include "seed_surfaces.hpp"
#include "targets.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/quick_audit.hpp>

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>

namespace tightflip::fuzz {
namespace {

using kernel::AuditReport;
using kernel::Edge;
using kernel::HalfedgeRecord;
using kernel::Index;
using kernel::RawTable;

constexpr Layout layout{.head = 2, .record = 2, .most_records = most_raw_halfedges};

std::string first_violation(const AuditReport& report) {
    if (report.violations.empty()) return "no violation";
    return where(report.violations.front()) + ": " + message(report.violations.front());
}

std::string judges_agree(const RawTable& table, const AuditReport& report) {
    if (kernel::passes_audit(table.records, table.vertex_count) != report.is_valid()) {
        return "quick_judge_agrees_with_audit: the audit says " + first_violation(report);
    }
    const kernel::BuildResult built = build(table.records, table.vertex_count);
    if (static_cast<bool>(built) != report.is_valid()) {
        return "builder_agrees_with_audit: the audit says " + first_violation(report);
    }
    const kernel::TableReading reading = read_table(table.records, table.vertex_count);
    if (!reading.violations.empty()) return {};
    if (judge_by_heaps(reading.gluing).is_allowed != report.is_valid()) {
        return "audit_is_right: it says " + first_violation(report);
    }
    return {};
}

/// Of a table with edges: a look at one edge finds nothing where the audit finds nothing, and only
/// sees what is wrong there.
std::string looks_at_edges_agree(const RawTable& table, const AuditReport& report) {
    if (table.records.size() % 2 != 0) return {};
    for (Edge e{0}; e.id < static_cast<Index>(table.records.size() / 2); ++e.id) {
        const auto code = audit_at_edge(table.records, table.vertex_count, e);
        if (code && report.is_valid()) {
            return "looks_at_edges_agree_with_audit: edge " + std::to_string(e.id) + ": " +
                   std::string(kernel::name(*code));
        }
    }
    return {};
}

/// Every edge of a valid table flips and comes back, or stays.
std::string flips_keep_tables_valid(const RawTable& table, const AuditReport& report) {
    if (!report.is_valid()) return {};
    for (Edge e{0}; e.id < static_cast<Index>(table.records.size() / 2); ++e.id) {
        std::vector<HalfedgeRecord> records = table.records;
        const bool can = static_cast<bool>(kernel::can_flip(records, e));
        if (static_cast<bool>(kernel::flip(records, e)) != can ||
            (records != table.records) != can) {
            return "flips_do_what_they_say: edge " + std::to_string(e.id);
        }
        if (!kernel::passes_audit(records, table.vertex_count)) {
            return "flips_keep_tables_valid: edge " + std::to_string(e.id);
        }
        if (static_cast<bool>(kernel::unflip(records, e)) != can || records != table.records) {
            return "unflip_undoes_flip: edge " + std::to_string(e.id);
        }
    }
    return {};
}

/// The surface of a valid table: all edges flipped at once, and one by one with the reverse after.
std::string surfaces_flip_alike(const RawTable& table, const AuditReport& report) {
    if (!report.is_valid()) return {};
    const kernel::Triangulation start = build(table.records, table.vertex_count).value();
    std::vector<Edge> edges;
    for (Edge e{0}; e.id < start.edge_count(); ++e.id)
        edges.push_back(e);
    kernel::Triangulation at_once = start;
    const std::size_t count = at_once.flip_all(edges);
    kernel::Triangulation one_by_one = start;
    std::vector<Edge> done;
    for (const Edge e : edges) {
        if (one_by_one.flip(e)) done.push_back(e);
    }
    if (count != done.size() || !(at_once == one_by_one)) {
        return "flipping_at_once_is_flipping_one_by_one: " + std::to_string(count) + " and " +
               std::to_string(done.size()) + " flips";
    }
    for (; !done.empty(); done.pop_back())
        static_cast<void>(one_by_one.unflip(done.back()));
    const std::hash<kernel::Triangulation> hash;
    if (!(one_by_one == start) || hash(one_by_one) != hash(start)) {
        return "unflipping_all_leads_back: it does not";
    }
    edges.push_back({start.edge_count()});
    const kernel::Triangulation before = at_once;
    try {
        static_cast<void>(at_once.flip_all(edges));
        return "edges_that_do_not_exist_are_refused: one was flipped";
    } catch (const std::out_of_range&) {
        return at_once == before ? std::string()
                                 : "refused_lists_of_flips_do_nothing: this one did";
    }
}

std::string text_keeps_it(const RawTable& table) {
    if (table.vertex_count < 0) return {};  // no text says that
    const std::string text =
        "tightflip-triangulation 1\n" +
        written([&](std::ostream& out) { write_table(out, table.records, table.vertex_count); }) +
        "end\n";
    const kernel::RawSurface read = kernel::parse_surface(text, "the table");
    if (std::get<RawTable>(read) != table) return "text_keeps_tables: it does not";
    return audit(read).violations == audit(table.records, table.vertex_count).violations
               ? std::string()
               : "text_keeps_tables: their audits differ";
}

std::vector<Seed> seeds() {
    std::vector<Seed> seeds{{"no_halfedges", {format_version, 1}}};
    for (const SeedSurface& seed : seed_surfaces()) {
        seeds.push_back({seed.name, encode_table(seed.surface)});
    }
    struct Damage {
        const char* name;
        void (*make)(RawTable& table);
    };
    constexpr std::array damages{
        Damage{"odd_number_of_halfedges", [](RawTable& table) { table.records.pop_back(); }},
        Damage{"next_out_of_range", [](RawTable& table) { table.records[3].next = {12}; }},
        Damage{"origin_out_of_range", [](RawTable& table) { table.records[3].origin = {-1}; }},
        Damage{"face_of_two_sides",
               [](RawTable& table) { table.records[0].next = table.records[2].next; }},
        Damage{"face_of_one_side", [](RawTable& table) { table.records[5].next = {5}; }},
        Damage{"wrong_origin",
               [](RawTable& table) { table.records[0].origin = table.records[1].origin; }},
        Damage{"face_turned_over",
               [](RawTable& table) {
                   std::swap(table.records[0].next, table.records[2].next);
                   std::swap(table.records[1].next, table.records[4].next);
               }},
        Damage{"unused_vertex", [](RawTable& table) { ++table.vertex_count; }},
    };
    const kernel::Triangulation tetrahedron = kernel::families::tetrahedron();
    for (const auto& [name, make] : damages) {
        RawTable table{.vertex_count = 4,
                       .records = {tetrahedron.table().begin(), tetrahedron.table().end()}};
        make(table);
        seeds.push_back({name, encode_table(table)});
    }
    return seeds;
}

}  // namespace

RawTable decode_table(Input input) {
    Bytes bytes = Bytes::after_version(input.first(std::min(input.size(), layout.most_bytes())));
    RawTable table{.vertex_count = static_cast<Index>(bytes.byte()) - 1, .records = {}};
    while (!bytes.empty()) {
        const auto next = static_cast<Index>(bytes.byte()) - 1;
        table.records.push_back({{next}, {static_cast<Index>(bytes.byte()) - 1}});
    }
    return table;
}

InputBytes encode_table(const kernel::TableView& table) {
    InputBytes bytes{format_version, static_cast<std::uint8_t>(table.vertex_count + 1)};
    for (const auto& [next, origin] : table.records) {
        bytes.push_back(static_cast<std::uint8_t>(next.id + 1));
        bytes.push_back(static_cast<std::uint8_t>(origin.id + 1));
    }
    return bytes;
}

std::string table_objection(const RawTable& table) {
    const AuditReport report = audit(table.records, table.vertex_count);
    for (const std::string& objection :
         {judges_agree(table, report), looks_at_edges_agree(table, report),
          flips_keep_tables_valid(table, report), surfaces_flip_alike(table, report),
          text_keeps_it(table)}) {
        if (!objection.empty()) return objection;
    }
    return {};
}

const Target halfedge_table_target{
    .name = "halfedge_table",
    .description = "a raw halfedge table: all judges agree, and flips of a valid one keep it so",
    .layout = layout,
    .objection = [](Input input) { return table_objection(decode_table(input)); },
    .show =
        [](std::ostream& out, Input input) {
            const RawTable table = decode_table(input);
            write_table(out, table.records, table.vertex_count);
            for (const kernel::Violation& violation :
                 audit(table.records, table.vertex_count).violations)
                out << where(violation) << ": " << message(violation) << '\n';
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
