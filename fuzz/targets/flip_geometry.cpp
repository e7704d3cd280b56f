#include "flip_geometry.hpp"

#include "targets.hpp"
#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/geometry_claims.hpp>
#include <tightflip/properties/point_kinds.hpp>

#include <array>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using kernel::Index;

constexpr std::size_t coordinate_bytes = 3 * most_geometry_vertices;

/// The points that the bytes say: on a grid, coordinate by coordinate, or of a kind and a seed.
std::vector<geometry::Point> decode_points(Bytes& bytes, Index vertices) {
    const auto kinds = properties::point_kinds();
    const std::size_t lie = bytes.byte() % (most_coordinate + kinds.size());
    const std::uint32_t seed = bytes.byte();
    const auto largest = static_cast<std::uint32_t>(1 + lie);
    std::vector<geometry::Point> points(most_geometry_vertices);
    for (geometry::Point& point : points) {
        for (double& coordinate : point)
            coordinate = static_cast<double>(bytes.byte() % (2 * largest + 1)) - largest;
    }
    if (lie >= most_coordinate) return kinds[lie - most_coordinate].make(vertices, seed);
    points.resize(static_cast<std::size_t>(vertices), geometry::Point(0, 0, 0));
    return points;
}

void show(std::ostream& out, Input input) {
    const GeometryCase geometry_case = decode_geometry_case(input);
    const kernel::FlipLog log{geometry_case.start.triangulation(), geometry_case.script};
    write_text(out, log);
    for (const geometry::Point& point : geometry_case.start.points())
        out << "point " << point.x() << ' ' << point.y() << ' ' << point.z() << "\n";
    properties::write_in_words(out, log);
}

/// How a seed's points lie: each coordinate byte of an axis is one of so many from the first on.
struct Grid {
    std::string_view name;
    std::uint8_t largest;  ///< coordinate
    std::array<std::uint32_t, 3> values;
};

/// From all in one point to all over the grid; 3 values of 3 are a grid of 27 points.
constexpr std::array grids{
    Grid{"all_in_one_point", 1, {1, 1, 1}},
    Grid{"collinear", 4, {9, 1, 1}},
    Grid{"coplanar", 4, {9, 9, 1}},
    Grid{"in_two_planes", 4, {9, 9, 2}},
    Grid{"corners_of_a_cube", 1, {2, 2, 2}},
    Grid{"grid_1", 1, {3, 3, 3}},
    Grid{"grid_4", 4, {9, 9, 9}},
};

InputBytes geometry_input(const StartBytes& start, const Grid& grid, std::uint64_t seed,
                          std::span<const std::uint32_t> picks) {
    kernel::RandomStream random(seed);
    InputBytes input = script_input(start);
    input.insert(input.end(), {static_cast<std::uint8_t>(grid.largest - 1), 0});
    for (std::size_t k = 0; k < coordinate_bytes; ++k)
        input.push_back(static_cast<std::uint8_t>(random.below(grid.values[k % 3])));
    for (const std::uint32_t pick : picks)
        append_pair(input, pick);
    return input;
}

/// Each kind of points on a sphere and on a surface of higher genus.
void append_point_kinds(std::vector<Seed>& seeds) {
    const auto kinds = properties::point_kinds();
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        for (const std::uint8_t genus : std::array<std::uint8_t, 2>{0, 2}) {
            InputBytes input = script_input({"random", most_spare_vertices, genus, 2});
            input.insert(input.end(), {static_cast<std::uint8_t>(most_coordinate + k), 5});
            input.resize(geometry_layout.head);
            for (std::uint32_t flip = 0; flip < most_geometry_flips; ++flip)
                append_pair(input, 4 * flip);
            seeds.push_back(
                {"points_" + std::string(kinds[k].name) + "_genus_" + std::to_string(genus),
                 std::move(input)});
        }
    }
}

std::vector<Seed> seeds() {
    constexpr std::array<std::uint32_t, most_geometry_flips> here_and_there{0,  5,  10, 15,
                                                                            20, 30, 40, 50};
    constexpr std::array<std::uint32_t, most_geometry_flips> one_edge_again{3, 3, 3, 3, 3, 3, 3, 3};
    std::vector<Seed> seeds{
        {"no_flip", script_input({"tetrahedron"})},
        {"version_alone", {format_version}},
        {"one_edge_again_and_again",
         geometry_input({"stacked", 8, 0, 2}, grids.back(), 1, one_edge_again)}};
    append_point_kinds(seeds);
    std::uint64_t seed = 0;
    for (const properties::StartKind& kind : properties::start_kinds()) {
        for (const Grid& grid : grids) {
            ++seed;
            const auto genus = static_cast<std::uint8_t>(seed % (most_genus + 1));
            seeds.push_back({"kind_" + std::string(kind.name) + "_" + std::string(grid.name),
                             geometry_input({kind.name, most_spare_vertices, genus, 1}, grid, seed,
                                            here_and_there)});
        }
    }
    return seeds;
}

}  // namespace

GeometryCase decode_geometry_case(Input input) {
    Bytes bytes = Bytes::after_version(input);
    kernel::Triangulation start = start_of(decode_start(bytes));
    std::vector<geometry::Point> points = decode_points(bytes, start.vertex_count());
    properties::FlipScript script;
    while (!bytes.empty() && script.size() < most_geometry_flips)
        script.push_back({static_cast<Index>(bytes.pair()) % start.edge_count()});
    return {{std::move(start), std::move(points)}, std::move(script)};
}

std::string geometry_objection(const GeometryCase& geometry_case) {
    const auto finding =
        properties::geometry_claims_hold_at_ends(geometry_case.start, geometry_case.script);
    return finding ? std::string(name(finding->claim)) + ": " + describe(*finding) : std::string();
}

const Target flip_geometry_target{
    .name = "flip_geometry",
    .description =
        "a start with points, many degenerate, and a flip script: curvatures and criteria",
    .layout = geometry_layout,
    .objection = [](Input input) { return geometry_objection(decode_geometry_case(input)); },
    .show = show,
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
