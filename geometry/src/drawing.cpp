#include "hidden_lines.hpp"
#include "painter_order.hpp"
#include "palette.hpp"
#include "projection.hpp"
#include "surface_face.hpp"
#include "svg_text.hpp"
#include <tightflip/geometry/drawing.hpp>
#include <tightflip/geometry/surface_values.hpp>
#include <tightflip/geometry/value_names.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string_view>

#include <Eigen/Geometry>

namespace tightflip::geometry {
namespace {

constexpr int shades = 32;
/// Steps of the colour bar.
constexpr int bar_steps = 21;

void check(const DrawingOptions& options) {
    constexpr int least_size = 100;
    constexpr int largest_size = 10000;
    if (!std::isfinite(options.azimuth)) throw std::invalid_argument("the azimuth is not finite");
    if (!(std::abs(options.elevation) <= 90)) {
        throw std::invalid_argument("the elevation is not in -90 .. 90 degrees");
    }
    if (options.size < least_size || options.size > largest_size) {
        throw std::invalid_argument("the size is not in 100 .. 10000 pixels");
    }
}

/// A part of an edge that is hidden, or not, all along.
struct Run {
    bool is_visible = true;
    std::vector<Point> line;
};

/// A surface as it is seen.
struct Scene {
    SurfaceView surface;
    std::vector<Point> seen;
    SurfaceView projected;
    EdgeLines lines;
    std::vector<Piece> pieces;
    HidingFaces hiding;

    Scene(const SurfaceView& of, const DrawingOptions& options)
        : surface(of),
          seen(project(of.points, options.azimuth, options.elevation)),
          projected{of.table, seen},
          lines(projected),
          pieces(face_pieces(projected, lines)),
          hiding(pieces) {}

    /// An edge cut where it vanishes behind faces and comes out again.
    std::vector<Run> runs(Edge e) {
        const Halfedge h = halfedge_of(e);
        const std::array<Index, 2> own{name_of_face(surface.table, h).id,
                                       name_of_face(surface.table, twin(h)).id};
        std::vector<Run> found;
        std::vector<Point> line;
        lines.trace(e, line);
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Point& a = line[i - 1];
            const Point& b = line[i];
            const auto add = [&](bool is_visible, double begin, double end) {
                if (begin >= end) return;
                if (found.empty() || found.back().is_visible != is_visible) {
                    found.push_back({is_visible, {a + begin * (b - a)}});
                }
                found.back().line.emplace_back(a + end * (b - a));
            };
            double from = 0;
            for (const Interval& part : hiding.visible(a, b, own)) {
                add(false, from, part.begin);
                add(true, part.begin, part.end);
                from = part.end;
            }
            add(false, from, 1);
        }
        return found;
    }

    /// Whether something of a piece that shows the inner side of its face is seen. Asked in a few
    /// points.
    bool shows(const Piece& piece) {
        Point middle = Point::Zero();
        for (const Point& corner : piece.corners)
            middle += corner / static_cast<double>(piece.corners.size());
        if (hiding.is_visible(middle, piece.face)) return true;
        constexpr double outwards = 0.9;
        return std::ranges::any_of(piece.corners, [&](const Point& corner) {
            return hiding.is_visible(middle + outwards * (corner - middle), piece.face);
        });
    }

    /// The pieces to paint, in order.
    std::vector<Piece> paintable() {
        std::vector<Piece> shown;
        std::ranges::copy_if(pieces, std::back_inserter(shown),
                             [&](const Piece& piece) { return piece.is_front || shows(piece); });
        constexpr std::size_t always = 2000;
        return painter_order(std::move(shown), 2 * pieces.size() + always);
    }

    /// The strength of the light on a face, 0 .. 1.
    [[nodiscard]] double light(Index face) const {
        static const Point lamp = Point(-0.45, 0.65, 0.75).normalized();
        const Halfedge h{face};
        const Point& a = projected.origin(h);
        Point normal =
            (projected.target(h) - a).cross(projected.opposite(h) - a).stableNormalized();
        if (normal.z() < 0) normal = -normal;
        return std::max(0.0, normal.dot(lamp));
    }
};

/// Where on the page things are.
class Page {
public:
    Page(const Scene& scene, const DrawingOptions& options)
        : width_(options.size), font_(std::max(9.0, 0.021 * width_)) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Point least = Point::Constant(infinity);
        Point greatest = -least;
        std::vector<Point> line;
        for (Index e = 0; e < scene.projected.edge_count(); ++e) {
            scene.lines.trace(Edge{e}, line);
            for (const Point& point : line) {
                least = least.cwiseMin(point);
                greatest = greatest.cwiseMax(point);
            }
        }
        const double margin = 0.05 * width_;
        const double room = width_ - 2 * margin;
        const Point extent = greatest - least;
        const double larger = std::max(extent.x(), extent.y());
        constexpr double nothing = 1e-9;
        if (larger > nothing) scale_ = room / larger;
        constexpr double flattest = 0.3;
        const double height = std::max(flattest * room, scale_ * extent.y());
        top_ = options.title.empty() ? 0 : 2.2 * font_;
        picture_end_ = top_ + height + 2 * margin;
        middle_ = (least + greatest) / 2;
        centre_y_ = top_ + margin + height / 2;
    }

    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double font() const { return font_; }
    [[nodiscard]] double picture_end() const { return picture_end_; }
    [[nodiscard]] double scale() const { return scale_; }
    [[nodiscard]] double x(const Point& p) const {
        return width_ / 2 + scale_ * (p.x() - middle_.x());
    }
    [[nodiscard]] double y(const Point& p) const {
        return centre_y_ - scale_ * (p.y() - middle_.y());
    }

    /// As the data of a path: "M1 2L3 4 5 6".
    void append_line(std::string& text, const std::vector<Point>& line) const {
        text += 'M';
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (i == 1) text += 'L';
            append_place(text, x(line[i]), y(line[i]));
        }
    }
    [[nodiscard]] double length(const std::vector<Point>& line) const {
        double sum = 0;
        for (std::size_t i = 1; i < line.size(); ++i)
            sum += (line[i] - line[i - 1]).head<2>().norm();
        return scale_ * sum;
    }

private:
    double width_;
    double font_;
    double scale_ = 0;
    double top_ = 0;
    double picture_end_ = 0;
    double centre_y_ = 0;
    Point middle_;
};

/// Writes a drawing into one text.
class Drawing {
public:
    Drawing(const SurfaceView& surface, const DrawingOptions& options)
        : options_(options), scene_(surface, options), page_(scene_, options) {
        if (options.colouring != VertexColouring::none) curvatures_ = vertex_curvatures(surface);
        for (const VertexCurvature& curvature : curvatures_) {
            strongest_ = std::max(strongest_, std::abs(curvature.deficit()));
        }
        for (Index e = 0; e < surface.edge_count(); ++e)
            shapes_.push_back(edge_shape(surface, Edge{e}));
        choose_sizes();
    }

    std::string svg() {
        if (options_.style == DrawingStyle::shaded) faces();
        edges();
        vertices();
        legend();
        std::string head = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
        append_attribute(head, "width", page_.width());
        append_attribute(head, "height", end_);
        head += " viewBox=\"0 0 ";
        append_place(head, page_.width(), end_);
        head += "\">\n";
        if (!options_.title.empty()) {
            head += "<title>" + xml_text(options_.title) + "</title>\n";
        }
        head += styles();
        head += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
        if (!options_.title.empty()) {
            head += "<text class=\"title\"";
            append_attribute(head, "x", page_.width() / 2);
            append_attribute(head, "y", 1.9 * page_.font());
            append_attribute(head, "font-size", 1.25 * page_.font());
            head += " text-anchor=\"middle\">" + xml_text(options_.title) + "</text>\n";
        }
        return head + text_ + "</svg>\n";
    }

private:
    /// Lines and marks by what room there is between vertices.
    void choose_sizes() {
        std::vector<double> lengths;
        std::vector<Point> line;
        for (Index e = 0; e < scene_.projected.edge_count(); ++e) {
            scene_.lines.trace(Edge{e}, line);
            lengths.push_back(page_.length(line));
        }
        const auto middle = std::next(lengths.begin(), std::ssize(lengths) / 2);
        std::ranges::nth_element(lengths, middle);
        const double unit = page_.width() / 640;
        line_width_ = std::clamp(0.035 * *middle, 0.15 * unit, 1.2 * unit);
        mark_size_ = std::clamp(0.11 * *middle, 0.5 * unit, 5.5 * unit);
    }

    [[nodiscard]] std::string styles() const {
        std::string text = "<style>text{font-family:sans-serif;fill:#222}";
        for (const bool is_front : {true, false}) {
            if (is_front ? !shows_outside_ : !shows_inside_) continue;
            for (int shade = 0; shade < shades; ++shade) {
                const std::string colour = palette::hexadecimal(
                    palette::face(is_front, static_cast<double>(shade) / (shades - 1)));
                text += shade_class(".", is_front, shade);
                text += "{fill:";
                text += colour;
                text += ";stroke:";
                text += colour;
                text += '}';
            }
        }
        return text + "</style>\n";
    }
    [[nodiscard]] static std::string shade_class(const std::string& before, bool is_front,
                                                 int shade) {
        return before + (is_front ? "f" : "b") + std::to_string(shade);
    }

    void open_group(std::string_view name) {
        text_ += "<g class=\"";
        text_ += name;
        text_ += '"';
    }
    void attribute(std::string_view name, std::string_view value) {
        text_ += ' ';
        text_ += name;
        text_ += "=\"";
        text_ += value;
        text_ += '"';
    }

    void faces() {
        open_group("faces");
        // Closes the seams that smoothing leaves between neighbours.
        append_attribute(text_, "stroke-width", 0.7);
        text_ += " stroke-linejoin=\"round\">\n";
        const std::vector<Piece> pieces = scene_.paintable();
        for (std::size_t i = 0; i < pieces.size();) {
            const Piece& first = pieces[i];
            const int shade =
                static_cast<int>(std::lround(scene_.light(first.face) * (shades - 1)));
            text_ += shade_class("<path class=\"", first.is_front, shade) + "\" d=\"";
            // Pieces of a face in one path have no seams.
            for (; i < pieces.size() && pieces[i].face == first.face; ++i) {
                page_.append_line(text_, pieces[i].corners);
                text_ += 'z';
            }
            text_ += "\"/>\n";
            (first.is_front ? shows_outside_ : shows_inside_) = true;
        }
        text_ += "</g>\n";
    }

    void edges() {
        std::array<std::string, edge_shape_names.size()> visible;
        std::array<std::string, edge_shape_names.size()> hidden;
        for (Index id = 0; id < scene_.projected.edge_count(); ++id) {
            const auto shape = static_cast<std::size_t>(shapes_[static_cast<std::size_t>(id)]);
            const std::vector<Run> runs = scene_.runs(Edge{id});
            add_path(visible.at(shape), runs, true);
            if (options_.hidden_edges) add_path(hidden.at(shape), runs, false);
        }
        for (std::size_t shape = 0; shape < hidden.size(); ++shape)
            edge_group(shape, hidden.at(shape), true);
        // The usual ones first, so that what is marked lies over them.
        for (const EdgeShape shape : {EdgeShape::flat, EdgeShape::convex, EdgeShape::degenerate,
                                      EdgeShape::concave, EdgeShape::folded}) {
            const auto i = static_cast<std::size_t>(shape);
            edge_group(i, visible.at(i), false);
        }
    }
    /// One path of all visible, or all hidden, parts of an edge that are not too short to see.
    void add_path(std::string& paths, const std::vector<Run>& runs, bool is_visible) const {
        constexpr double shortest = 0.2;
        std::string data;
        for (const Run& run : runs) {
            if (run.is_visible != is_visible || page_.length(run.line) < shortest) continue;
            page_.append_line(data, run.line);
        }
        if (!data.empty()) paths += "<path d=\"" + data + "\"/>\n";
    }
    void edge_group(std::size_t shape, const std::string& paths, bool is_hidden) {
        if (paths.empty()) return;
        open_group((is_hidden ? "hidden " : "edges ") + std::string(edge_shape_names.at(shape)));
        line_look(shape, is_hidden);
        text_ += ">\n" + paths + "</g>\n";
    }
    void line_look(std::size_t shape, bool is_hidden) {
        const palette::EdgeLook& look = palette::edges.at(shape);
        attribute("fill", "none");
        attribute("stroke", look.colour);
        append_attribute(text_, "stroke-width", line_width_ * look.width * (is_hidden ? 0.7 : 1));
        attribute("stroke-linecap", is_hidden ? "butt" : "round");
        attribute("stroke-linejoin", "round");
        if (is_hidden) attribute("opacity", "0.55");
        const double unit = std::max(0.5, line_width_);
        std::string dash;
        if (is_hidden) {
            append_place(dash, 3 * unit, 3 * unit);
        } else if (!look.dash.empty()) {
            append_place(dash, unit, 3 * unit);
        }
        if (!dash.empty()) attribute("stroke-dasharray", dash);
    }

    void vertices() {
        std::array<std::string, vertex_type_names.size()> marks;
        for (std::size_t v = 0; v < curvatures_.size(); ++v) {
            const Point& place = scene_.seen[v];
            if (!scene_.hiding.is_visible(place, -1)) continue;
            add_mark(marks.at(static_cast<std::size_t>(curvatures_[v].type)), curvatures_[v],
                     page_.x(place), page_.y(place));
        }
        for (std::size_t type = 0; type < marks.size(); ++type) {
            if (marks.at(type).empty()) continue;
            open_group("vertices " + std::string(vertex_type_names.at(type)));
            mark_look(static_cast<VertexType>(type));
            text_ += ">\n" + marks.at(type) + "</g>\n";
        }
    }
    [[nodiscard]] bool by_type() const { return options_.colouring == VertexColouring::type; }
    void mark_look(VertexType type) {
        const palette::VertexLook& look = palette::vertices.at(static_cast<std::size_t>(type));
        if (by_type()) attribute("fill", look.fill);
        attribute("stroke", by_type() ? look.outline : "#444");
        append_attribute(text_, "stroke-width", 0.2 * mark_size_);
    }
    void add_mark(std::string& marks, const VertexCurvature& curvature, double x, double y) const {
        if (by_type()) {
            add_mark(marks, palette::vertices.at(static_cast<std::size_t>(curvature.type)), x, y);
            return;
        }
        add_circle(marks, x, y, mark_size_);
        const double value = strongest_ > 0 ? curvature.deficit() / strongest_ : 0;
        marks += " fill=\"" + palette::hexadecimal(palette::diverging(value)) + "\"/>\n";
    }
    void add_mark(std::string& marks, const palette::VertexLook& look, double x, double y) const {
        const double r = look.size * mark_size_;
        const auto polygon = [&](std::initializer_list<std::array<double, 2>> corners) {
            marks += "<path d=\"M";
            for (const auto& [dx, dy] : corners) {
                append_place(marks, x + r * dx, y + r * dy);
                if (dx == corners.begin()->at(0) && dy == corners.begin()->at(1)) marks += 'L';
            }
            marks += "z\"/>\n";
        };
        switch (look.mark) {
            case palette::Mark::circle:
                add_circle(marks, x, y, r);
                marks += "/>\n";
                return;
            case palette::Mark::diamond:
                return polygon({{-1, 0}, {0, -1}, {1, 0}, {0, 1}});
            case palette::Mark::square:
                return polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
        }
    }
    static void add_circle(std::string& marks, double x, double y, double r) {
        marks += "<circle";
        append_attribute(marks, "cx", x);
        append_attribute(marks, "cy", y);
        append_attribute(marks, "r", r);
    }

    // ---- the legend: entries side by side, in as many rows as they need ----

    void legend() {
        line_width_ = 0.1 * page_.font();
        mark_size_ = 0.42 * page_.font();
        row_ = page_.picture_end() + 0.6 * page_.font();
        column_ = page_.font();
        open_group("legend");
        append_attribute(text_, "font-size", page_.font());
        text_ += ">\n";
        if (by_type()) {
            type_entries();
        } else if (!curvatures_.empty()) {
            colour_bar();
        }
        next_row();
        shape_entries();
        if (shows_inside_) inside_entry();
        next_row();
        text_ += "</g>\n";
        end_ = row_ + 0.2 * page_.font();
    }
    void next_row() {
        if (column_ > page_.font()) row_ += 1.7 * page_.font();
        column_ = page_.font();
    }
    /// Makes room for a symbol of some width and a text, and writes the text; says where the
    /// symbol's left end is.
    double entry(double symbol_width, const std::string& words) {
        constexpr double width_of_a_letter = 0.56;
        const double gap = 0.5 * page_.font();
        const double needed = symbol_width + gap +
                              width_of_a_letter * page_.font() * static_cast<double>(words.size());
        if (column_ + needed > page_.width() - page_.font()) next_row();
        const double start = column_;
        text_ += "<text";
        append_attribute(text_, "x", start + symbol_width + gap);
        append_attribute(text_, "y", row_ + 0.36 * page_.font());
        text_ += '>' + words + "</text>\n";
        column_ += needed + 1.2 * page_.font();
        return start;
    }
    void type_entries() {
        std::array<std::size_t, vertex_type_names.size()> count{};
        for (const VertexCurvature& curvature : curvatures_)
            ++count.at(static_cast<std::size_t>(curvature.type));
        for (std::size_t type = 0; type < count.size(); ++type) {
            if (count.at(type) == 0) continue;
            const double x = entry(page_.font(), std::string(vertex_type_names.at(type)) +
                                                     " vertices " + std::to_string(count.at(type)));
            text_ += "<g";
            mark_look(static_cast<VertexType>(type));
            text_ += '>';
            add_mark(text_, palette::vertices.at(type), x + page_.font() / 2, row_);
            text_ += "</g>\n";
        }
    }
    void shape_entries() {
        std::array<std::size_t, edge_shape_names.size()> count{};
        for (const EdgeShape shape : shapes_)
            ++count.at(static_cast<std::size_t>(shape));
        for (std::size_t shape = 0; shape < count.size(); ++shape) {
            if (count.at(shape) == 0) continue;
            const double width = 1.8 * page_.font();
            const double x = entry(width, std::string(edge_shape_names.at(shape)) + " edges " +
                                              std::to_string(count.at(shape)));
            text_ += "<path";
            line_look(shape, false);
            text_ += " d=\"M";
            append_place(text_, x, row_);
            text_ += 'H';
            append_pixels(text_, x + width);
            text_ += "\"/>\n";
        }
    }
    void inside_entry() {
        const double x = entry(page_.font(), "inner side of a face");
        rectangle(x, page_.font(), palette::hexadecimal(palette::face(false, 0.7)));
    }
    void colour_bar() {
        const double width = 12 * page_.font();
        const double x = entry(width, "angle deficit " + three_digits(-strongest_) + " .. " +
                                          three_digits(strongest_) + " rad");
        for (int i = 0; i < bar_steps; ++i) {
            const double value = 2.0 * i / (bar_steps - 1) - 1;
            rectangle(x + width * i / bar_steps, width / bar_steps + 0.3,
                      palette::hexadecimal(palette::diverging(value)));
        }
    }
    void rectangle(double x, double width, const std::string& colour) {
        text_ += "<rect";
        append_attribute(text_, "x", x);
        append_attribute(text_, "y", row_ - 0.4 * page_.font());
        append_attribute(text_, "width", width);
        append_attribute(text_, "height", 0.8 * page_.font());
        attribute("fill", colour);
        text_ += "/>\n";
    }
    static std::string three_digits(double value) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                       std::chars_format::general, 3)
                             .ptr;
        return {digits.data(), end};
    }

    const DrawingOptions& options_;
    Scene scene_;
    Page page_;
    std::vector<VertexCurvature> curvatures_;
    std::vector<EdgeShape> shapes_;
    double strongest_ = 0;
    double line_width_ = 1;
    double mark_size_ = 1;
    bool shows_outside_ = false;
    bool shows_inside_ = false;
    double row_ = 0;     // the middle of the legend's row
    double column_ = 0;  // where its next entry begins
    double end_ = 0;     // the height of the page
    std::string text_;
};

}  // namespace

void write_svg(std::ostream& out, const SurfaceView& surface, const DrawingOptions& options) {
    check(options);
    const std::string text = Drawing(surface, options).svg();
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace tightflip::geometry
