#include "gluing.hpp"

#include "bytes.hpp"
#include "reading.hpp"
#include "seed_surfaces.hpp"
#include "targets.hpp"
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/audit_ladder.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/quick_audit.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using kernel::AuditReport;
using kernel::GluedFace;
using kernel::Gluing;
using kernel::Index;
using kernel::SideGluing;
using kernel::Triangulation;
using kernel::ViolationCode;

// ---- bytes ----

constexpr Layout layout{.head = 2, .record = 6, .most_records = most_glued_faces};

/// 0: not glued; else in turn coherent and reversed to side -1, 0, 1, ...
SideGluing decode_side(std::uint32_t byte) {
    if (byte == 0) return {};
    const auto side = static_cast<Index>((byte - 1) / 2) - 1;
    return byte % 2 == 1 ? SideGluing::coherent(side) : SideGluing::reversed(side);
}

std::uint8_t encode_side(SideGluing side) {
    if (!side.is_glued()) return 0;
    return static_cast<std::uint8_t>(2 * (side.side() + 1) + (side.is_reversed() ? 2 : 1));
}

// ---- judging by heaps ----

/// Things in heaps that can be put together.
class Heaps {
public:
    explicit Heaps(std::size_t things) : heap_(things) {
        std::iota(heap_.begin(), heap_.end(), std::size_t{0});
    }
    void join(std::size_t a, std::size_t b) {
        const std::size_t from = heap_[a];
        const std::size_t to = heap_[b];
        for (std::size_t& heap : heap_)
            heap = heap == from ? to : heap;
    }
    [[nodiscard]] bool together(std::size_t a, std::size_t b) const { return heap_[a] == heap_[b]; }
    [[nodiscard]] std::size_t count() const {
        std::vector<std::size_t> heaps = heap_;
        std::ranges::sort(heaps);
        return static_cast<std::size_t>(std::unique(heaps.begin(), heaps.end()) - heaps.begin());
    }

private:
    std::vector<std::size_t> heap_;
};

struct Side {
    Index from, to;  // the labels of its ends
    SideGluing glued;
};

Side side_at(const Gluing& gluing, std::size_t side) {
    const GluedFace& face = gluing.faces[side / 3];
    return {face.corners[side % 3], face.corners[(side + 1) % 3], face.sides[side % 3]};
}

/// Numbers in range, an involution without fixed sides, ends that agree.
bool sides_agree(const Gluing& gluing) {
    const auto sides = static_cast<Index>(3 * gluing.faces.size());
    for (Index s = 0; s < sides; ++s) {
        const Side side = side_at(gluing, static_cast<std::size_t>(s));
        if (side.from < 0 || side.from >= gluing.vertex_count || side.from == side.to ||
            !side.glued.is_glued()) {
            return false;
        }
        const Index t = side.glued.side();
        if (t < 0 || t >= sides || t == s) return false;
        const Side other = side_at(gluing, static_cast<std::size_t>(t));
        if (!other.glued.is_glued() || other.glued.side() != s) return false;
        const bool agree = side.glued.is_reversed()
                               ? side.from == other.from && side.to == other.to
                               : side.from == other.to && side.to == other.from;
        if (!agree) return false;
    }
    return true;
}

bool three_neighbour_rule_holds(const Gluing& gluing) {
    return gluing.faces.size() == 2 ||
           std::ranges::none_of(gluing.faces, [](const GluedFace& face) {
               const auto& [a, b, c] = face.sides;
               return a.side() / 3 == b.side() / 3 && b.side() / 3 == c.side() / 3;
           });
}

/// The corners of each vertex are one heap, and there is one for each vertex.
bool vertices_are_whole(const Gluing& gluing) {
    const std::size_t sides = 3 * gluing.faces.size();
    Heaps corners(sides);
    const auto corner_of = [&](std::size_t side, Index vertex) {
        return side_at(gluing, side).from == vertex ? side : side / 3 * 3 + (side % 3 + 1) % 3;
    };
    for (std::size_t s = 0; s < sides; ++s) {
        const Side side = side_at(gluing, s);
        const auto t = static_cast<std::size_t>(side.glued.side());
        corners.join(s, corner_of(t, side.from));
    }
    std::vector<Index> labels;
    for (const GluedFace& face : gluing.faces)
        labels.insert(labels.end(), face.corners.begin(), face.corners.end());
    std::ranges::sort(labels);
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    return static_cast<Index>(labels.size()) == gluing.vertex_count &&
           corners.count() == labels.size();
}

/// Faces with each of their two orientations: a surface that is whole and has two sides makes two
/// heaps.
bool is_connected_and_two_sided(const Gluing& gluing) {
    Heaps oriented(2 * gluing.faces.size());
    Heaps faces(gluing.faces.size());
    for (std::size_t s = 0; s < 3 * gluing.faces.size(); ++s) {
        const SideGluing glued = side_at(gluing, s).glued;
        const std::size_t here = s / 3;
        const auto there = static_cast<std::size_t>(glued.side() / 3);
        const std::size_t turned = glued.is_reversed() ? 1 : 0;
        oriented.join(2 * here, 2 * there + turned);
        oriented.join(2 * here + 1, 2 * there + (1 - turned));
        faces.join(here, there);
    }
    return faces.count() == 1 && oriented.count() == 2;
}

// ---- claims ----

std::string first_violation(const AuditReport& report) {
    if (report.violations.empty()) return "no violation";
    return where(report.violations.front()) + ": " + message(report.violations.front());
}

std::map<ViolationCode, int> counts_by_code(const AuditReport& report) {
    std::map<ViolationCode, int> counts;
    for (const kernel::Violation& violation : report.violations)
        ++counts[violation.code];
    return counts;
}

std::string rearranging_changes_nothing(const Gluing& gluing, const AuditReport& report) {
    constexpr kernel::AuditOptions keep_all{.max_per_code = 1 << 20};
    const std::uint64_t seed = gluing.faces.size() + static_cast<std::size_t>(gluing.vertex_count);
    const AuditReport again = audit(rearranged(gluing, seed), keep_all);
    const bool same = again.topology == report.topology && again.degrees == report.degrees &&
                      again.parallels == report.parallels &&
                      again.reached_top == report.reached_top &&
                      counts_by_code(again) == counts_by_code(audit(gluing, keep_all));
    return same ? std::string()
                : "rearranging_changes_nothing: " + first_violation(report) +
                      "; rearranged: " + first_violation(again);
}

std::string heaps_agree(const Gluing& gluing, const AuditReport& report) {
    const HeapJudgement judgement = judge_by_heaps(gluing);
    if (judgement.is_allowed != report.is_valid()) {
        return "audit_is_right: the heaps say " +
               std::string(judgement.is_allowed ? "allowed" : "not allowed") +
               ", the audit: " + first_violation(report);
    }
    if (judgement.is_allowed &&
        judgement.euler_characteristic != report.topology.euler_characteristic) {
        return "audit_is_right: the Euler characteristic is " +
               std::to_string(judgement.euler_characteristic) + ", the audit says " +
               std::to_string(report.topology.euler_characteristic);
    }
    return {};
}

/// The k-th edge is the k-th side whose partner comes later, with its corners.
bool has_edges_of(const Triangulation& surface, const Gluing& gluing) {
    Index edge = 0;
    for (std::size_t s = 0; s < 3 * gluing.faces.size(); ++s) {
        const Side side = side_at(gluing, s);
        if (static_cast<std::size_t>(side.glued.side()) < s) continue;
        const kernel::Halfedge h = kernel::halfedge_of({edge++});
        const bool as_listed = surface.origin(h).id == side.from && surface.target(h).id == side.to;
        const bool turned = surface.origin(h).id == side.to && surface.target(h).id == side.from;
        const Index far = gluing.faces[s / 3].corners[(s + 2) % 3];
        if (!(s < 3 ? as_listed : as_listed || turned) || surface.opposite(h).id != far) {
            return false;
        }
    }
    return edge == surface.edge_count();
}

std::string builder_agrees(const Gluing& gluing, const AuditReport& report) {
    const kernel::BuildResult built = build(gluing);
    if (static_cast<bool>(built) != report.is_valid()) {
        return "builder_agrees_with_audit: the audit says " + first_violation(report) +
               ", the builder " + first_violation(built.report);
    }
    if (!built) return {};
    const Triangulation& surface = built.value();
    if (!kernel::passes_audit(surface.table(), surface.vertex_count()))
        return "quick_judge_agrees: no";
    if (audit(surface).topology != report.topology) {
        return "table_has_the_topology_of_its_gluing: " + first_violation(audit(surface));
    }
    if (!has_edges_of(surface, gluing)) return "edges_are_numbered_by_first_sides: they are not";
    return {};
}

/// A gluing made from the corners alone is the gluing wherever these determine it.
std::string face_lists_agree(const Gluing& gluing, const AuditReport& report) {
    std::vector<std::array<Index, 3>> corners;
    for (const GluedFace& face : gluing.faces)
        corners.push_back(face.corners);
    const kernel::FaceListReading reading = kernel::glue_faces(corners, gluing.vertex_count);
    if (reading.gluing.faces.size() != corners.size()) return "face_lists_keep_faces: they do not";
    const AuditReport list_report = audit(reading.gluing);
    const kernel::BuildResult built = kernel::build(corners, gluing.vertex_count);
    const bool determined = reading.violations.empty() && list_report.is_valid();
    if (static_cast<bool>(built) != (determined && list_report.coherently_stored)) {
        return "face_lists_are_built_where_they_are_surfaces: " + first_violation(built.report);
    }
    if (determined && report.is_valid() && list_report.topology != report.topology) {
        return "face_lists_determine_simple_gluings: " + first_violation(list_report);
    }
    if (report.is_valid() && report.parallels->pairs_joined_twice == 0 && !determined) {
        return "face_lists_determine_simple_gluings: " + first_violation(list_report);
    }
    return {};
}

std::string text_keeps_it(const Gluing& gluing) {
    const std::string text = written([&](std::ostream& out) { write_text(out, gluing); });
    const kernel::RawSurface read = kernel::parse_surface(text, "the gluing");
    return std::get<Gluing>(read) == gluing ? std::string() : "text_keeps_gluings: it does not";
}

// ---- seeds ----

Gluing gluing_of(const Triangulation& surface) {
    return read_table(surface.table(), surface.vertex_count()).gluing;
}

/// Faces by corners and sides, glued as the format writes them: 7 coherent, -7 reversed (less 1).
constexpr Index open = 1000;
struct Row {
    std::array<Index, 3> corners;
    std::array<Index, 3> sides;
};

Gluing from_rows(Index vertices, std::initializer_list<Row> rows) {
    Gluing gluing{.vertex_count = vertices, .faces = {}};
    for (const auto& [corners, sides] : rows) {
        GluedFace& face = gluing.faces.emplace_back();
        face.corners = corners;
        for (std::size_t i = 0; i < 3; ++i) {
            if (sides[i] == open) continue;
            face.sides[i] = sides[i] >= 0 ? SideGluing::coherent(sides[i])
                                          : SideGluing::reversed(-1 - sides[i]);
        }
    }
    return gluing;
}

/// Two gluings side by side, the labels of the second moved by `shift`.
Gluing beside(const Gluing& first, const Gluing& second, Index shift) {
    Gluing both = first;
    both.vertex_count = shift + second.vertex_count;
    const auto sides = static_cast<Index>(3 * first.faces.size());
    for (GluedFace face : second.faces) {
        for (Index& corner : face.corners)
            corner += shift;
        for (SideGluing& side : face.sides)
            side = SideGluing::coherent(side.side() + sides);
        both.faces.push_back(face);
    }
    return both;
}

Gluing glued_by_labels(Index vertices, std::initializer_list<std::array<Index, 3>> faces) {
    const std::vector<std::array<Index, 3>> list(faces);
    return kernel::glue_faces(list, vertices).gluing;
}

std::vector<Seed> seeds() {
    namespace families = kernel::families;
    const Gluing tetrahedron = gluing_of(families::tetrahedron());
    Gluing with_unused = tetrahedron;
    with_unused.vertex_count = 6;
    Gluing with_damaged_side = tetrahedron;
    with_damaged_side.faces[1].sides[2] = SideGluing::coherent(3);
    Gluing with_wrong_bit = tetrahedron;
    with_wrong_bit.faces[0].sides[0] = SideGluing::reversed(tetrahedron.faces[0].sides[0].side());
    Gluing with_wrong_label = tetrahedron;
    with_wrong_label.faces[0].corners[0] = 6 - tetrahedron.faces[0].corners[0] -
                                           tetrahedron.faces[0].corners[1] -
                                           tetrahedron.faces[0].corners[2];
    Gluing out_of_range = tetrahedron;
    out_of_range.faces[2] = {{-1, 4, 2}, {SideGluing::coherent(12), SideGluing::coherent(-1), {}}};

    std::vector<std::pair<std::string, Gluing>> named{
        {"no_faces", Gluing{}},
        {"more_vertices_than_corners", from_rows(4, {{{0, 1, 2}, {open, open, open}}})},
        {"sphere_of_two_faces", gluing_of(families::book(3))},
        {"tetrahedron_turned_over_in_part", rearranged(tetrahedron, 5)},
        {"loop", from_rows(2, {{{0, 0, 1}, {3, 4, 5}}, {{0, 0, 1}, {0, 1, 2}}})},
        {"sphere_with_a_loop", from_rows(1, {{{0, 0, 0}, {5, 4, 3}}, {{0, 0, 0}, {2, 1, 0}}})},
        {"triangle_alone", from_rows(3, {{{0, 1, 2}, {open, open, open}}})},
        {"tetrahedron_open", glued_by_labels(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}})},
        {"side_glued_to_itself", from_rows(3, {{{0, 1, 2}, {0, 1, 2}}})},
        {"three_neighbours_coincide", from_rows(4, {{{0, 1, 2}, {5, 4, 3}},
                                                    {{0, 2, 1}, {2, 1, 0}},
                                                    {{0, 1, 2}, {11, 10, 9}},
                                                    {{0, 2, 1}, {8, 7, 6}}})},
        {"projective_plane", glued_by_labels(6, {{0, 1, 2},
                                                 {0, 2, 3},
                                                 {0, 3, 4},
                                                 {0, 4, 5},
                                                 {0, 5, 1},
                                                 {1, 2, 4},
                                                 {2, 3, 5},
                                                 {3, 4, 1},
                                                 {4, 5, 2},
                                                 {5, 1, 3}})},
        {"two_tetrahedra", beside(tetrahedron, tetrahedron, 4)},
        {"two_tetrahedra_at_a_vertex", beside(tetrahedron, tetrahedron, 3)},
        {"two_tetrahedra_at_an_edge", beside(tetrahedron, tetrahedron, 2)},
        {"two_unused_vertices", with_unused},
        {"not_an_involution", with_damaged_side},
        {"coherence_bit_contradicts", with_wrong_bit},
        {"labels_disagree", with_wrong_label},
        {"numbers_out_of_range", out_of_range},
    };
    for (const SeedSurface& seed : seed_surfaces())
        named.emplace_back(seed.name, gluing_of(seed.surface));
    std::vector<Seed> seeds;
    seeds.reserve(named.size());
    for (const auto& [name, gluing] : named)
        seeds.push_back({name, encode_gluing(gluing)});
    return seeds;
}

}  // namespace

Gluing decode_gluing(Input input) {
    Bytes bytes = Bytes::after_version(input.first(std::min(input.size(), layout.most_bytes())));
    Gluing gluing{.vertex_count = static_cast<Index>(bytes.byte()) - 1, .faces = {}};
    while (!bytes.empty()) {
        GluedFace& face = gluing.faces.emplace_back();
        for (Index& corner : face.corners)
            corner = static_cast<Index>(bytes.byte()) - 1;
        for (SideGluing& side : face.sides)
            side = decode_side(bytes.byte());
    }
    return gluing;
}

InputBytes encode_gluing(const Gluing& gluing) {
    InputBytes bytes{format_version, static_cast<std::uint8_t>(gluing.vertex_count + 1)};
    for (const GluedFace& face : gluing.faces) {
        for (const Index corner : face.corners)
            bytes.push_back(static_cast<std::uint8_t>(corner + 1));
        for (const SideGluing side : face.sides)
            bytes.push_back(encode_side(side));
    }
    return bytes;
}

Gluing rearranged(const Gluing& gluing, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    const auto faces = static_cast<Index>(gluing.faces.size());
    std::vector<Index> place(gluing.faces.size());
    std::iota(place.begin(), place.end(), Index{0});
    random.shuffle(std::span(place));
    std::vector<Index> label(static_cast<std::size_t>(std::max(gluing.vertex_count, Index{0})));
    std::iota(label.begin(), label.end(), Index{0});
    random.shuffle(std::span(label));
    struct Turn {
        Index first;
        bool over;
    };
    std::vector<Turn> turns(gluing.faces.size());
    for (Turn& turn : turns)
        turn = {static_cast<Index>(random.below(3)), random.below(2) == 1};

    const auto exists = [&](Index face) { return face >= 0 && face < faces; };
    const auto is_over = [&](Index face) {
        return exists(face) && turns[static_cast<std::size_t>(face)].over;
    };
    const auto new_side = [&](Index side) {
        if (side < 0 || !exists(side / 3)) return side;
        const auto face = static_cast<std::size_t>(side / 3);
        const auto [first, over] = turns[face];
        const Index i = over ? first + 2 - side % 3 : side % 3 + 3 - first;
        return 3 * place[face] + i % 3;
    };
    Gluing result{.vertex_count = gluing.vertex_count,
                  .faces = std::vector<GluedFace>(gluing.faces.size())};
    for (Index f = 0; f < faces; ++f) {
        const auto face = static_cast<std::size_t>(f);
        GluedFace& moved = result.faces[static_cast<std::size_t>(place[face])];
        const auto [first, over] = turns[face];
        for (Index j = 0; j < 3; ++j) {
            const Index old =
                gluing.faces[face]
                    .corners[static_cast<std::size_t>((over ? first + 3 - j : first + j) % 3)];
            const bool is_label = old >= 0 && old < gluing.vertex_count;
            moved.corners[static_cast<std::size_t>(j)] =
                is_label ? label[static_cast<std::size_t>(old)] : old;
        }
        for (Index i = 0; i < 3; ++i) {
            const SideGluing old = gluing.faces[face].sides[static_cast<std::size_t>(i)];
            if (!old.is_glued()) continue;
            const bool reversed =
                old.is_reversed() != (over != is_over(old.side() < 0 ? -1 : old.side() / 3));
            moved.sides[static_cast<std::size_t>(new_side(3 * f + i) % 3)] =
                reversed ? SideGluing::reversed(new_side(old.side()))
                         : SideGluing::coherent(new_side(old.side()));
        }
    }
    return result;
}

HeapJudgement judge_by_heaps(const Gluing& gluing) {
    if (gluing.faces.empty() || !sides_agree(gluing) || !three_neighbour_rule_holds(gluing) ||
        !vertices_are_whole(gluing) || !is_connected_and_two_sided(gluing)) {
        return {};
    }
    const auto faces = static_cast<Index>(gluing.faces.size());
    return {true, gluing.vertex_count - 3 * faces / 2 + faces};
}

std::string gluing_objection(const Gluing& gluing) {
    const AuditReport report = audit(gluing);
    for (const std::string& objection :
         {heaps_agree(gluing, report), rearranging_changes_nothing(gluing, report),
          builder_agrees(gluing, report), face_lists_agree(gluing, report),
          text_keeps_it(gluing)}) {
        if (!objection.empty()) return objection;
    }
    return {};
}

const Target gluing_target{
    .name = "gluing",
    .description = "a raw gluing table: audit, builders and text format agree on what it is",
    .layout = layout,
    .objection = [](Input input) { return gluing_objection(decode_gluing(input)); },
    .show =
        [](std::ostream& out, Input input) {
            const Gluing gluing = decode_gluing(input);
            write_text(out, gluing);
            for (const kernel::Violation& violation : audit(gluing).violations)
                out << where(violation) << ": " << message(violation) << '\n';
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
