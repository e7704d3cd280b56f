#include "flip_path.hpp"

#include "bytes.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/certificate.hpp>
#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/find_path.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/shorten.hpp>

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

/// One end before its flips: a family, its seed, and 0 or the seed of a random order of labels.
Triangulation decode_start(Bytes& bytes, Index vertices, std::ostream& words) {
    const Family& family = families[bytes.byte() % families.size()];
    const std::uint32_t seed = bytes.byte();
    const std::uint32_t labels = bytes.byte();
    words << family.name << ", seed " << seed << ", labels " << labels;
    const Triangulation start = family.make(vertices, seed);
    return labels == 0 ? start : relabelled(start, labels);
}

void decode_flips(Bytes& bytes, std::size_t most, Triangulation& surface, std::ostream& words) {
    words << ", flips";
    for (std::size_t k = 0; k < most && !bytes.empty(); ++k) {
        const Edge e{static_cast<Index>(bytes.pair()) % surface.edge_count()};
        words << ' ' << e.id;
        if (!surface.flip(e)) words << " (refused)";
    }
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

}  // namespace

PathCase decode_path_case(std::span<const std::uint8_t> data) {
    Bytes bytes(data);
    const Index vertices =
        least_path_vertices + bytes.below(most_path_vertices - least_path_vertices + 1);
    std::ostringstream from_words;
    std::ostringstream to_words;
    Triangulation from = decode_start(bytes, vertices, from_words);
    Triangulation to = decode_start(bytes, vertices, to_words);
    const std::size_t flips = bytes.byte() % (most_flips_an_end + 1);
    decode_flips(bytes, flips, from, from_words);
    decode_flips(bytes, most_flips_an_end, to, to_words);
    return {std::move(from), std::move(to),
            "V = " + std::to_string(vertices) + "; from: " + from_words.str() +
                "; to: " + to_words.str()};
}

std::string path_objection(const PathCase& ends) {
    const kernel::ConnectResult connected = connect(ends.from, ends.to);
    if (!connected) return "no path: " + std::string(describe(connected.refusal));
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

}  // namespace tightflip::fuzz
