#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip_graph_dot.hpp>

#include <regex>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ClassGraph graph_of_five() {
    const Triangulation start = families::book(5);
    return explore_classes(std::span(&start, 1), {});
}

std::string drawn(const ClassGraph& graph, const Eccentricities* eccentricities = nullptr) {
    std::ostringstream out;
    write_dot(out, graph, eccentricities);
    return out.str();
}

TEST(WriteDot, HasANodeAClassAndAnEdgeAPairOfNeighbours) {
    const ClassGraph graph = graph_of_five();
    const std::string text = drawn(graph);
    const std::regex node(R"(    (\d+) \[label="\d+\\n[\d ]+"\];)");
    const std::regex edge(R"(    (\d+) -- (\d+)( \[label="\d+:\d+"\])?;)");
    std::size_t nodes = 0;
    std::set<std::pair<std::size_t, std::size_t>> edges;
    std::istringstream lines(text);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, node)) ++nodes;
        if (std::regex_match(line, match, edge)) {
            EXPECT_TRUE(edges.emplace(std::stoul(match[1]), std::stoul(match[2])).second);
        }
    }
    std::set<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t i = 0; i < graph.size(); ++i) {
        for (const std::size_t j : graph.arcs.row(i)) {
            expected.emplace(std::min(i, j), std::max(i, j));
        }
    }
    EXPECT_EQ(nodes, graph.size());
    EXPECT_EQ(edges, expected);
    EXPECT_TRUE(text.starts_with("graph flips {\n"));
    EXPECT_TRUE(text.ends_with("}\n"));
}

TEST(WriteDot, NamesDegrees) {
    EXPECT_THAT(drawn(graph_of_five()), HasSubstr("\\n3 3 4 4 4\""));
    EXPECT_THAT(drawn(graph_of_five()), HasSubstr("\\n2 2 2 6 6\""));
}

TEST(WriteDot, FillsPeripheralClasses) {
    const ClassGraph graph = graph_of_five();
    Eccentricities known;
    known.lower = {1, 2, 2, 1};
    known.diameter = 2;
    const std::string text = drawn(graph, &known);
    EXPECT_THAT(text, ::testing::ContainsRegex("    1 [^\n]*style=filled"));
    EXPECT_THAT(text, ::testing::ContainsRegex("    2 [^\n]*style=filled"));
    EXPECT_THAT(text, Not(::testing::ContainsRegex("    [03] [^\n]*style=filled")));
}

}  // namespace
}  // namespace tightflip::kernel
