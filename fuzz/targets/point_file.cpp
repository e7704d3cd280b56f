#include "point_file.hpp"

#include "mesh_samples.hpp"
#include "reading.hpp"
#include "seed_surfaces.hpp"
#include "targets.hpp"
#include <tightflip/geometry/point_file.hpp>
#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/plain_writer.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <algorithm>
#include <array>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using geometry::Point;

/// The first byte chooses one of these, modulo their number.
constexpr std::array<std::string_view, 6> names{"points",     "points.obj", "points.off",
                                                "points.ply", "points.stl", "points.tfs"};

constexpr std::array<std::string_view, 3> whole_file_reasons{
    "the file has no points", "this format has no coordinates", "the file is empty"};

std::string as_lines(const std::vector<Point>& points) {
    return written([&](std::ostream& out) {
        kernel::PlainWriter text(out);
        for (const Point& p : points)
            text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    });
}

struct Sample {
    const char* name;
    const char* text;
};
constexpr std::array samples{
    Sample{"bare", "0 0 0\n1 0 0\n# a comment\n\n0 1e300 5e-324\n-0 +1 .5\n"},
    Sample{"bare_windows", "0 0 0\r\n1 0 0\r\n"},
    Sample{"bare_not_finite", "0 0 0\nnan 0 0\n"},
    Sample{"bare_beyond_doubles", "0 0 1e999\n"},
    Sample{"bare_too_few", "0 0\n"},
    Sample{"bare_too_many", "0 0 0 0\n"},
    Sample{"bare_words", "zero one two\n"},
    Sample{"comments_only", "# nothing\n"},
};

std::vector<Seed> seeds() {
    std::vector<Seed> seeds{{"nothing", {}}, {"empty_file", {0}}};
    const auto add = [&](const std::string& name, std::uint8_t first, const std::string& text) {
        InputBytes bytes{first};
        const InputBytes rest = as_bytes(text);
        bytes.insert(bytes.end(), rest.begin(), rest.end());
        seeds.push_back({name, bytes});
    };
    for (const auto& [name, text] : samples)
        add(name, 0, text);
    for (const MeshSample& sample : mesh_samples()) {
        const auto* const name = std::ranges::find(names, "points." + sample.format);
        add(sample.name, static_cast<std::uint8_t>(name - names.begin()), sample.bytes);
    }
    const kernel::Triangulation surface = kernel::families::book(3);
    add("without_coordinates", 0, written([&](std::ostream& out) { write_text(out, surface); }));
    add("surface", 5, written([&](std::ostream& out) {
            const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, -0.0, 0.1}};
            geometry::write_text(out, {.table = surface.table(), .points = points});
        }));
    return seeds;
}

}  // namespace

std::string point_file_objection(std::string_view bytes, const std::string& name) {
    const auto read = attempt(
        bytes, [&] { return geometry::read_points(bytes, name); }, whole_file_reasons);
    if (!read.objection.empty() || !read.value) return read.objection;
    if (read.value->empty()) return "files_without_points_are_refused: this one is not";
    if (!std::ranges::all_of(*read.value, [](const Point& p) { return p.allFinite(); })) {
        return "points_are_finite: they are not";
    }
    const std::string lines = as_lines(*read.value);
    return as_lines(geometry::read_points(lines, "points")) == lines
               ? std::string()
               : "points_written_read_the_same: they do not";
}

const Target point_file_target{
    .name = "point_file",
    .description = "a byte for the name, then a file with points: read or refused with the place",
    .layout = {},
    .objection =
        [](Input input) {
            if (input.empty()) return std::string();
            return point_file_objection(as_text(input.subspan(1)),
                                        std::string(names[input.front() % names.size()]));
        },
    .show =
        [](std::ostream& out, Input input) {
            if (input.empty()) return show_bytes(out, input);
            out << names[input.front() % names.size()] << ":\n";
            show_bytes(out, input.subspan(1));
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
