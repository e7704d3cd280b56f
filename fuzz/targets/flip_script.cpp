#include "flip_script.hpp"

#include "small_classes.hpp"
#include "targets.hpp"
#include <tightflip/properties/claims.hpp>

#include <array>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using kernel::Index;
using properties::Edge;
using properties::Finding;
using properties::Triangulation;

struct NamedClaim {
    std::string_view name;
    std::optional<Finding> (*check)(const Triangulation&, std::span<const Edge>);
};

constexpr std::array claims{
    NamedClaim{"topology_is_preserved",
               [](const Triangulation& start, std::span<const Edge> script) {
                   return properties::topology_is_preserved(start, script);
               }},
    NamedClaim{"reference_model_agrees", properties::reference_model_agrees},
    NamedClaim{"flip_laws_hold", properties::flip_laws_hold},
};

/// So many edges, every so many-th.
std::vector<std::uint32_t> every(std::uint32_t step, std::size_t count) {
    std::vector<std::uint32_t> picks(count);
    for (std::uint32_t k = 0; std::uint32_t & pick : picks)
        pick = step * k++;
    return picks;
}

/// Each kind of start as small as it can be, and as large, under a script of full length.
void append_kinds(std::vector<Seed>& seeds) {
    constexpr std::uint32_t stride = 7;
    for (const properties::StartKind& kind : properties::start_kinds()) {
        for (Index genus = 0; genus <= (kind.any_genus ? most_genus : 0); ++genus) {
            for (const Index spare : {Index{0}, most_spare_vertices}) {
                const StartBytes start{kind.name, static_cast<std::uint8_t>(spare),
                                       static_cast<std::uint8_t>(genus), 1};
                seeds.push_back({"kind_" + std::string(kind.name) + "_genus_" +
                                     std::to_string(genus) + "_spare_" + std::to_string(spare),
                                 script_input(start, every(stride, most_flips))});
            }
        }
    }
}

}  // namespace

std::vector<Seed> script_seeds() {
    std::vector<Seed> seeds{
        {"no_flip", script_input({"tetrahedron"})},
        {"version_alone", {format_version}},
        {"odd_last_byte", with_version(InputBytes{5, 2, 0, 0, 3, 0, 44, 1, 5})},
        {"tetrahedron_every_edge", script_input({"tetrahedron"}, every(1, 6))},
        {"tetrahedron_same_edge_four_times", script_input({"tetrahedron"}, {2, 2, 2, 2})},
        {"degree_three_to_two_to_three", script_input({"tetrahedron"}, {0, 0, 0, 0, 1, 1})},
        {"two_face_sphere_all_refused", script_input({"book"}, every(1, 3))},
        {"book_degree_two_vertices", script_input({"book", 4}, every(1, 15))},
        {"book_long_way", script_input({"book", 6}, {0, 3, 6, 9, 12, 1, 4,  7,  10, 0,
                                                     0, 5, 5, 5, 2,  8, 11, 14, 17, 20})},
        {"double_wheel_spokes_to_one_hub",
         script_input({"double-wheel", 5}, {2, 5, 8, 11, 14, 17, 1, 4})},
        {"simple_sphere_to_multigraph", script_input({"stacked", 9, 0, 42}, every(5, most_flips))},
        {"torus_grid", script_input({"torus", 3}, every(2, 18))},
        {"torus_of_three_vertices_all_refused", script_input({"genus", 0, 1}, every(1, 9))},
        {"torus_of_four_vertices", script_input({"genus", 1, 1, 3}, every(1, 24))},
        {"genus_two_three_vertices", script_input({"genus", 0, 2, 1}, every(1, 15))},
        {"genus_two_parallel_edges", script_input({"random", 3, 2, 7}, every(7, most_flips))},
        {"genus_three_picks_beyond_a_byte",
         script_input({"random", 8, 3, 255}, every(64539, most_flips))},
        {"longer_than_the_limit", script_input({"icosphere"}, every(13, 2 * most_flips))},
    };
    append_kinds(seeds);
    for (const SmallClass& one : small_classes()) {
        seeds.push_back({one.name, script_input(one.start, one.flips)});
    }
    return seeds;
}

void show_script(std::ostream& out, Input input) {
    const properties::FlipCase flip_case = decode_script(input);
    out << describe(flip_case) << "\n";
    properties::write_in_words(out, flip_case.log());
}

std::string script_objection(const properties::FlipCase& flip_case) {
    const Triangulation& start = start_of(flip_case);
    const properties::FlipScript script = script_of(flip_case);
    for (const auto& [name, check] : claims) {
        if (const auto finding = check(start, script)) {
            return std::string(name) + ": " + describe(*finding);
        }
    }
    return {};
}

const Target flip_script_target{
    .name = "flip_script",
    .description = "a start and a flip script: topology, reference model and flip laws",
    .layout = script_layout,
    .objection = [](Input input) { return script_objection(decode_script(input)); },
    .show = show_script,
    .seeds = script_seeds,
};

}  // namespace tightflip::fuzz
