#include "shapes.hpp"
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/geometry/surface_values.hpp>
#include <tightflip/geometry/value_names.hpp>

#include <charconv>
#include <numbers>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

using Row = std::vector<std::string>;

std::vector<Row> rows_of(const std::string& text, char separator) {
    std::vector<Row> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        Row row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, separator);)
            row.push_back(cell);
        rows.push_back(row);
    }
    EXPECT_TRUE(text.ends_with('\n'));
    return rows;
}

double number(const std::string& text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    EXPECT_TRUE(error == std::errc{} && stopped == end) << text;
    return value;
}

template <class Write>
std::string written(const Write& write, const Surface& surface) {
    std::ostringstream out;
    out.imbue(std::locale(std::locale::classic(), new std::numpunct<char>));
    write(out, surface.view());
    return out.str();
}

std::vector<Surface> samples() {
    std::vector<Surface> surfaces{cube(), octahedron(), icosahedron(), regular_tetrahedron()};
    for (const Triangulation& triangulation : all_families()) {
        surfaces.push_back(with_random_points(triangulation, 4));
        surfaces.push_back(with_grid_points(triangulation, 4, 1));
    }
    return surfaces;
}

TEST(SurfaceValues, TheTableOfVerticesIsWhatTheMeterMeasures) {
    for (const Surface& surface : samples()) {
        const Triangulation& t = surface.triangulation();
        const std::vector<Row> rows = rows_of(written(write_vertices_csv, surface), ',');
        ASSERT_EQ(rows.size(), surface.points().size() + 1);
        EXPECT_EQ(rows[0], (Row{"vertex", "degree", "x", "y", "z", "theta", "omega",
                                "omega_positive", "omega_negative", "omega_absolute", "type"}));
        const std::vector<Halfedge> outgoing = t.outgoing();
        double total = 0;
        StarMeter meter;
        for (std::size_t v = 0; v < outgoing.size(); ++v) {
            const Row& row = rows[v + 1];
            ASSERT_EQ(row.size(), 11U);
            EXPECT_EQ(row[0], std::to_string(v));
            EXPECT_EQ(row[1], std::to_string(t.degree(outgoing[v])));
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_EQ(number(row[2 + i]), surface.points()[v][static_cast<Eigen::Index>(i)]);
            }
            const VertexCurvature measured = meter.measure(surface.view(), outgoing[v]);
            // The meter may start at another halfedge of the star, and add in another order.
            EXPECT_NEAR(number(row[5]), measured.total_angle, 1e-12);
            EXPECT_NEAR(number(row[6]), 2 * std::numbers::pi - measured.total_angle, 1e-12);
            EXPECT_NEAR(number(row[7]), measured.positive, 1e-12);
            EXPECT_NEAR(number(row[8]), measured.negative, 1e-12);
            EXPECT_NEAR(number(row[9]), measured.positive + measured.negative, 1e-12);
            EXPECT_EQ(row[10], vertex_type_names.at(static_cast<std::size_t>(measured.type)));
            total += number(row[6]);
        }
        EXPECT_NEAR(total, 2 * std::numbers::pi * t.euler_characteristic(), 1e-9);
    }
}

TEST(SurfaceValues, TheTableOfEdgesIsWhatTheirMeasuresSay) {
    for (const Surface& surface : samples()) {
        const Triangulation& t = surface.triangulation();
        const std::vector<Row> rows = rows_of(written(write_edges_csv, surface), ',');
        ASSERT_EQ(rows.size(), static_cast<std::size_t>(t.edge_count()) + 1);
        EXPECT_EQ(rows[0], (Row{"edge", "origin", "target", "length", "exterior_angle",
                                "mean_curvature", "shape", "quadrilateral"}));
        for (Index id = 0; id < t.edge_count(); ++id) {
            const Row& row = rows[static_cast<std::size_t>(id) + 1];
            ASSERT_EQ(row.size(), 8U);
            const Edge e{id};
            const Halfedge h = halfedge_of(e);
            EXPECT_EQ(row[0], std::to_string(id));
            EXPECT_EQ(row[1], std::to_string(t.origin(h).id));
            EXPECT_EQ(row[2], std::to_string(t.target(h).id));
            EXPECT_EQ(number(row[3]), length(surface.view(), e));
            EXPECT_EQ(number(row[4]), exterior_angle(surface.view(), e));
            EXPECT_EQ(number(row[5]), mean_curvature(surface.view(), e));
            EXPECT_EQ(row[6], name(edge_shape(surface.view(), e)));
            EXPECT_EQ(row[7], name(quadrilateral_type(surface.view(), e)));
        }
    }
}

TEST(SurfaceValues, OfTheCube) {
    const std::vector<Row> vertices = rows_of(written(write_vertices_csv, cube()), ',');
    for (std::size_t v = 1; v < vertices.size(); ++v) {
        EXPECT_NEAR(number(vertices[v][6]), std::numbers::pi / 2, 1e-12);
        EXPECT_EQ(vertices[v][10], "convex");
    }
    int flat = 0;
    const std::vector<Row> edges = rows_of(written(write_edges_csv, cube()), ',');
    for (std::size_t e = 1; e < edges.size(); ++e) {
        flat += edges[e][6] == "flat" ? 1 : 0;
        EXPECT_NEAR(number(edges[e][4]), edges[e][6] == "flat" ? 0 : std::numbers::pi / 2, 1e-12);
        EXPECT_EQ(edges[e][7], edges[e][6] == "flat" ? "none" : edges[e][7]);
    }
    EXPECT_EQ(flat, 6);
}

TEST(SurfaceValues, LengthsBeyondAllNumbersAreInfinite) {
    const Surface huge = moved(cube(), Eigen::Affine3d(Eigen::Scaling(1.7e308)));
    const std::vector<Row> edges = rows_of(written(write_edges_csv, huge), ',');
    for (std::size_t e = 1; e < edges.size(); ++e) {
        EXPECT_EQ(edges[e][3], "inf");
        EXPECT_TRUE(std::isfinite(number(edges[e][4])));
    }
    const Surface tiny = moved(cube(), Eigen::Affine3d(Eigen::Scaling(1e-300)));
    EXPECT_NEAR(number(rows_of(written(write_edges_csv, tiny), ',')[1][3]) / 1e-300, 2, 0.9);
}

TEST(SurfaceValues, ThePlyFileHoldsTheSurfaceAndTheSameNumbers) {
    for (const Surface& surface : samples()) {
        const std::string ply = written(write_ply_with_values, surface);
        const TriangleSoup soup = read_mesh(ply, "values.ply");
        ASSERT_EQ(soup.points.size(), surface.points().size());
        EXPECT_TRUE(std::ranges::equal(soup.points, surface.points()));
        const std::vector<Halfedge> faces = surface.triangulation().faces();
        ASSERT_EQ(soup.triangles.size(), faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            std::size_t corner = 0;
            for (const Vertex v : surface.triangulation().face_corners(faces[f]))
                EXPECT_EQ(soup.triangles[f].at(corner++), v.id);
        }
        const std::vector<Row> table = rows_of(written(write_vertices_csv, surface), ',');
        const std::vector<Row> lines = rows_of(ply.substr(ply.find("end_header\n") + 11), ' ');
        for (std::size_t v = 0; v < surface.points().size(); ++v) {
            const Row& row = lines[v];
            const Row& expected = table[v + 1];
            ASSERT_EQ(row.size(), 9U);
            EXPECT_TRUE(std::equal(row.begin(), row.begin() + 8, expected.begin() + 2));
            EXPECT_EQ(vertex_type_names.at(std::stoul(row[8])), expected[10]);
        }
    }
}

}  // namespace
}  // namespace tightflip::geometry
