#include "mesh_file.hpp"

#include "mesh_samples.hpp"
#include "reading.hpp"
#include "targets.hpp"
#include <tightflip/geometry/file_place.hpp>
#include <tightflip/geometry/mesh_writer.hpp>
#include <tightflip/geometry/repair.hpp>
#include <tightflip/geometry/soup_gluing.hpp>
#include <tightflip/kernel/canonical.hpp>

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>

namespace tightflip::fuzz {
namespace {

using geometry::MeshEncoding;
using geometry::MeshFileOptions;
using geometry::MeshFormat;
using geometry::Surface;
using geometry::TriangleSoup;
using kernel::FileError;
using kernel::Index;

const std::string source = "the mesh";

constexpr std::array<std::string_view, 3> whole_file_reasons{
    "the file is empty", "the file has no faces", "neither the content nor the name's extension"};

constexpr std::array formats{MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::stl};

std::string objection_to_soup(const TriangleSoup& soup, std::string_view bytes) {
    const auto stand_in_file = [&](const std::vector<std::uint64_t>& positions) {
        return std::ranges::all_of(positions, [&](std::uint64_t at) { return at <= bytes.size(); });
    };
    if (soup.point_positions.size() != soup.points.size() ||
        soup.triangle_positions.size() != soup.triangles.size() ||
        !stand_in_file(soup.point_positions) || !stand_in_file(soup.triangle_positions)) {
        return "everything_has_its_place: it has not";
    }
    if (!std::ranges::all_of(soup.points, [](const auto& p) { return p.allFinite(); })) {
        return "points_are_finite: they are not";
    }
    const auto all_within = [](const auto& rows, Index low, Index end) {
        return std::ranges::all_of(rows, [&](const std::array<Index, 3>& row) {
            return std::ranges::all_of(row, [&](Index x) { return x >= low && x < end; });
        });
    };
    if (!all_within(soup.triangles, 0, soup.vertex_count())) return "corners_exist: one does not";
    const auto sides = static_cast<Index>(3 * soup.triangles.size());
    if (!soup.glued_sides.empty() && (soup.glued_sides.size() != soup.triangles.size() ||
                                      !all_within(soup.glued_sides, -1, sides))) {
        return "glued_sides_exist: one does not";
    }
    return {};
}

/// The surface that the soup is, or nothing.
std::optional<Surface> surface_of(const TriangleSoup& soup) {
    const kernel::FaceListReading reading = glue(soup);
    const kernel::AuditReport report = geometry::audit(reading);
    for (const kernel::Violation& violation : report.violations)
        static_cast<void>(where(soup, violation));
    if (!report.is_valid()) return std::nullopt;
    return Surface(build(reading.gluing).value(), soup.points);
}

bool are_same_numbers(const geometry::Point& a, const geometry::Point& b) {
    return a == b;
}

/// Written and read again: the same labelled surface and points; from STL, which has no labels, one
/// that is isomorphic.
std::string writing_keeps(const Surface& surface, MeshFormat format, MeshEncoding encoding) {
    const std::string way =
        std::string(name(format)) + (encoding == MeshEncoding::binary ? ", binary" : ", text");
    const auto obstacle = obstacle_to_writing(surface.view(), format, encoding);
    std::string bytes;
    try {
        bytes = written([&](std::ostream& out) {
            write_mesh(out, surface.view(), format, {.encoding = encoding});
        });
    } catch (const std::invalid_argument&) {
        return obstacle ? std::string() : "surfaces_without_obstacle_are_written: " + way;
    }
    if (obstacle) return "obstacles_are_refused: " + way + ": " + *obstacle;
    const TriangleSoup soup = geometry::read_mesh(bytes, source, {.format = format});
    const auto again = surface_of(soup);
    if (!again) return "surfaces_written_are_read: " + way;
    const kernel::Equality equality{
        format == MeshFormat::stl ? kernel::Labels::ignored : kernel::Labels::kept,
        kernel::Mirror::distinct};
    if (canonical_code(again->triangulation(), equality) !=
        canonical_code(surface.triangulation(), equality)) {
        return "surfaces_written_read_the_same: " + way;
    }
    if (format != MeshFormat::stl &&
        !std::ranges::equal(again->points(), surface.points(), are_same_numbers)) {
        return "points_written_read_the_same: " + way;
    }
    return {};
}

std::string repairing_keeps_soups_sound(TriangleSoup soup) {
    try {
        const geometry::RepairReport report = repair(soup, geometry::all_repairs);
        if (in_words(report).empty()) return "repairs_are_put_in_words: they are not";
    } catch (const FileError&) {
        return {};  // no face is left
    }
    const auto corners = 3 * soup.triangles.size();
    const bool is_sound =
        soup.points.size() == soup.point_positions.size() &&
        soup.triangles.size() == soup.triangle_positions.size() && soup.points.size() <= corners &&
        std::ranges::all_of(soup.triangles, [&](const std::array<Index, 3>& t) {
            return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] &&
                   std::ranges::all_of(t,
                                       [&](Index x) { return x >= 0 && x < soup.vertex_count(); });
        });
    static_cast<void>(geometry::audit(glue(soup)));
    return is_sound ? std::string() : "repaired_soups_are_sound: this one is not";
}

std::string objection_to(const TriangleSoup& soup, std::string_view bytes) {
    if (auto wrong = objection_to_soup(soup, bytes); !wrong.empty()) return wrong;
    if (auto wrong = repairing_keeps_soups_sound(soup); !wrong.empty()) return wrong;
    const auto surface = surface_of(soup);
    if (!surface) return {};
    for (const MeshFormat format : formats) {
        for (const MeshEncoding encoding : {MeshEncoding::text, MeshEncoding::binary}) {
            if (auto wrong = writing_keeps(*surface, format, encoding); !wrong.empty()) {
                return wrong;
            }
        }
    }
    return {};
}

std::vector<Seed> seeds() {
    std::vector<Seed> seeds{{"nothing", {}}, {"empty_file", {0}}};
    for (const MeshSample& sample : mesh_samples()) {
        const auto add = [&](const std::string& name, std::uint8_t first) {
            InputBytes bytes{first};
            const InputBytes rest = as_bytes(sample.bytes);
            bytes.insert(bytes.end(), rest.begin(), rest.end());
            seeds.push_back({name, bytes});
        };
        const auto* const format =
            std::ranges::find(formats, sample.format, [](MeshFormat f) { return name(f); });
        add(sample.name, encode_mesh_options({.format = *format}));
        add(sample.name + "_by_content", encode_mesh_options({.triangulate_polygons = true}));
        if (sample.name == "obj_curve" || sample.name == "ply_extra_elements") {
            add(sample.name + "_points_only", encode_mesh_options({.faces_required = false}));
        }
    }
    return seeds;
}

}  // namespace

MeshFileOptions decode_mesh_options(std::uint8_t byte) {
    MeshFileOptions options;
    const std::size_t which = byte % (formats.size() + 1);
    if (which > 0) options.format = formats.at(which - 1);
    const unsigned rest = byte / (formats.size() + 1);
    options.triangulate_polygons = rest % 2 == 1;
    options.faces_required = rest / 2 % 2 == 0;
    return options;
}

std::uint8_t encode_mesh_options(const MeshFileOptions& options) {
    std::size_t which = 0;
    if (options.format) {
        which = static_cast<std::size_t>(std::ranges::find(formats, *options.format) -
                                         formats.begin()) +
                1;
    }
    const std::size_t rest =
        (options.triangulate_polygons ? 1U : 0U) + (options.faces_required ? 0U : 2U);
    return static_cast<std::uint8_t>(which + (formats.size() + 1) * rest);
}

std::string mesh_objection(std::string_view bytes, const MeshFileOptions& options) {
    const auto read = attempt(
        bytes, [&] { return geometry::read_mesh(bytes, source, options); }, whole_file_reasons);
    if (!read.objection.empty() || !read.value) return read.objection;
    return objection_to(*read.value, bytes);
}

const Target mesh_file_target{
    .name = "mesh_file",
    .description =
        "a byte for the format, then a mesh file: read or refused with the place; "
        "surfaces among them written in all formats and read again the same",
    .layout = {},
    .objection =
        [](Input input) {
            if (input.empty()) return std::string();
            return mesh_objection(as_text(input.subspan(1)), decode_mesh_options(input.front()));
        },
    .show =
        [](std::ostream& out, Input input) {
            if (input.empty()) return show_bytes(out, input);
            const MeshFileOptions options = decode_mesh_options(input.front());
            out << (options.format ? "as " + std::string(name(*options.format)) : "by content")
                << (options.triangulate_polygons ? ", polygons cut" : "")
                << (options.faces_required ? "" : ", faces or none") << ":\n";
            show_bytes(out, input.subspan(1));
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
