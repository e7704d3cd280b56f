#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/plain_writer.hpp>

#include <array>

namespace tightflip::geometry {
namespace {

constexpr std::string_view name = "tightflip-surface";
constexpr int version = 1;

Point parse_point(kernel::TextCursor& cursor, Index vertex) {
    cursor.require_line("the point of vertex " + std::to_string(vertex));
    const double x = cursor.number("the x coordinate");
    const double y = cursor.number("the y coordinate");
    const double z = cursor.number("the z coordinate");
    cursor.require_end_of_line("a point's three coordinates");
    Point point(x, y, z);
    if (!point.allFinite()) {
        cursor.fail("a coordinate of vertex " + std::to_string(vertex) +
                    " is not finite; repair the program or the data that it came from");
    }
    return point;
}

std::vector<Point> parse_points(kernel::TextCursor& cursor, Index vertices) {
    const Index count = cursor.announced_lines("points", 6);
    if (count != vertices) {
        cursor.fail(std::to_string(count) + " points are announced for " +
                    std::to_string(vertices) + " vertices; there is one for each");
    }
    std::vector<Point> points;
    points.reserve(static_cast<std::size_t>(count));
    for (Index v = 0; v < count; ++v)
        points.push_back(parse_point(cursor, v));
    return points;
}

}  // namespace

bool is_surface_text(std::string_view text) noexcept {
    return text.starts_with(name);
}

RawSurface parse_surface(std::string_view text, const std::string& source) {
    kernel::TextCursor cursor(text, source);
    cursor.require_line("the format's name and version");
    cursor.require_word(name);
    cursor.integer("the format's version, which must be one this program knows,", version, version);
    cursor.require_end_of_line("the format's version");
    RawSurface surface{.table = kernel::parse_table(cursor), .points = {}};
    surface.points = parse_points(cursor, surface.table.vertex_count);
    cursor.require_line("'end'");
    cursor.require_word("end");
    cursor.require_end_of_line("'end'");
    if (cursor.next_line()) cursor.fail("nothing should follow 'end'");
    return surface;
}

void write_text(std::ostream& out, const SurfaceView& surface) {
    kernel::PlainWriter text(out);
    text << name << ' ' << version << '\n';
    kernel::write_table(out, surface.table, static_cast<Index>(surface.points.size()));
    text << "points " << surface.points.size() << "\n# x y z of vertex 0, 1, 2, ...\n";
    for (const Point& p : surface.points)
        text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    text << "end\n";
}

}  // namespace tightflip::geometry
