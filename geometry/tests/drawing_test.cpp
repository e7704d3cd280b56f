#include "shapes.hpp"
#include "svg_reading.hpp"
#include <tightflip/geometry/curvature.hpp>
#include <tightflip/geometry/drawing.hpp>
#include <tightflip/geometry/value_names.hpp>

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

std::string svg(const Surface& surface, const DrawingOptions& options = {}) {
    std::ostringstream out;
    write_svg(out, surface.view(), options);
    return out.str();
}

/// A drawing taken apart.
struct Picture {
    std::vector<SvgElement> elements;

    explicit Picture(const std::string& text) : elements(SvgReader(text).read()) {}
    explicit Picture(const Surface& surface, const DrawingOptions& options = {})
        : Picture(svg(surface, options)) {}

    [[nodiscard]] std::vector<SvgElement> in(const std::string& group) const {
        std::vector<SvgElement> found;
        std::ranges::copy_if(elements, std::back_inserter(found), [&](const SvgElement& element) {
            return element.group == group && element.name != "g";
        });
        return found;
    }
    [[nodiscard]] std::size_t count(const std::string& group) const { return in(group).size(); }
    [[nodiscard]] bool has_text(const std::string& words) const {
        return std::ranges::any_of(elements, [&](const SvgElement& element) {
            return element.name == "text" && element.text == words;
        });
    }
};

/// Where one looks from.
Point direction_of(const DrawingOptions& options) {
    constexpr double degree = std::numbers::pi / 180;
    const double a = options.azimuth * degree;
    const double e = options.elevation * degree;
    return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

bool is_towards(const SurfaceView& view, Halfedge h, const Point& viewer) {
    const Point& a = view.origin(h);
    return (view.target(h) - a).cross(view.opposite(h) - a).dot(viewer) > 0;
}

constexpr std::array<std::array<double, 2>, 4> views{{{30, 20}, {-75, 60}, {201, -33}, {5, 88}}};

TEST(Drawing, OfConvexSolidsShowsWhatFacesTheViewer) {
    for (const Surface& surface : {cube(), octahedron(), icosahedron(), regular_tetrahedron()}) {
        for (const auto& [azimuth, elevation] : views) {
            const DrawingOptions options{.azimuth = azimuth, .elevation = elevation};
            const SurfaceView view = surface.view();
            const Point viewer = direction_of(options);
            const Triangulation& t = surface.triangulation();
            std::size_t faces = 0;
            for (const Halfedge h : t.faces())
                faces += is_towards(view, h, viewer) ? 1U : 0U;
            std::array<std::size_t, 5> edges{};
            std::set<Vertex> vertices;
            for (Index e = 0; e < t.edge_count(); ++e) {
                const Halfedge h = halfedge_of(Edge{e});
                if (!is_towards(view, h, viewer) && !is_towards(view, twin(h), viewer)) continue;
                ++edges.at(static_cast<std::size_t>(edge_shape(view, Edge{e})));
                vertices.insert({t.origin(h), t.target(h)});
            }
            const Picture picture(surface, options);
            EXPECT_EQ(picture.count("faces"), faces);
            EXPECT_EQ(picture.count("vertices convex"), vertices.size());
            for (std::size_t shape = 0; shape < edges.size(); ++shape) {
                EXPECT_EQ(picture.count("edges " + std::string(edge_shape_names.at(shape))),
                          edges.at(shape));
            }
        }
    }
}

TEST(Drawing, TheHiddenEdgesAreTheOthers) {
    for (const Surface& surface : {cube(), octahedron(), icosahedron()}) {
        for (const DrawingStyle style : {DrawingStyle::shaded, DrawingStyle::wireframe}) {
            const Picture picture(surface, {.style = style, .hidden_edges = true});
            const std::size_t all = picture.count("edges convex") + picture.count("edges flat") +
                                    picture.count("hidden convex") + picture.count("hidden flat");
            EXPECT_EQ(all, static_cast<std::size_t>(surface.triangulation().edge_count()));
            EXPECT_EQ(picture.count("faces") == 0, style == DrawingStyle::wireframe);
            EXPECT_GT(picture.count("hidden convex"), 0U);
            EXPECT_EQ(Picture(surface, {.style = style}).count("hidden convex"), 0U);
        }
    }
}

/// A sphere with dents, embedded.
Surface dented_sphere(int level, double depth) {
    const Triangulation triangulation = kernel::families::octasphere(level);
    const std::vector<Halfedge> outgoing = triangulation.outgoing();
    std::vector<Point> points(outgoing.size(), Point::Zero());
    for (std::size_t v = 0; v < 6; ++v) {
        points[v][static_cast<Eigen::Index>(v / 2)] = v % 2 == 0 ? 1 : -1;
    }
    // Averaged until each lies among its neighbours, the six of the octahedron held fast.
    for (int round = 0; round < 400; ++round) {
        for (std::size_t v = 6; v < points.size(); ++v) {
            Point sum = Point::Zero();
            for (const Vertex w : triangulation.neighbours(outgoing[v]))
                sum += points[static_cast<std::size_t>(w.id)];
            points[v] = sum.normalized();
        }
    }
    for (Point& p : points)
        p *= 1 + depth * std::sin(4 * p.x()) * std::sin(4 * p.y() + 1) * std::cos(3 * p.z());
    return {triangulation, points};
}

double length_of(const std::vector<SvgElement>& paths) {
    double sum = 0;
    for (const SvgElement& path : paths) {
        for (const auto& stroke : strokes_of(path.attribute("d"))) {
            for (std::size_t i = 3; i < stroke.size(); i += 2)
                sum += std::hypot(stroke[i - 1] - stroke[i - 3], stroke[i] - stroke[i - 2]);
        }
    }
    return sum;
}

bool is_hidden(const Surface& surface, const Point& place, const Point& viewer,
               const std::array<Halfedge, 2>& but) {
    const SurfaceView view = surface.view();
    const Triangulation& t = surface.triangulation();
    for (const Halfedge h : t.faces()) {
        bool is_own = false;
        for (const Halfedge side : t.face_sides(h))
            is_own |= side == but[0] || side == but[1];
        if (is_own) continue;
        Eigen::Matrix3d sides;
        sides << view.target(h) - view.origin(h), view.opposite(h) - view.origin(h), -viewer;
        const Point solution = sides.inverse() * (place - view.origin(h));
        if (solution[0] > 0 && solution[1] > 0 && solution[0] + solution[1] < 1 &&
            solution[2] > 1e-5) {
            return true;
        }
    }
    return false;
}

/// The parts of edges that are drawn as visible, against rays from points of the edges; concave
/// edges, which are the marked ones, by themselves.
TEST(Drawing, ShowsOfEachEdgeWhatNoFaceHides) {
    const Surface surface = dented_sphere(2, 0.35);
    const Triangulation& t = surface.triangulation();
    for (const auto& [azimuth, elevation] : views) {
        const DrawingOptions options{
            .azimuth = azimuth, .elevation = elevation, .hidden_edges = true, .size = 2000};
        const Point viewer = direction_of(options);
        const Picture picture(surface, options);
        for (const EdgeShape shape : {EdgeShape::convex, EdgeShape::concave}) {
            constexpr int samples = 40;
            double all = 0;
            double seen = 0;
            std::size_t certainly = 0;
            std::size_t possibly = 0;
            for (Index id = 0; id < t.edge_count(); ++id) {
                if (edge_shape(surface.view(), Edge{id}) != shape) continue;
                const Halfedge h = halfedge_of(Edge{id});
                const Point a = surface.view().origin(h);
                const Point way = surface.view().target(h) - a;
                int visible = 0;
                for (int k = 0; k < samples; ++k) {
                    const Point place = a + (k + 0.5) / samples * way;
                    visible += is_hidden(surface, place, viewer, {h, twin(h)}) ? 0 : 1;
                }
                const double length = (way - way.dot(viewer) * viewer).norm();
                all += length;
                seen += length * visible / samples;
                certainly += visible > 2 ? 1U : 0U;
                possibly += visible > 0 || length < 0.01 ? 1U : 0U;
            }
            const std::string name(geometry::name(shape));
            const double drawn = length_of(picture.in("edges " + name));
            const double hidden = length_of(picture.in("hidden " + name));
            EXPECT_NEAR(drawn / (drawn + hidden), seen / all, 0.01) << name;
            EXPECT_GT(seen / all, 0.2);
            EXPECT_LT(seen / all, 0.8);
            EXPECT_GE(picture.count("edges " + name), certainly);
            // Some show less than there is between two samples.
            EXPECT_LE(picture.count("edges " + name), possibly + possibly / 10);
        }
    }
}

TEST(Drawing, ParallelEdgesHaveDifferentPaths) {
    for (const Index vertices : {4, 7, 12}) {
        const Surface surface = with_random_points(kernel::families::book(vertices), 3);
        const Picture picture(surface, {.style = DrawingStyle::wireframe, .hidden_edges = true});
        std::set<std::string> paths;
        std::size_t count = 0;
        for (const SvgElement& element : picture.elements) {
            if (!element.group.starts_with("edges") && !element.group.starts_with("hidden"))
                continue;
            if (element.name != "path") continue;
            paths.insert(element.attribute("d"));
            ++count;
        }
        EXPECT_EQ(paths.size(), count);
        EXPECT_GE(count, static_cast<std::size_t>(surface.triangulation().edge_count()));
    }
}

TEST(Drawing, InnerSidesAreShownWhereTheyAreSeen) {
    const auto faces_of = [](const Picture& picture, char kind) {
        return std::ranges::count_if(picture.in("faces"), [&](const SvgElement& face) {
            return face.attribute("class").front() == kind;
        });
    };
    const Picture outside(cube());
    EXPECT_EQ(faces_of(outside, 'f'), 6);
    EXPECT_EQ(faces_of(outside, 'b'), 0);
    EXPECT_FALSE(outside.has_text("inner side of a face"));
    // Turned inside out, the far sides are the outer ones, and painted below.
    const Picture inside(moved(cube(), Eigen::Affine3d(Eigen::Scaling(-1.0))));
    EXPECT_EQ(faces_of(inside, 'b'), 6);
    const std::vector<SvgElement> order = inside.in("faces");
    EXPECT_EQ(order.back().attribute("class").front(), 'b');
    EXPECT_TRUE(inside.has_text("inner side of a face"));
}

TEST(Drawing, TheLegendCountsAllKinds) {
    const Picture of_cube(cube(), {.title = "A cube"});
    for (const char* words : {"A cube", "convex vertices 8", "convex edges 12", "flat edges 6"})
        EXPECT_TRUE(of_cube.has_text(words)) << words;
    EXPECT_FALSE(of_cube.has_text("concave edges 0"));
    const Picture of_sphere(
        make_surface({{0, 1, 2}, {0, 2, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_TRUE(of_sphere.has_text("folded edges 3"));
    EXPECT_EQ(Picture(cube()).count("legend"), 6U);  // three entries of a text and a mark each
}

TEST(Drawing, CurvatureIsBlueWhereNegative) {
    const Surface surface = dented_sphere(2, 0.35);
    const Picture picture(surface, {.colouring = VertexColouring::curvature});
    std::size_t marks = 0;
    for (const std::string_view type : vertex_type_names) {
        for (const SvgElement& mark : picture.in("vertices " + std::string(type))) {
            ++marks;
            const std::string fill = mark.attribute("fill");
            ASSERT_EQ(fill.size(), 7U);
            const int red = std::stoi(fill.substr(1, 2), nullptr, 16);
            const int blue = std::stoi(fill.substr(5, 2), nullptr, 16);
            if (type == "convex") {
                EXPECT_GT(red, blue);
            }
            if (type == "saddle") {
                EXPECT_LT(red, blue);
            }
        }
    }
    EXPECT_GT(marks, 8U);
    EXPECT_GT(picture.count("vertices saddle"), 0U);
    const Picture none(surface, {.colouring = VertexColouring::none});
    for (const SvgElement& element : none.elements)
        EXPECT_FALSE(element.group.starts_with("vertices"));
}

/// Well-formed, and nothing but numbers of pixels within the page.
void expect_sound(const Surface& surface, const DrawingOptions& options) {
    const Picture picture(surface, options);
    ASSERT_EQ(picture.elements.front().name, "svg");
    const double width = numbers_in(picture.elements.front().attribute("width")).at(0);
    const double height = numbers_in(picture.elements.front().attribute("height")).at(0);
    EXPECT_EQ(width, options.size);
    EXPECT_LT(height, 3 * width);
    for (const SvgElement& element : picture.elements) {
        if (element.name == "path") {
            const std::vector<double> numbers = numbers_in(element.attribute("d"));
            ASSERT_GE(numbers.size(), 2U);
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                EXPECT_GE(numbers[i], 0);
                EXPECT_LE(numbers[i], i % 2 == 0 ? width : height);
            }
        }
        for (const char* key : {"cx", "cy", "r", "x", "y", "stroke-width", "font-size"}) {
            if (element.attributes.contains(key)) numbers_in(element.attribute(key));
        }
    }
}

TEST(Drawing, IsSoundForSurfacesOfAllKinds) {
    for (const Triangulation& triangulation : all_families()) {
        for (const Surface& surface :
             {with_random_points(triangulation, 2), with_grid_points(triangulation, 2, 2),
              with_grid_points(triangulation, 2, 1), with_grid_points(triangulation, 2, 0)}) {
            for (const DrawingStyle style : {DrawingStyle::shaded, DrawingStyle::wireframe}) {
                expect_sound(surface, {.style = style,
                                       .colouring = VertexColouring::type,
                                       .hidden_edges = true,
                                       .title = "<&>"});
                expect_sound(surface, {.azimuth = 0,
                                       .elevation = 90,
                                       .style = style,
                                       .colouring = VertexColouring::curvature,
                                       .size = 100});
            }
        }
    }
}

TEST(Drawing, IsSoundForCoordinatesOfAnySize) {
    constexpr double largest = std::numeric_limits<double>::max();
    for (const double factor : {1e-320, 1e-300, 1e300, largest}) {
        for (const Triangulation& triangulation : all_families()) {
            const Surface surface = with_random_points(triangulation, 2);
            expect_sound(moved(surface, Eigen::Affine3d(Eigen::Scaling(factor))),
                         {.colouring = VertexColouring::curvature, .hidden_edges = true});
        }
    }
    // One far point beside many near ones, and points on a line.
    Surface surface = with_random_points(kernel::families::stacked(30, 1), 2);
    std::vector<Point> points(surface.points().begin(), surface.points().end());
    points[3] = {1e300, -1e300, 1e-300};
    expect_sound({surface.triangulation(), points}, {});
    for (Point& point : points)
        point = Point(point.x(), 0, 0);
    expect_sound({surface.triangulation(), points}, {.azimuth = 0, .elevation = 0});
}

TEST(Drawing, IsTheSameForTheSameSurfaceInOtherUnits) {
    const Surface surface = with_random_points(kernel::families::random(15, 0, 2), 2);
    const std::string plain = svg(surface);
    EXPECT_EQ(svg(surface), plain);
    for (const double factor : {0x1p-900, 0x1p-1, 0x1p900}) {
        EXPECT_EQ(svg(moved(surface, Eigen::Affine3d(Eigen::Scaling(factor)))), plain) << factor;
    }
}

TEST(Drawing, OptionsOutOfTheirRangeAreRefused) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const DrawingOptions& options :
         {DrawingOptions{.azimuth = nan}, DrawingOptions{.azimuth = infinity},
          DrawingOptions{.elevation = 90.5}, DrawingOptions{.elevation = nan},
          DrawingOptions{.size = 99}, DrawingOptions{.size = 10001}}) {
        EXPECT_THROW(svg(cube(), options), std::invalid_argument);
    }
    EXPECT_NO_THROW(svg(cube(), {.azimuth = 1e18, .elevation = -90, .size = 100}));
}

}  // namespace
}  // namespace tightflip::geometry
