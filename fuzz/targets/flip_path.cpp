#include "flip_path.hpp"

#include "targets.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/certificate.hpp>
#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/find_path.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/shorten.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>
#include <vector>

namespace tightflip::fuzz {
namespace {

using kernel::Edge;
using kernel::FlipLog;
using kernel::Index;
using kernel::Triangulation;

/// A sphere for every number of vertices from `least_path_vertices` on.
struct Family {
    std::string_view name;
    Triangulation (*make)(Index vertices, std::uint64_t seed);
};

constexpr std::array families{
    Family{"book", [](Index vertices, std::uint64_t) { return kernel::families::book(vertices); }},
    Family{"random",
           [](Index vertices, std::uint64_t seed) {
               return kernel::families::random(vertices, 0, seed);
           }},
    Family{"stacked", kernel::families::stacked},
    Family{"double wheel",
           [](Index vertices, std::uint64_t) {
               return vertices > 4 ? kernel::families::double_wheel(vertices)
                                   : kernel::families::tetrahedron();
           }},
};

Triangulation relabelled(const Triangulation& surface, std::uint64_t seed) {
    std::vector<Index> labels(static_cast<std::size_t>(surface.vertex_count()));
    std::iota(labels.begin(), labels.end(), Index{0});
    kernel::RandomStream(seed).shuffle(std::span(labels));
    std::vector<kernel::HalfedgeRecord> records(surface.table().begin(), surface.table().end());
    for (auto& [next, origin] : records)
        origin.id = labels[static_cast<std::size_t>(origin.id)];
    return build(std::move(records), surface.vertex_count()).value();
}

/// An end while it is made, and how.
struct End {
    Triangulation surface;
    std::string words;
};

/// One end before its flips: a family, its seed, and 0 or the seed of a random order of labels.
End decode_end(Bytes& bytes, Index vertices) {
    const Family& family = families[bytes.byte() % families.size()];
    const std::uint32_t seed = bytes.byte();
    const std::uint32_t labels = bytes.byte();
    const Triangulation start = family.make(vertices, seed);
    return {labels == 0 ? start : relabelled(start, labels),
            std::string(family.name) + ", seed " + std::to_string(seed) + ", labels " +
                std::to_string(labels) + ", flips"};
}

void decode_flip(Bytes& bytes, std::array<End, 2>& ends) {
    End& end = ends[bytes.byte() % ends.size()];
    const Edge e{static_cast<Index>(bytes.pair()) % end.surface.edge_count()};
    end.words += " " + std::to_string(e.id);
    if (!end.surface.flip(e)) end.words += " (refused)";
}

std::string written(const FlipLog& log) {
    std::ostringstream out;
    write_binary(out, log);
    return out.str();
}

/// What is wrong with a path of at most so many flips; empty where nothing is.
std::string objection_to(const char* kind, const FlipLog& path, const PathCase& ends,
                         std::size_t most) {
    if (path.flips.size() > most) {
        return std::string(kind) + ": " + std::to_string(path.flips.size()) +
               " flips, more than the bound of " + std::to_string(most);
    }
    const auto verdict = verify(
        ends.from, ends.to, kernel::parse_flip_log_as_written(written(path), "the certificate"));
    if (verdict) return {};
    return std::string(kind) + ": the certificate does not hold: " + verdict.reason;
}

/// An end of a seed.
struct EndBytes {
    std::uint8_t family;
    std::uint8_t seed = 0;
    std::uint8_t labels = 0;
};

constexpr std::uint8_t book = 0;
constexpr std::uint8_t random_sphere = 1;
constexpr std::uint8_t stacked = 2;
constexpr std::uint8_t double_wheel = 3;

struct FlipBytes {
    std::uint8_t end;  ///< 0 from, 1 to
    std::uint32_t edge;
};

InputBytes path_input(Index vertices, const EndBytes& from, const EndBytes& to,
                      std::initializer_list<FlipBytes> flips = {}) {
    InputBytes input{format_version, static_cast<std::uint8_t>(vertices - least_path_vertices)};
    for (const EndBytes& end : {from, to})
        input.insert(input.end(), {end.family, end.seed, end.labels});
    for (const FlipBytes& flip : flips) {
        input.push_back(flip.end);
        append_pair(input, flip.edge);
    }
    return input;
}

/// Every family to every family, of few, of some and of most vertices.
void append_pairs(std::vector<Seed>& seeds) {
    for (const Index vertices : {least_path_vertices, Index{5}, Index{12}, most_path_vertices}) {
        for (std::size_t from = 0; from < families.size(); ++from) {
            for (std::size_t to = 0; to < families.size(); ++to) {
                std::string name = std::string(families[from].name) + "_to_" +
                                   std::string(families[to].name) + "_vertices_" +
                                   std::to_string(vertices);
                std::ranges::replace(name, ' ', '_');
                seeds.push_back(
                    {std::move(name), path_input(vertices, {static_cast<std::uint8_t>(from), 1},
                                                 {static_cast<std::uint8_t>(to), 2, 3})});
            }
        }
    }
}

std::vector<Seed> seeds() {
    std::vector<Seed> seeds{
        {"equal_tetrahedra", path_input(4, {book}, {book})},
        {"version_alone", {format_version}},
        {"book_to_book_in_another_order", path_input(40, {book}, {book, 0, 9})},
        {"double_wheel_to_book", path_input(24, {double_wheel}, {book, 0, 2})},
        {"equal_ends_of_forty_vertices", path_input(40, {random_sphere, 5}, {random_sphere, 5})},
        {"five_vertices_six_flips_apart", path_input(5, {book}, {book, 0, 3})},
        {"flips_at_both_ends",
         path_input(12, {stacked, 1}, {double_wheel},
                    {{0, 4}, {0, 3}, {0, 7}, {0, 9}, {1, 1}, {1, 20}, {1, 11}, {1, 2}, {1, 968}})},
        {"flips_that_are_refused",
         path_input(7, {book}, {book, 0, 1},
                    {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {1, 6}, {1, 7}, {1, 8}})},
        {"odd_last_byte", with_version(InputBytes{5, 1, 1, 1, 2, 2, 2, 0, 9})},
        {"one_flip_apart", path_input(16, {random_sphere, 3}, {random_sphere, 3}, {{0, 7}})},
        {"stacked_to_random", path_input(20, {stacked, 11}, {random_sphere, 12, 5})},
        {"tetrahedron_to_its_mirror_image", path_input(4, {double_wheel}, {double_wheel, 0, 1})},
        {"two_shuffled_books", path_input(30, {book, 0, 3}, {book, 0, 4})},
    };
    append_pairs(seeds);
    return seeds;
}

void show(std::ostream& out, Input input) {
    const PathCase ends = decode_path_case(input);
    out << ends.words << "\n";
    write_text(out, ends.from);
    write_text(out, ends.to);
}

}  // namespace

PathCase decode_path_case(Input input) {
    Bytes bytes = Bytes::after_version(input);
    const Index vertices =
        least_path_vertices + bytes.below(most_path_vertices - least_path_vertices + 1);
    End from = decode_end(bytes, vertices);
    std::array ends{std::move(from), decode_end(bytes, vertices)};
    for (std::size_t k = 0; k < path_layout.most_records && !bytes.empty(); ++k)
        decode_flip(bytes, ends);
    auto& [first, second] = ends;
    return {std::move(first.surface), std::move(second.surface),
            "V = " + std::to_string(vertices) + "; from: " + first.words + "; to: " + second.words};
}

std::string path_objection(const PathCase& ends) {
    const kernel::ConnectResult connected = connect(ends.from, ends.to);
    if (!connected) return "connect: no path: " + std::string(describe(connected.refusal));
    const FlipLog& path = connected.value();
    const auto bound = static_cast<std::size_t>(kernel::connect_bound(ends.from.vertex_count()));
    if (auto wrong = objection_to("connect", path, ends, bound); !wrong.empty()) return wrong;
    const FlipLog shorter = kernel::shorten(path);
    if (auto wrong = objection_to("shorten", shorter, ends, path.flips.size()); !wrong.empty()) {
        return wrong;
    }
    constexpr Index few_vertices = 5;
    if (ends.from.vertex_count() > few_vertices) return {};
    const kernel::PathSearch search = find_path(ends.from, ends.to, {.shortest = true});
    if (!search) return "find_path: " + std::string(describe(search.outcome));
    return objection_to("find_path", *search.path, ends, shorter.flips.size());
}

const Target flip_path_target{
    .name = "flip_path",
    .description = "two labelled spheres: paths within their bounds, certificates, shortest paths",
    .layout = path_layout,
    .objection = [](Input input) { return path_objection(decode_path_case(input)); },
    .show = show,
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
