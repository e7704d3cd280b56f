#include "report_page.hpp"

#include "report_page_text.hpp"
#include <tightflip/geometry/edge_shape.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tightflip::tools {
namespace {

using geometry::Edge;
using geometry::EdgeShape;
using geometry::Index;
using geometry::Points;
using geometry::SurfaceView;
using geometry::Triangulation;
using Json = nlohmann::ordered_json;

constexpr unsigned shape_count = 5;
using ShapeCounts = std::array<Index, shape_count>;

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = i; j < i + 3; ++j)
            group = group << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0U);
        for (unsigned digit = 0; digit < 4; ++digit) {
            text += i + digit <= bytes.size() ? digits[group >> (18 - 6 * digit) & 63U] : '=';
        }
    }
    return text;
}

/// Numbers as the typed arrays of a browser have them: little-endian.
class Packed {
public:
    explicit Packed(std::size_t bytes) { bytes_.reserve(bytes); }
    template <std::unsigned_integral T>
    void add(T number) {
        for (std::size_t i = 0; i < sizeof(T); ++i)
            bytes_ += static_cast<char>(number >> (8 * i) & 0xffU);
    }
    void add(Index number) { add(static_cast<std::uint32_t>(number)); }
    void add(float number) { add(std::bit_cast<std::uint32_t>(number)); }
    [[nodiscard]] std::string text() const { return base64(bytes_); }

private:
    std::string bytes_;
};

/// The points in the unit ball, the middle of their box at the origin: as near to what they were as
/// a picture needs, whatever their size.
std::string packed_points(Points points) {
    using geometry::Point;
    double largest = 0;
    for (const Point& p : points)
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    if (largest == 0) largest = 1;
    std::vector<Point> scaled;
    scaled.reserve(points.size());
    for (const Point& p : points)
        scaled.emplace_back(p / largest);
    Point low = Point::Constant(1);
    Point high = Point::Constant(-1);
    for (const Point& p : scaled) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Point middle = (low + high) / 2;
    double radius = 0;
    for (Point& p : scaled) {
        p -= middle;
        radius = std::max(radius, p.norm());
    }
    if (radius == 0) radius = 1;
    Packed packed(12 * points.size());
    for (const Point& p : scaled) {
        for (const double coordinate : p)
            packed.add(static_cast<float>(coordinate / radius));
    }
    return packed.text();
}

std::uint8_t shape_number(const SurfaceView& surface, Edge e) {
    return static_cast<std::uint8_t>(edge_shape(surface, e));
}

/// FNV-1a over the words of the table.
std::string checksum(kernel::HalfedgeTable table) {
    std::uint32_t hash = 2166136261U;
    const auto add = [&](Index word) {
        hash = (hash ^ static_cast<std::uint32_t>(word)) * 16777619U;
    };
    for (const kernel::HalfedgeRecord& record : table) {
        add(record.next.id);
        add(record.origin.id);
    }
    return fmt::format("{:08x}", hash);
}

/// A whole surface: table and shapes.
Json frame_json(const SurfaceView& surface, std::size_t flips) {
    Packed next(4 * surface.table.size());
    Packed origin(4 * surface.table.size());
    Packed shapes(surface.table.size() / 2);
    for (const kernel::HalfedgeRecord& record : surface.table) {
        next.add(record.next.id);
        origin.add(record.origin.id);
    }
    for (Index e = 0; e < surface.edge_count(); ++e)
        shapes.add(shape_number(surface, {e}));
    return {
        {"at", flips}, {"next", next.text()}, {"origin", origin.text()}, {"shapes", shapes.text()}};
}

ShapeCounts count_shapes(const SurfaceView& surface) {
    ShapeCounts counts{};
    for (Index e = 0; e < surface.edge_count(); ++e)
        ++counts.at(shape_number(surface, {e}));
    return counts;
}

/// Flips, and names the halfedges as they were before.
kernel::Quadrilateral flip_or_throw(Triangulation& surface, Edge e) {
    if (const auto verdict = surface.can_flip(e); !verdict) {
        throw std::invalid_argument(
            fmt::format("a report's flip of edge {}: {}", e.id, describe(verdict.refusal())));
    }
    const auto before = kernel::Quadrilateral::around(surface.table(), e);
    surface.flip(e);
    return before;
}

/// The flips, and what each makes of the five edges of its two faces: five digits to the base of
/// five, the first the lowest. page.js names the edges in the same order.
Json steps_json(Triangulation& surface, Points points, std::span<const Edge> flips) {
    Packed edges(4 * flips.size());
    Packed shapes(2 * flips.size());
    for (const Edge e : flips) {
        const kernel::Quadrilateral q = flip_or_throw(surface, e);
        unsigned packed = 0;
        for (const kernel::Halfedge h : {q.t2, q.t1, q.h2, q.h1, q.h})
            packed = packed * shape_count + shape_number({surface.table(), points}, edge_of(h));
        edges.add(e.id);
        shapes.add(static_cast<std::uint16_t>(packed));
    }
    return {{"steps", edges.text()}, {"stepShapes", shapes.text()}};
}

/// Surfaces on the way, start and end among them, at equal numbers of flips.
Json frames_json(Triangulation& surface, Points points, std::span<const Edge> flips,
                 const ReportLimits& limits) {
    const std::size_t affordable = limits.halfedges / surface.table().size();
    const std::size_t stretches =
        std::max<std::size_t>(std::min(affordable, limits.surfaces), 2) - 1;
    Json frames = Json::array();
    std::size_t done = 0;
    for (std::size_t i = 0; i <= stretches; ++i) {
        const std::size_t until =
            flips.size() / stretches * i + flips.size() % stretches * i / stretches;
        for (; done < until; ++done)
            flip_or_throw(surface, flips[done]);
        frames.push_back(frame_json({surface.table(), points}, done));
    }
    return frames;
}

/// Both ends, and of each of equal stretches between the least and the greatest value.
Json series_json(const ReportSeries& series, std::size_t most) {
    Json flips = Json::array();
    Json values = Json::array();
    const auto add = [&](std::size_t i) {
        flips.push_back(series.flips[i]);
        values.push_back(series.values[i]);  // null where not finite, which the page leaves out
    };
    const std::size_t count = std::min(series.flips.size(), series.values.size());
    const std::size_t stretches = count <= most ? count : std::max<std::size_t>(most / 2, 1);
    for (std::size_t i = 0; i < stretches; ++i) {
        const std::size_t begin = count * i / stretches;
        const std::size_t end = count * (i + 1) / stretches;
        const auto value = [&](std::size_t j) { return series.values[j]; };
        std::size_t least = begin;
        std::size_t greatest = begin;
        for (std::size_t j = begin; j < end; ++j) {
            if (value(j) < value(least)) least = j;
            if (value(j) > value(greatest)) greatest = j;
        }
        if (i == 0 && std::min(least, greatest) != 0) add(0);
        add(std::min(least, greatest));
        if (least != greatest) add(std::max(least, greatest));
        if (i + 1 == stretches && std::max(least, greatest) + 1 != end) add(end - 1);
    }
    return {{"name", series.name}, {"flips", std::move(flips)}, {"values", std::move(values)}};
}

Json report_json(const OptimisationReport& report, const ReportLimits& limits) {
    const Points points = report.before.points();
    Triangulation surface = report.before.triangulation();
    Json json{{"vertices", surface.vertex_count()},
              {"edges", surface.edge_count()},
              {"faces", surface.face_count()},
              {"genus", surface.genus()},
              {"flips", report.flips.size()},
              {"facts", report.facts},
              {"series", Json::array()},
              {"frames", Json::array()}};
    for (const ReportSeries& series : report.series)
        json["series"].push_back(series_json(series, limits.series_points));
    json["shapesBefore"] = count_shapes(report.before.view());
    if (surface.vertex_count() > limits.vertices) {
        for (const Edge e : report.flips)
            flip_or_throw(surface, e);
    } else {
        json["points"] = packed_points(points);
        if (report.flips.size() > limits.flips) {
            json["frames"] = frames_json(surface, points, report.flips, limits);
        } else {
            json["frames"].push_back(frame_json(report.before.view(), 0));
            json.update(steps_json(surface, points, report.flips));
        }
    }
    json["shapesAfter"] = count_shapes({surface.table(), points});
    json["checksum"] = checksum(surface.table());
    return json;
}

/// JSON that nothing in it can end the element it stands in: "<" comes in strings only.
std::string json_for_html(const Json& json) {
    std::string text;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

std::string html_escaped(std::string_view words) {
    std::string text;
    for (const char c : words) {
        switch (c) {
            case '<':
                text += "&lt;";
                break;
            case '>':
                text += "&gt;";
                break;
            case '&':
                text += "&amp;";
                break;
            default:
                text += c;
        }
    }
    return text;
}

/// Writes the page with its places filled in: each is named once in braces or more often.
void write_page(std::ostream& out, std::string_view page, const std::string& title,
                const std::string& data) {
    const std::array<std::pair<std::string_view, std::string_view>, 2> places{
        {{"{{title}}", title}, {"{{data}}", data}}};
    while (!page.empty()) {
        std::size_t begin = page.size();
        std::pair<std::string_view, std::string_view> found;
        for (const auto& place : places) {
            if (const std::size_t at = page.find(place.first); at < begin) {
                begin = at;
                found = place;
            }
        }
        out << page.substr(0, begin) << found.second;
        page.remove_prefix(begin + found.first.size());
    }
}

}  // namespace

bool can_write_report() noexcept {
    return !report_page_text().empty();
}

void write_report(const std::filesystem::path& directory, const OptimisationReport& report,
                  const ReportLimits& limits) {
    const std::filesystem::path path = directory / "index.html";
    if (!can_write_report())
        throw kernel::FileError(path.string(), std::string(how_to_get_reports));
    const std::string title = html_escaped(report.title);
    const std::string data = json_for_html(report_json(report, limits));
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) {
        throw kernel::FileError(directory.string(), "cannot be created: " + error.message());
    }
    kernel::write_file(
        path, [&](std::ostream& out) { write_page(out, report_page_text(), title, data); });
}

}  // namespace tightflip::tools
