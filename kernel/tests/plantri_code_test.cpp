#include "refusals.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/plantri_code.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using enum PlantriFormat;
using ::testing::HasSubstr;
using testing::octahedron_faces;
using testing::refusal_of;

std::string bytes(std::initializer_list<int> values) {
    std::string text;
    for (const int value : values)
        text.push_back(static_cast<char>(value));
    return text;
}

std::vector<Triangulation> read_all(const std::string& text, PlantriFormat headerless) {
    std::istringstream in(text);
    PlantriReader reader(in, "graphs.bin", headerless);
    std::vector<Triangulation> graphs;
    while (auto graph = reader.next())
        graphs.push_back(*std::move(graph));
    return graphs;
}

Triangulation read_one(const std::string& text, PlantriFormat headerless = planar_code) {
    std::vector<Triangulation> graphs = read_all(text, headerless);
    if (graphs.size() != 1) throw std::logic_error("expected one graph");
    return std::move(graphs.front());
}

std::string written(const std::vector<Triangulation>& surfaces, PlantriFormat format) {
    std::ostringstream out;
    PlantriWriter writer(out, "graphs.bin", format);
    for (const Triangulation& surface : surfaces)
        writer.write(surface);
    writer.finish();
    return out.str();
}

std::string_view header_of(PlantriFormat format) {
    return format == planar_code ? ">>planar_code<<" : ">>edge_code<<";
}

std::string without_header(const std::string& text) {
    return text.substr(text.find("<<") + 2);
}

Triangulation surface_of(const testing::FaceList& faces, Index vertices) {
    return build(faces, vertices).value();
}

/// Equal as labelled surfaces by the map that keeps edge numbers and origins.
void expect_same_edges(const Triangulation& a, const Triangulation& b) {
    ASSERT_EQ(a.vertex_count(), b.vertex_count());
    ASSERT_EQ(a.edge_count(), b.edge_count());
    const auto counterpart = [&](Halfedge h) {
        const Halfedge even = halfedge_of(edge_of(h));
        return b.origin(even) == a.origin(h) ? even : twin(even);
    };
    for (Index id = 0; id < a.halfedge_count(); ++id) {
        const Halfedge h{id};
        ASSERT_EQ(b.origin(counterpart(h)), a.origin(h)) << "halfedge " << id;
        ASSERT_EQ(b.next(counterpart(h)), counterpart(a.next(h))) << "halfedge " << id;
    }
}

// ---- bytes written by hand from the definition of the formats ----

// Clockwise about vertex 1: 2, 3, 4; so counter-clockwise faces hold 1 3 2, 1 4 3 and 1 2 4.
const std::string tetrahedron_planar = bytes({4, 2, 3, 4, 0, 1, 4, 3, 0, 1, 2, 4, 0, 1, 3, 2, 0});
// Edges 12, 13, 14, 23, 34, 24 have the numbers 0 to 5.
const std::string tetrahedron_edges =
    bytes({15, 0, 1, 2, 255, 0, 5, 3, 255, 1, 3, 4, 255, 2, 4, 5});
Triangulation tetrahedron() {
    return surface_of({{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}, 4);
}

// Poles 1 (above) and 6 (below); the rim 2 3 4 5 runs counter-clockwise seen from above.
const std::string octahedron_planar = bytes({6, 5, 4, 3, 2, 0, 1, 3, 6, 5, 0, 1, 4, 6, 2, 0,  //
                                             1, 5, 6, 3, 0, 1, 2, 6, 4, 0, 2, 3, 4, 5, 0});
// Edges from pole 1: 0 to 3; of the rim: 4 to 7; from pole 6: 8 to 11.
const std::string octahedron_edges = bytes({29,  3, 2, 1,  0, 255, 0, 4, 8,  7, 255, 1, 5, 9,  4,
                                            255, 2, 6, 10, 5, 255, 3, 7, 11, 6, 255, 8, 9, 10, 11});
Triangulation octahedron() {
    return surface_of(octahedron_faces(), 6);
}

// Poles 0 and 1 joined by the edges 0 and 1, the pages' vertices 2 and 3 between them.
const std::string book_edges = bytes({15, 0, 2, 1, 3, 255, 0, 5, 1, 4, 255, 2, 4, 255, 3, 5});

TEST(PlantriReader, ReadsPlanarCodeWrittenByHandInTheRightOrientation) {
    EXPECT_TRUE(same_labelled_surface(read_one(tetrahedron_planar), tetrahedron()));
    EXPECT_TRUE(same_labelled_surface(read_one(octahedron_planar), octahedron()));
    EXPECT_TRUE(
        same_labelled_surface(read_one(">>planar_code<<" + octahedron_planar), octahedron()));
}

TEST(PlantriReader, ReadsEdgeCodeWrittenByHandAndKeepsTheEdgeNumbers) {
    const Triangulation octa = read_one(">>edge_code<<" + octahedron_edges);
    EXPECT_TRUE(same_labelled_surface(octa, octahedron()));
    const std::array<std::pair<Index, Index>, 12> ends{{{0, 1},
                                                        {0, 2},
                                                        {0, 3},
                                                        {0, 4},
                                                        {1, 2},
                                                        {2, 3},
                                                        {3, 4},
                                                        {1, 4},
                                                        {1, 5},
                                                        {2, 5},
                                                        {3, 5},
                                                        {4, 5}}};
    for (Index e = 0; e < 12; ++e) {
        const Halfedge h = halfedge_of(Edge{e});
        const std::pair joined(std::min(octa.origin(h).id, octa.target(h).id),
                               std::max(octa.origin(h).id, octa.target(h).id));
        EXPECT_EQ(joined, ends[static_cast<std::size_t>(e)]) << "edge " << e;
    }
    EXPECT_TRUE(same_labelled_surface(read_one(tetrahedron_edges, edge_code), tetrahedron()));
    EXPECT_TRUE(same_labelled_surface(read_one(book_edges, edge_code), families::book(4)));
}

TEST(PlantriReader, ReadsPlanarCodeWithTwoByteEntriesInTheOrderOfTheHeader) {
    std::string big(1, '\0');
    std::string little(1, '\0');
    for (const char entry : octahedron_planar) {
        big += std::string{'\0', entry};
        little += std::string{entry, '\0'};
    }
    for (const std::string& text :
         {big, ">>planar_code<<" + big, ">>planar_code be<<" + big, ">>planar_code le<<" + little,
          ">>planar_code be<<" + octahedron_planar}) {
        EXPECT_TRUE(same_labelled_surface(read_one(text), octahedron()));
    }
    EXPECT_THROW(read_one(">>planar_code<<" + little), FileError);
    EXPECT_THROW(read_one(">>planar_code le<<" + big), FileError);
}

TEST(PlantriReader, ReadsEdgeCodeWithLongLengthsAndWideEdgeNumbers) {
    const std::string body = tetrahedron_edges.substr(1);
    std::string wide;
    for (const char byte : body) {
        wide += byte == '\xff' ? std::string{byte} : std::string{'\0', '\0', byte};
    }
    ASSERT_EQ(wide.size(), 39U);
    for (const std::string& text : {bytes({0, 0x11, 15}) + body, bytes({0, 0x31, 0, 0, 15}) + body,
                                    bytes({0, 0x23, 0, 39}) + wide}) {
        EXPECT_TRUE(same_labelled_surface(read_one(text, edge_code), tetrahedron()));
    }
}

TEST(PlantriReader, ReadsManyGraphsAndFilesThatWereJoined) {
    EXPECT_TRUE(read_all("", planar_code).empty());
    EXPECT_TRUE(read_all(">>edge_code<<", planar_code).empty());
    const auto graphs =
        read_all(">>planar_code<<" + tetrahedron_planar + octahedron_planar + ">>edge_code<<" +
                     book_edges + tetrahedron_edges + ">>planar_code le<<" + octahedron_planar,
                 planar_code);
    ASSERT_EQ(graphs.size(), 5U);
    EXPECT_TRUE(same_labelled_surface(graphs[0], tetrahedron()));
    EXPECT_TRUE(same_labelled_surface(graphs[1], octahedron()));
    EXPECT_TRUE(same_labelled_surface(graphs[2], families::book(4)));
    EXPECT_TRUE(same_labelled_surface(graphs[3], tetrahedron()));
    EXPECT_TRUE(same_labelled_surface(graphs[4], octahedron()));
}

TEST(PlantriReader, IsNotMisledByAGraphThatBeginsLikeAHeader) {
    const Triangulation surface = families::double_wheel(62);  // vertices 1 and 62 are joined
    std::string record = without_header(written({surface}, planar_code));
    const auto list_end = record.begin() + 1 + 60;
    std::rotate(record.begin() + 1, std::find(record.begin() + 1, list_end, '>'), list_end);
    ASSERT_THAT(record, ::testing::StartsWith(">>"));
    EXPECT_TRUE(same_labelled_surface(read_one(record), surface));
}

TEST(PlantriWriter, WritesExactlyTheFormat) {
    // A list may begin anywhere; the numbers of edges and where lists begin are the reader's own.
    const Triangulation surface = read_one(tetrahedron_edges, edge_code);
    const std::string text = written({surface, surface}, edge_code);
    EXPECT_EQ(text, ">>edge_code<<" + tetrahedron_edges + tetrahedron_edges);
    const Triangulation planar = read_one(tetrahedron_planar);
    EXPECT_EQ(written({planar}, planar_code), ">>planar_code<<" + tetrahedron_planar);
    EXPECT_EQ(written({}, planar_code), ">>planar_code<<");
    EXPECT_EQ(written({}, edge_code), ">>edge_code<<");
}

TEST(PlantriWriter, UsesTheLongFormsExactlyWhereTheShortOnesEnd) {
    const auto start = [](Index vertices, PlantriFormat format) {
        return written({families::stacked(vertices, 1)}, format)
            .substr(header_of(format).size(), 2);
    };
    EXPECT_EQ(start(255, planar_code)[0], '\xff');
    EXPECT_THAT(written({families::stacked(256, 1)}, planar_code),
                ::testing::StartsWith(">>planar_code be<<" + bytes({0, 1, 0})));
    EXPECT_EQ(start(38, edge_code)[0], '\xfd');            // 2 * 108 + 37 = 253 bytes
    EXPECT_EQ(start(39, edge_code), bytes({0, 0x21}));     // 260 bytes
    EXPECT_EQ(start(87, edge_code), bytes({0, 0x21}));     // last edge 254
    EXPECT_EQ(start(88, edge_code), bytes({0, 0x22}));     // last edge 257
    EXPECT_EQ(start(21762, edge_code), bytes({0, 0x32}));  // last edge 0xfeff
    EXPECT_EQ(start(21763, edge_code), bytes({0, 0x33}));  // last edge 0xff02
}

// ---- round trips ----

std::vector<Triangulation> simple_surfaces() {
    return {families::tetrahedron(),
            families::double_wheel(20),
            families::icosphere(1),
            families::stacked(40, 3),
            families::torus_grid(5, 7),
            families::book(3),
            families::stacked(255, 4),
            families::stacked(256, 5),
            families::stacked(1000, 6),
            families::torus_grid(20, 30),
            families::surface_of_genus(2, 60, 7)};
}

std::vector<Triangulation> multigraph_surfaces() {
    std::vector<Triangulation> surfaces{families::book(4), families::book(60), families::book(400)};
    for (const Index genus : {0, 1, 2}) {
        for (const Index vertices : {4, 5, 12, 37, 38, 39, 40, 86, 87, 88, 300}) {
            surfaces.push_back(families::random(vertices, genus, 17));
        }
    }
    surfaces.push_back(families::random(3, 2, 5));
    surfaces.push_back(families::random(22000, 0, 5));
    return surfaces;
}

TEST(PlantriCode, PlanarCodeKeepsSimpleLabelledSurfacesOfAnyGenus) {
    const std::vector<Triangulation> surfaces = simple_surfaces();
    const auto graphs = read_all(written(surfaces, planar_code), edge_code);
    ASSERT_EQ(graphs.size(), surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        EXPECT_TRUE(same_labelled_surface(graphs[i], surfaces[i])) << "surface " << i;
    }
}

TEST(PlantriCode, EdgeCodeKeepsLabelledSurfacesAndTheirEdgeNumbers) {
    for (const auto& surfaces : {simple_surfaces(), multigraph_surfaces()}) {
        const std::string text = written(surfaces, edge_code);
        const auto graphs = read_all(text, planar_code);
        ASSERT_EQ(graphs.size(), surfaces.size());
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            EXPECT_TRUE(same_labelled_surface(graphs[i], surfaces[i])) << "surface " << i;
            expect_same_edges(surfaces[i], graphs[i]);
        }
    }
}

TEST(PlantriCode, SurvivesFlipsThatMakeOutgoingHalfedgesOddAndLabelsMove) {
    Triangulation surface = families::stacked(25, 8);
    RandomStream random(31);
    for (int run = 0; run < 300; ++run) {
        const auto edges = static_cast<std::uint32_t>(surface.edge_count());
        static_cast<void>(surface.flip(Edge{static_cast<Index>(random.below(edges))}));
        const Triangulation copy = read_one(written({surface}, edge_code));
        ASSERT_TRUE(same_labelled_surface(copy, surface));
        expect_same_edges(surface, copy);
    }
}

// ---- what cannot be written ----

TEST(PlantriWriter, RefusesParallelEdgesInPlanarCodeNamesThemAndWritesNothing) {
    std::ostringstream out;
    PlantriWriter writer(out, "graphs.pc", planar_code);
    writer.write(tetrahedron());
    const std::string before = out.str();
    const std::optional<FileError> error = refusal_of([&] { writer.write(families::book(5)); });
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->source(), "graphs.pc");
    EXPECT_THAT(error->reason(),
                HasSubstr("graph 2: more than one edge joins the vertices 0 and 1"));
    EXPECT_EQ(out.str(), before);
}

TEST(PlantriWriter, RefusesMoreVerticesThanPlanarCodeCounts) {
    const Triangulation most = families::stacked(65535, 1);
    EXPECT_TRUE(same_labelled_surface(read_one(written({most}, planar_code)), most));
    std::ostringstream out;
    PlantriWriter writer(out, "graphs.pc", planar_code);
    const std::optional<FileError> error =
        refusal_of([&] { writer.write(families::stacked(65536, 1)); });
    ASSERT_TRUE(error.has_value());
    EXPECT_THAT(error->reason(), HasSubstr("65536 vertices"));
    EXPECT_EQ(out.str(), "");
}

TEST(PlantriWriter, ReportsAStreamThatFails) {
    struct FullDevice : std::streambuf {  // takes nothing
    } device;
    std::ostream out(&device);
    PlantriWriter writer(out, "full.pc", edge_code);
    EXPECT_THAT(refusal_of([&] { writer.write(tetrahedron()); }).value().what(),
                ::testing::StrEq("full.pc: writing failed"));
    EXPECT_THROW(writer.finish(), FileError);
}

// ---- what cannot be read ----

struct BadInput {
    const char* what;
    PlantriFormat format;
    std::string text;
    std::uint64_t position;
    const char* reason;
};

const std::vector<BadInput>& bad_inputs() {
    static const std::vector<BadInput> inputs{
        {"foreign header", planar_code, ">>graph6<<:An", 0, "the header is none of"},
        {"unfinished header", planar_code, ">>planar_co", 0, "the header is none of"},
        {"header in disguise", edge_code, ">>planar_code me<<x", 0, "the header is none of"},
        {"text", planar_code, "solid cube\n", 7,
         "graph 1: list 1 names vertex 117, but there are only 115"},
        {"no vertices", planar_code, bytes({0, 0, 0}), 0, "graph 1: it has no vertices"},
        {"one vertex", planar_code, bytes({1, 0}), 0, "graph 1: it has more vertices"},
        {"neighbour out of range", planar_code, bytes({4, 2, 3, 5, 0}), 3,
         "graph 1: list 1 names vertex 5, but there are only 4"},
        {"wide neighbour out of range", planar_code,
         ">>planar_code be<<" + bytes({0, 0, 4, 0, 2, 1, 3}), 23, "list 1 names vertex 259"},
        {"loop", planar_code, bytes({4, 2, 3, 4, 0, 1, 2, 3, 0}), 6,
         "graph 1: list 2 names its own vertex"},
        {"neighbour twice", planar_code, bytes({4, 2, 3, 2, 0, 1, 4, 3, 0, 1, 2, 4, 0, 1, 3, 2, 0}),
         3, "graph 1: list 1 names vertex 2 again"},
        {"neighbour twice, both ways", planar_code, bytes({3, 2, 2, 3, 0, 1, 1, 3, 0, 1, 2, 0}), 2,
         "graph 1: list 1 names vertex 2 again"},
        {"neighbour not symmetric", planar_code, bytes({3, 2, 3, 0, 1, 0, 1, 2, 0}), 7,
         "graph 1: list 3 names vertex 2, whose list does not name it"},
        {"second graph damaged", planar_code, tetrahedron_planar + bytes({4, 2, 3, 4, 0, 1, 4, 9}),
         24, "graph 2: list 2 names vertex 9"},
        {"a quadrilateral", planar_code, bytes({4, 2, 4, 0, 1, 3, 0, 2, 4, 0, 3, 1, 0}), 0,
         "graph 1: it is no triangulated"},
        {"two tetrahedra", planar_code, bytes({8, 2, 3, 4, 0, 1, 4, 3, 0, 1, 2, 4, 0, 1, 3, 2, 0,
                                               6, 7, 8, 0, 5, 8, 7, 0, 5, 6, 8, 0, 5, 7, 6, 0}),
         0, "graph 1: it is no triangulated"},
        {"a vertex without neighbours", planar_code, bytes({4, 2, 3, 0, 1, 3, 0, 1, 2, 0, 0}), 0,
         "graph 1: it is no triangulated"},
        {"edge number out of range", edge_code,
         bytes({15, 0, 1, 2, 255, 0, 5, 3, 255, 1, 3, 4, 255, 2, 4, 6}), 15,
         "graph 1: list 4 names edge 6, but 12 ends leave only edges 0 to 5"},
        {"edge three times", edge_code,
         bytes({15, 0, 1, 2, 255, 0, 5, 3, 255, 1, 3, 0, 255, 2, 4, 5}), 11,
         "graph 1: list 3 names edge 0, which was named twice already"},
        {"edge once", edge_code, bytes({14, 0, 1, 2, 255, 0, 5, 3, 255, 1, 3, 4, 255, 2, 4}), 0,
         "graph 1: edge 5 is named only once"},
        {"loop in edge code", edge_code, bytes({5, 0, 1, 0, 255, 1}), 3,
         "graph 1: list 1 names edge 0 twice: a loop"},
        {"empty body", edge_code, bytes({0, 0x11, 0}), 0, "graph 1: it is empty"},
        {"no bytes for the length", edge_code, bytes({0, 0x01, 1}), 0, "graph 1: it is empty"},
        {"no bytes for an edge", edge_code, bytes({0, 0x10, 1, 0}), 1, "no bytes"},
        {"length beyond all files", edge_code,
         bytes(
             {0, 0xf1, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255}),
         0, "beyond all files"},
        {"length beyond this file", edge_code, bytes({0, 0x61, 255, 255, 255, 255, 255, 255, 0, 1}),
         10, "the file ends inside it"},
        {"number reaches beyond the body", edge_code, bytes({0, 0x12, 3, 0, 0, 0, 1}), 5,
         "an edge number reaches beyond its end"},
        {"number too large for any surface", edge_code, bytes({0, 0x15, 5, 1, 0, 0, 0, 0}), 3,
         "too large for any surface"},
        {"only separators", edge_code, bytes({3, 255, 255, 255}), 0, "more vertices than ends"},
        {"a list without edges", edge_code,
         bytes({16, 0, 1, 2, 255, 0, 5, 3, 255, 1, 3, 4, 255, 2, 4, 5, 255}), 0,
         "graph 1: it is no triangulated"},
    };
    return inputs;
}

TEST(PlantriReader, RefusesBadInputWithTheByteAndTheGraph) {
    for (const BadInput& input : bad_inputs()) {
        SCOPED_TRACE(input.what);
        const std::optional<FileError> error =
            refusal_of([&] { read_all(input.text, input.format); });
        ASSERT_TRUE(error.has_value());
        EXPECT_EQ(error->source(), "graphs.bin");
        EXPECT_EQ(error->unit(), FileError::Unit::byte);
        EXPECT_EQ(error->position(), input.position) << error->what();
        EXPECT_THAT(error->reason(), HasSubstr(input.reason));
    }
}

TEST(PlantriReader, ReportsAStreamThatCannotBeRead) {
    std::ifstream missing("no-such-folder/no-such-file.pc");
    EXPECT_THAT(
        refusal_of([&] { return PlantriReader(missing, "missing.pc").next(); }).value().what(),
        ::testing::StrEq("missing.pc: byte 0: reading failed"));
    std::ifstream folder(".");
    EXPECT_TRUE(refusal_of([&] { return PlantriReader(folder, "folder").next(); }).has_value());
}

TEST(PlantriReader, AnyPrefixGivesWholeGraphsAndThenAnErrorUnlessItEndsBetweenTwo) {
    const std::vector<Triangulation> surfaces{tetrahedron(), families::stacked(9, 1),
                                              families::torus_grid(3, 4),
                                              families::stacked(260, 2)};
    for (const PlantriFormat format : {planar_code, edge_code}) {
        std::vector<std::size_t> ends{0, header_of(format).size()};  // where a prefix is whole
        for (std::size_t n = 1; n <= surfaces.size(); ++n) {
            ends.push_back(
                written({surfaces.begin(), surfaces.begin() + static_cast<std::ptrdiff_t>(n)},
                        format)
                    .size());
        }
        const std::string text = written(surfaces, format);
        for (std::size_t size = 0; size <= text.size(); ++size) {
            std::istringstream in(text.substr(0, size));
            PlantriReader reader(in, "prefix", format);
            std::size_t graphs = 0;
            bool ended_well = true;
            try {
                while (auto graph = reader.next()) {
                    ASSERT_LT(graphs, surfaces.size());
                    ASSERT_TRUE(same_labelled_surface(*graph, surfaces[graphs++]));
                }
            } catch (const FileError&) {
                ended_well = false;
            }
            ASSERT_EQ(ended_well, std::ranges::count(ends, size) == 1) << "size " << size;
            const auto whole = std::ranges::count_if(ends, [&](auto end) { return end <= size; });
            ASSERT_EQ(graphs, static_cast<std::size_t>(std::max<std::ptrdiff_t>(whole - 2, 0)));
        }
    }
}

TEST(PlantriReader, DamagedBytesGiveValidSurfacesOrAFileErrorAndNothingElse) {
    RandomStream random(7);
    int valid = 0;
    int refused = 0;
    const auto read_damaged = [&](const std::string& text, PlantriFormat format) {
        std::istringstream in(text);
        PlantriReader reader(in, "damaged", format);
        try {
            while (const auto graph = reader.next()) {
                ASSERT_TRUE(audit(*graph).is_valid());
                ++valid;
            }
        } catch (const FileError& error) {
            ASSERT_LE(error.position(), text.size());
            ++refused;
        }
    };
    const auto below = [&](std::size_t bound) {
        return random.below(static_cast<std::uint32_t>(bound));
    };
    for (const PlantriFormat format : {planar_code, edge_code}) {
        const std::string text = written({tetrahedron(), octahedron(), families::torus_grid(3, 3),
                                          families::stacked(50, 9), families::stacked(257, 3)},
                                         format);
        for (int run = 0; run < 1500; ++run) {
            std::string damaged = text;
            for (std::size_t hits = 1 + below(3); hits > 0; --hits) {
                const std::size_t place = below(run % 2 == 0 ? 120 : damaged.size());
                damaged[place] = static_cast<char>(below(256));
            }
            read_damaged(damaged, format);
        }
        for (int run = 0; run < 3000; ++run) {
            std::string noise(below(60), '\0');
            for (char& byte : noise)
                byte = static_cast<char>(below(run % 2 == 0 ? 256 : 7));
            read_damaged(noise, format);
        }
    }
    EXPECT_GT(valid, 1000);
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace tightflip::kernel
