// Prints flips of the C++ kernel for the extracted checker to compare: tie [FLIPS]. The stream is
// described in docs/proof.md: tables, flips with what became of them, audits. Every sphere with up
// to six vertices and every edge; starts on the torus and the surface of genus two; gluings that
// are not allowed; then scripts of so many random flips (100,000 by default) on each of four
// surfaces.

#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/gluing_enumeration.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace tightflip::kernel;

using Table = std::vector<HalfedgeRecord>;

void write_entries(const Table& table) {
    std::string line;
    for (const auto& [next, origin] : table)
        line += std::to_string(next.id) + ' ' + std::to_string(origin.id) + ' ';
    line.back() = '\n';
    std::fputs(line.c_str(), stdout);
}

void write_table(const Table& table, Index vertices) {
    std::printf("table %d %zu\n", vertices, table.size());
    write_entries(table);
}

void write_audit(const Table& table, Index vertices) {
    const AuditReport report = audit(table, vertices);
    if (!report.is_valid()) {
        std::puts("audit\ninvalid");
        return;
    }
    const Topology& topology = report.topology;
    std::printf("audit\nvalid %d %d %d %d\n", topology.vertices, topology.edges, topology.faces,
                topology.genus.value_or(-1));
}

/// A flip or its inverse.
struct Turn {
    const char* name;
    FlipVerdict (*turn)(MutableHalfedgeTable table, Edge e);
};
constexpr Turn flipping{"flip", flip};
constexpr Turn unflipping{"unflip", unflip};

/// One turn; with the whole table afterwards where that is asked for.
void write_turn(const Turn& turn, Table& table, Edge e, bool whole) {
    const bool may = static_cast<bool>(can_flip(table, e));
    const bool done = static_cast<bool>(turn.turn(table, e));
    std::printf("%s %d\n", turn.name, e.id);
    if (may != done) {
        std::puts("can_flip says otherwise");  // which the checker takes for no answer
    } else if (!done) {
        std::puts("refused");
    } else if (!whole) {
        std::puts("done");
    } else {
        std::puts("table");
        write_entries(table);
    }
}

/// Each edge flipped four times from the table as it is, then taken back and flipped once more.
void write_every_flip(HalfedgeTable start, Index vertices) {
    Table table(start.begin(), start.end());
    write_table(table, vertices);
    write_audit(table, vertices);
    for (Index e = 0; 2 * e < static_cast<Index>(table.size()); ++e) {
        for (int time = 0; time < 4; ++time) {
            write_turn(flipping, table, {e}, true);
            write_audit(table, vertices);
        }
        write_turn(unflipping, table, {e}, true);
        write_turn(flipping, table, {e}, true);
    }
}

void write_every_flip(const Triangulation& surface) {
    write_every_flip(surface.table(), surface.vertex_count());
}

/// The same from every surface of a size.
void write_every_flip(Index vertices, Index genus) {
    enumerate_gluings(vertices, genus, [&](HalfedgeTable table) {
        write_every_flip(table, vertices);
        return true;
    });
}

/// The whole table is compared now and then, and at the end.
void write_script(const Triangulation& surface, int flips, std::uint64_t seed) {
    constexpr int between_tables = 1000;
    Table table(surface.table().begin(), surface.table().end());
    RandomStream random(seed);
    write_table(table, surface.vertex_count());
    for (int k = 1; k <= flips; ++k) {
        const auto edges = static_cast<std::uint32_t>(surface.edge_count());
        const Edge e{static_cast<Index>(random.below(edges))};
        write_turn(random.below(4) == 0 ? unflipping : flipping, table, e,
                   k % between_tables == 0 || k == flips);
    }
    write_audit(table, surface.vertex_count());
}

/// Tables with one entry wrong: the audits must agree about what is not allowed, too.
void write_damaged(const Triangulation& surface) {
    const Index vertices = surface.vertex_count();
    const Index halfedges = surface.halfedge_count();
    const Table whole(surface.table().begin(), surface.table().end());
    for (Index h = 0; h < halfedges; ++h) {
        for (Index wrong = 0; wrong < std::max(vertices, halfedges); ++wrong) {
            Table table = whole;
            HalfedgeRecord& record = table[static_cast<std::size_t>(h)];
            if (wrong < vertices && record.origin.id != wrong) {
                record.origin.id = wrong;
                write_table(table, vertices);
                write_audit(table, vertices);
            }
            table = whole;
            if (wrong < halfedges && record.next.id != wrong) {
                table[static_cast<std::size_t>(h)].next.id = wrong;
                write_table(table, vertices);
                write_audit(table, vertices);
            }
        }
    }
    write_table(whole, vertices + 1);  // a label that no corner has
    write_audit(whole, vertices + 1);
}

}  // namespace

int main(int argc, char** argv) {
    constexpr int usual_flips = 100'000;
    const int flips = argc > 1 ? std::atoi(argv[1]) : usual_flips;
    for (Index vertices = 3; vertices <= 6; ++vertices)
        write_every_flip(vertices, 0);
    write_every_flip(3, 1);
    write_every_flip(4, 1);
    write_every_flip(families::torus_grid(3, 3));
    write_every_flip(families::surface_of_genus(2, 10, 1));
    write_damaged(families::tetrahedron());
    write_damaged(families::book(5));
    write_damaged(families::surface_of_genus(1, 4, 1));
    write_script(families::random(100, 0, 1), flips, 2);
    write_script(families::book(50), flips, 3);
    write_script(families::torus_grid(5, 6), flips, 4);
    write_script(families::surface_of_genus(2, 40, 5), flips, 6);
}
