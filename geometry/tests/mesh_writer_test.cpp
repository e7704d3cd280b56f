#include "reading.hpp"
#include "written.hpp"

namespace tightflip::geometry {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::array both{MeshEncoding::text, MeshEncoding::binary};

TEST(MeshWriter, KeepsEveryBitOfThePoints) {
    const Surface odd = surface_of_odd_numbers();
    for (const auto encoding : both) {
        for (const auto format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply}) {
            SCOPED_TRACE(name(format));
            expect_same_surface(read_back(written(odd, format, {.encoding = encoding}), format),
                                odd);
        }
    }
}

TEST(MeshWriter, KeepsEverySurfaceOrSaysWhyNot) {
    for (const Triangulation& triangulation : all_families()) {
        const Surface surface = with_random_points(triangulation, 11);
        for (const auto format : {MeshFormat::obj, MeshFormat::off}) {
            SCOPED_TRACE(name(format));
            const auto obstacle = obstacle_to_writing(surface.view(), format, MeshEncoding::text);
            EXPECT_EQ(obstacle.has_value(), has_parallel_edges(triangulation));
            if (!obstacle) {
                expect_same_surface(read_back(written(surface, format), format), surface);
                continue;
            }
            std::ostringstream out;
            EXPECT_THROW(write_mesh(out, surface.view(), format), std::invalid_argument);
            EXPECT_EQ(out.str(), "");
        }
    }
}

TEST(MeshWriter, PlyKeepsParallelEdges) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto genus = static_cast<Index>(seed % 4);
        const Surface surface = with_random_points(
            kernel::families::random(4 + static_cast<Index>(seed) / 2, genus, seed), seed);
        for (const auto encoding : both) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            const std::string bytes = written(surface, MeshFormat::ply, {.encoding = encoding});
            expect_same_surface(read_back(bytes, MeshFormat::ply), surface);
        }
    }
}

// Binary rows are written in blocks of 2^16 bytes.
TEST(MeshWriter, KeepsMoreThanOneBlockOfBytes) {
    const Surface large = with_random_points(kernel::families::icosphere(4), 1);
    const std::string bytes = written(large, MeshFormat::ply, {.encoding = MeshEncoding::binary});
    EXPECT_GT(bytes.size(), std::size_t{1} << 16);
    expect_same_surface(read_back(bytes, MeshFormat::ply), large);
}

TEST(MeshWriter, PlySaysTheGluingOnlyWhereItMust) {
    const Surface simple = regular_tetrahedron();
    const Surface book = with_random_points(kernel::families::book(6), 1);
    const auto header = [](const Surface& surface, const MeshWriteOptions& options) {
        const std::string bytes = written(surface, MeshFormat::ply, options);
        return bytes.substr(0, bytes.find("end_header"));
    };
    const std::string property = "property list uchar int glued_sides\n";
    EXPECT_THAT(header(simple, {}), Not(HasSubstr(property)));
    EXPECT_THAT(header(simple, {.always_glued_sides = true}), HasSubstr(property));
    EXPECT_THAT(header(book, {}), HasSubstr(property));
    expect_same_surface(
        read_back(written(simple, MeshFormat::ply, {.always_glued_sides = true}), MeshFormat::ply),
        simple);
}

/// Sides 0, 1, 2 of a face run from its corners 0, 1, 2; the format is numbered alike.
TEST(MeshWriter, PlyIsAsDocumented) {
    const Surface surface =
        make_surface({{0, 1, 2}, {0, 2, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}});
    EXPECT_EQ(written(surface, MeshFormat::ply,
                      {.encoding = MeshEncoding::text, .always_glued_sides = true}),
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
              "property double z\nelement face 2\nproperty list uchar int vertex_indices\n"
              "property list uchar int glued_sides\nend_header\n"
              "0 0 0\n1 0 0\n0 0.5 0\n3 0 1 2 3 3 5 4\n3 1 0 2 3 0 2 1\n");
}

TEST(MeshWriter, TheOthersAreAsTheirFormatsHaveThem) {
    const Surface surface =
        make_surface({{0, 1, 2}, {0, 2, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}});
    EXPECT_EQ(written(surface, MeshFormat::obj), "v 0 0 0\nv 1 0 0\nv 0 0.5 0\nf 1 2 3\nf 2 1 3\n");
    EXPECT_EQ(written(surface, MeshFormat::off),
              "OFF\n3 2 3\n0 0 0\n1 0 0\n0 0.5 0\n3 0 1 2\n3 1 0 2\n");
    EXPECT_EQ(written(surface, MeshFormat::stl, {.encoding = MeshEncoding::text}),
              "solid tightflip\n"
              "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0.5 0\n"
              "endloop\nendfacet\n"
              "facet normal 0 0 -1\nouter loop\nvertex 1 0 0\nvertex 0 0 0\nvertex 0 0.5 0\n"
              "endloop\nendfacet\nendsolid tightflip\n");
    const std::string binary = written(surface, MeshFormat::stl);
    EXPECT_EQ(binary.size(), 84U + 2 * 50U);
    EXPECT_FALSE(binary.starts_with("solid"));
}

/// The points of each face's corners, as often as they come.
std::vector<std::array<std::array<double, 3>, 3>> corner_points(const Surface& surface) {
    std::vector<std::array<std::array<double, 3>, 3>> faces;
    const Triangulation& t = surface.triangulation();
    for (const Halfedge h : t.faces()) {
        std::array<std::array<double, 3>, 3> corners;
        Halfedge side = h;
        for (auto& corner : corners) {
            const Point& p = surface.point(t.origin(side));
            corner = {p.x(), p.y(), p.z()};
            side = t.next(side);
        }
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        faces.push_back(corners);
    }
    std::ranges::sort(faces);
    return faces;
}

TEST(MeshWriter, StlKeepsTheFacesAtTheirPoints) {
    for (const Triangulation& triangulation : all_families()) {
        if (has_parallel_edges(triangulation)) continue;
        const Surface surface = with_grid_points(triangulation, 3, 500);
        for (const auto encoding : both) {
            const Surface back = read_back(
                written(surface, MeshFormat::stl, {.encoding = encoding}), MeshFormat::stl);
            EXPECT_EQ(corner_points(back), corner_points(surface));
            EXPECT_EQ(back.triangulation().genus(), triangulation.genus());
        }
    }
}

TEST(MeshWriter, TextStlKeepsDoubles) {
    const Surface odd = surface_of_odd_numbers();
    const auto text = written(odd, MeshFormat::stl, {.encoding = MeshEncoding::text});
    EXPECT_EQ(corner_points(read_back(text, MeshFormat::stl)), corner_points(odd));
}

TEST(MeshWriter, RefusalsNameTheVerticesTheReasonAndTheWayOut) {
    struct Case {
        Surface surface;
        MeshFormat format;
        MeshEncoding encoding;
        std::vector<std::string> words;
    };
    const Surface book = with_random_points(kernel::families::book(5), 1);
    const auto tetrahedron = [](const Point& last) {
        return make_surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, last});
    };
    const std::vector<std::string> parallel{"vertices 0 and 1", "which sides", "PLY",
                                            "tightflip-surface"};
    const std::vector<Case> cases{{book, MeshFormat::obj, MeshEncoding::text, parallel},
                                  {book, MeshFormat::off, MeshEncoding::text, parallel},
                                  {book, MeshFormat::stl, MeshEncoding::text, parallel},
                                  {book, MeshFormat::stl, MeshEncoding::binary, parallel},
                                  {tetrahedron({1, 0, -0.0}),
                                   MeshFormat::stl,
                                   MeshEncoding::text,
                                   {"vertices 1 and 3", "one point", "PLY"}},
                                  {tetrahedron({1, 1e-60, 0}),
                                   MeshFormat::stl,
                                   MeshEncoding::binary,
                                   {"vertices 1 and 3", "rounded to float"}},
                                  {tetrahedron({1, 1e60, 0}),
                                   MeshFormat::stl,
                                   MeshEncoding::binary,
                                   {"vertex 3", "float", "as text"}},
                                  {tetrahedron({1, -1e60, 0}),
                                   MeshFormat::stl,
                                   MeshEncoding::binary,
                                   {"vertex 3", "float", "as text"}}};
    for (const Case& c : cases) {
        const auto obstacle = obstacle_to_writing(c.surface.view(), c.format, c.encoding);
        ASSERT_TRUE(obstacle.has_value()) << c.words[0];
        for (const std::string& word : c.words)
            EXPECT_THAT(*obstacle, HasSubstr(word));
    }
    EXPECT_FALSE(obstacle_to_writing(tetrahedron({1, 1e-60, 0}).view(), MeshFormat::stl,
                                     MeshEncoding::text));
}

}  // namespace
}  // namespace tightflip::geometry
