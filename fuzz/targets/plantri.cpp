#include "plantri.hpp"

#include "reading.hpp"
#include "seed_surfaces.hpp"
#include "targets.hpp"
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <ostream>
#include <sstream>
#include <vector>

namespace tightflip::fuzz {
namespace {

using kernel::FileError;
using kernel::PlantriFormat;
using kernel::PlantriReader;
using kernel::PlantriWriter;
using kernel::Triangulation;

constexpr std::size_t most_graphs = 8;
constexpr std::array formats{PlantriFormat::planar_code, PlantriFormat::edge_code};

std::vector<Triangulation> graphs_in(std::string_view bytes, PlantriFormat headerless) {
    std::istringstream in{std::string(bytes)};
    PlantriReader reader(in, "the graphs", headerless);
    std::vector<Triangulation> graphs;
    while (graphs.size() < most_graphs) {
        auto graph = reader.next();
        if (!graph) break;
        graphs.push_back(*std::move(graph));
    }
    return graphs;
}

std::string code_of(std::span<const Triangulation> graphs, PlantriFormat format) {
    return written([&](std::ostream& out) {
        PlantriWriter writer(out, "the graphs", format);
        for (const Triangulation& graph : graphs)
            writer.write(graph);
        writer.finish();
    });
}

/// Whether edge e joins the same vertices in both, for all e.
bool have_same_edges(const Triangulation& a, const Triangulation& b) {
    for (kernel::Edge e{0}; e.id < a.edge_count(); ++e.id) {
        const kernel::Halfedge h = halfedge_of(e);
        const bool same = a.origin(h) == b.origin(h) && a.target(h) == b.target(h);
        if (!same && !(a.origin(h) == b.target(h) && a.target(h) == b.origin(h))) return false;
    }
    return true;
}

bool carries(PlantriFormat format, const Triangulation& graph) {
    return format == PlantriFormat::edge_code || audit(graph).parallels->pairs_joined_twice == 0;
}

std::string writing_keeps(const Triangulation& graph, PlantriFormat format) {
    std::string code;
    try {
        code = code_of(std::span(&graph, 1), format);
    } catch (const FileError& error) {
        if (!carries(format, graph)) return {};
        return std::string("graphs_that_fit_are_written: ") + error.what();
    }
    if (!carries(format, graph)) return "parallel_edges_are_refused: they were written";
    const std::vector<Triangulation> again = graphs_in(code, PlantriFormat::planar_code);
    if (again.size() != 1 || !same_labelled_surface(again.front(), graph)) {
        return "graphs_written_read_the_same: they do not";
    }
    if (format == PlantriFormat::edge_code && !have_same_edges(again.front(), graph)) {
        return "edge_code_keeps_numbers_of_edges: it does not";
    }
    return {};
}

// ---- seeds ----

std::string bytes_of(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values)
        bytes.push_back(static_cast<char>(value));
    return bytes;
}

std::vector<Seed> seeds() {
    namespace families = kernel::families;
    std::vector<Seed> seeds{{"empty", {}}};
    const auto add = [&](const std::string& name, const std::string& bytes) {
        seeds.push_back({name, as_bytes(bytes)});
    };
    for (const SeedSurface& seed : seed_surfaces()) {
        for (const PlantriFormat format : formats) {
            if (!carries(format, seed.surface)) continue;
            add((format == PlantriFormat::edge_code ? "edge_code_" : "planar_code_") + seed.name,
                code_of(std::span(&seed.surface, 1), format));
        }
    }
    const std::string planar = ">>planar_code<<";
    const std::string edge = ">>edge_code<<";
    const std::string tetrahedron = bytes_of({4, 2, 3, 4, 0, 1, 4, 3, 0, 1, 2, 4, 0, 1, 3, 2, 0});
    add("headerless", tetrahedron + tetrahedron);
    add("header_twice", planar + planar + tetrahedron);
    add("headers_in_between", planar + tetrahedron + edge + planar + tetrahedron);
    add("big_endian",
        ">>planar_code be<<" + bytes_of({0, 0, 4, 0, 2, 0, 3, 0, 4, 0, 0, 0, 1, 0, 4, 0, 3, 0,
                                         0, 0, 1, 0, 2, 0, 4, 0, 0, 0, 1, 0, 3, 0, 2, 0, 0}));
    add("little_endian",
        ">>planar_code le<<" + bytes_of({0, 4, 0, 2, 0, 3, 0, 4, 0, 0, 0, 1, 0, 4, 0, 3, 0, 0,
                                         0, 1, 0, 2, 0, 4, 0, 0, 0, 1, 0, 3, 0, 2, 0, 0, 0}));
    add("unknown_header", ">>planar_code xx<<");
    add("header_cut", ">>planar");
    add("no_vertices", planar + bytes_of({0, 0, 0}));
    add("neighbour_out_of_range", planar + bytes_of({3, 2, 9, 0}));
    add("loop", planar + bytes_of({3, 1, 2, 0}));
    add("parallel_edges", planar + bytes_of({3, 2, 2, 3, 0, 1, 3, 1, 0, 1, 2, 0}));
    add("edge_from_one_end_only", planar + bytes_of({3, 2, 3, 0, 1, 0, 1, 2, 0}));
    add("edge_three_times", planar + bytes_of({3, 2, 2, 0, 1, 3, 0, 2, 0}));
    add("no_triangulation", planar + bytes_of({4, 2, 4, 0, 1, 3, 0, 2, 4, 0, 3, 1, 0}));
    add("vertex_without_neighbours", planar + bytes_of({4, 2, 3, 0, 3, 1, 0, 1, 2, 0, 0}));
    add("truncated", planar + tetrahedron.substr(0, 9));
    add("huge_vertex_count", planar + bytes_of({0, 255, 255, 0, 1}));
    add("edge_code_empty", edge + bytes_of({0, 0}));
    add("edge_code_no_width", edge + bytes_of({0, 0x10, 5, 1, 2, 3}));
    add("edge_code_huge_length",
        edge + bytes_of({0, 0x81, 255, 255, 255, 255, 255, 255, 255, 255}));
    add("edge_code_edge_once", edge + bytes_of({5, 0, 255, 0, 255, 1}));
    add("edge_code_edge_three_times", edge + bytes_of({6, 0, 0, 255, 0, 255, 0}));
    add("edge_code_huge_edge", edge + bytes_of({0, 0x24, 0x7f, 255, 255, 255, 0}));
    add("edge_code_loop", edge + bytes_of({5, 0, 0, 255, 1, 1}));
    add("edge_code_more_vertices_than_ends", edge + bytes_of({6, 255, 255, 255, 255, 0, 0}));
    add("edge_code_number_beyond_the_end", edge + bytes_of({0, 0x12, 3, 0, 1, 2}));
    add("edge_code_wide", code_of(std::vector{families::book(90)}, PlantriFormat::edge_code));
    add("planar_code_wide",
        code_of(std::vector{families::double_wheel(260)}, PlantriFormat::planar_code));
    return seeds;
}

}  // namespace

std::string plantri_objection(std::string_view bytes, PlantriFormat headerless) {
    const auto read = attempt(bytes, [&] { return graphs_in(bytes, headerless); });
    if (!read.value) return read.objection;
    for (const Triangulation& graph : *read.value) {
        if (!audit(graph).is_valid()) return "graphs_read_are_valid: one is not";
        for (const PlantriFormat format : formats) {
            if (auto objection = writing_keeps(graph, format); !objection.empty()) {
                return objection;
            }
        }
    }
    return read.objection;
}

const Target plantri_target{
    .name = "plantri",
    .description =
        "bytes as planar_code or edge_code: graphs or a refusal with the byte, written, "
        "read again the same",
    .layout = {},
    .objection =
        [](Input input) {
            for (const PlantriFormat format : formats) {
                std::string objection = plantri_objection(as_text(input), format);
                if (!objection.empty()) return objection;
            }
            return std::string();
        },
    .show = show_bytes,
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
