#include "adversarial_starts.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/generators.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace tightflip::properties {
namespace {

namespace families = kernel::families;

[[noreturn]] void refuse_size(std::string_view kind, Index vertices, std::string_view sizes) {
    throw std::invalid_argument("no " + std::string(kind) + " has " + std::to_string(vertices) +
                                " vertices; sizes are " + std::string(sizes));
}

/// The level at which a subdivided solid has V = faces_factor * 4^level + 2 vertices.
int level_of(std::string_view kind, Index vertices, Index factor, std::string_view sizes) {
    int level = 0;
    for (std::int64_t size = factor; size + 2 <= vertices; size *= 4, ++level) {
        if (size + 2 == vertices) return level;
    }
    refuse_size(kind, vertices, sizes);
}

Index half_of(std::string_view kind, Index vertices) {
    if (vertices % 2 != 0) refuse_size(kind, vertices, "6, 8, 10, ...");
    return vertices / 2;
}

template <Index least>
constexpr Index at_least(Index) {
    return least;
}

constexpr Index least_of_genus(Index genus) {
    return genus == 0 ? 4 : 3;
}

constexpr std::array kinds{
    StartKind{"tetrahedron", "4 vertices", at_least<4>, false,
              [](const StartRequest& r) {
                  if (r.vertices != 4) refuse_size("tetrahedron", r.vertices, "4");
                  return families::tetrahedron();
              }},
    StartKind{"book", "V - 2 parallel edges between two poles, a degree-2 vertex in each digon",
              at_least<3>, false, [](const StartRequest& r) { return families::book(r.vertices); }},
    StartKind{"double-wheel", "two poles over a rim of V - 2 vertices", at_least<5>, false,
              [](const StartRequest& r) { return families::double_wheel(r.vertices); }},
    StartKind{"stacked", "a tetrahedron with vertices put into random faces", at_least<4>, false,
              [](const StartRequest& r) { return families::stacked(r.vertices, r.seed); }},
    StartKind{"prism", "two polygons of V / 2 corners joined by a band of quadrilaterals",
              at_least<6>, false,
              [](const StartRequest& r) { return families::prism(half_of("prism", r.vertices)); }},
    StartKind{"antiprism", "two polygons of V / 2 corners joined by a zig-zag band", at_least<6>,
              false,
              [](const StartRequest& r) {
                  return families::antiprism(half_of("antiprism", r.vertices));
              }},
    StartKind{"octasphere", "the octahedron, its faces cut into four again and again", at_least<6>,
              false,
              [](const StartRequest& r) {
                  return families::octasphere(
                      level_of("octasphere", r.vertices, 4, "6, 18, 66, 258, ... (4^k + 2)"));
              }},
    StartKind{"icosphere", "the icosahedron, its faces cut into four again and again", at_least<12>,
              false,
              [](const StartRequest& r) {
                  return families::icosphere(level_of("icosphere", r.vertices, 10,
                                                      "12, 42, 162, 642, ... (10 * 4^k + 2)"));
              }},
    StartKind{"torus", "a grid of 3 by V / 3 squares closed in both directions", at_least<9>, false,
              [](const StartRequest& r) {
                  if (r.vertices % 3 != 0) refuse_size("torus", r.vertices, "9, 12, 15, ...");
                  return families::torus_grid(3, r.vertices / 3);
              }},
    StartKind{"genus", "a connected sum of tori with vertices put into random faces",
              least_of_genus, true,
              [](const StartRequest& r) {
                  return families::surface_of_genus(r.genus, r.vertices, r.seed);
              }},
    StartKind{"random", "a surface of the genus after 20 random flips an edge", least_of_genus,
              true,
              [](const StartRequest& r) { return families::random(r.vertices, r.genus, r.seed); }},
    StartKind{"fan", "two fans about vertex 0 glued along a polygon: every face contains it",
              at_least<3>, false,
              [](const StartRequest& r) { return adversarial::fan(r.vertices); }},
    StartKind{"degree-2-chain", "a vertex of degree 2 in a digon in a digon in a digon ...",
              at_least<3>, true,
              [](const StartRequest& r) {
                  return adversarial::degree_two_chain(r.genus, r.vertices, r.seed);
              }},
    StartKind{
        "digons", "random edges opened into digons with a vertex of degree 2 in each", at_least<3>,
        true,
        [](const StartRequest& r) { return adversarial::digons(r.genus, r.vertices, r.seed); }},
    StartKind{"hub", "a surface of the genus whose every face contains vertex 0", least_of_genus,
              true,
              [](const StartRequest& r) { return adversarial::hub(r.genus, r.vertices, r.seed); }},
    StartKind{
        "simple", "a simple surface of the genus after 20 random flips an edge that keep it so",
        [](Index genus) { return genus == 0 ? Index{4} : 6 * genus + 3; }, true,
        [](const StartRequest& r) { return adversarial::simple(r.genus, r.vertices, r.seed); }},
};

}  // namespace

std::span<const StartKind> start_kinds() noexcept {
    return kinds;
}

const StartKind* find_start_kind(std::string_view name) noexcept {
    const auto* const kind = std::ranges::find(kinds, name, &StartKind::name);
    return kind == kinds.end() ? nullptr : kind;
}

Triangulation make_nearest(const StartKind& kind, StartRequest request) {
    const Index least = kind.least_vertices(request.genus);
    for (request.vertices = std::max(request.vertices, least); request.vertices > least;
         --request.vertices) {
        try {
            return kind.make(request);
        } catch (const std::invalid_argument&) {  // not one of the kind's sizes
        }
    }
    return kind.make(request);
}

FlipScript random_script(const Triangulation& start, std::size_t length,
                         kernel::RandomStream& random) {
    FlipScript script(length);
    const auto edges = static_cast<std::uint32_t>(start.edge_count());
    for (Edge& e : script)
        e = {static_cast<Index>(random.below(edges))};
    return script;
}

FlipScript without_refused(Triangulation start, std::span<const Edge> script) {
    FlipScript done;
    for (const Edge e : script) {
        if (start.flip(e)) done.push_back(e);
    }
    return done;
}

}  // namespace tightflip::properties
